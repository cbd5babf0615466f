// Changes of a file's text that touch only the bytes they must: comments, order, quotes, spacing and line
// ends stay. Each takes a whole text and gives a new one that differs in one range. What was asked is read
// back from it; whatever cannot be done so is refused: InputError, in words.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "config/areas.hpp"

namespace mien {

struct Language;

// From the top of the file: keys of mappings, and items of lists, counted from 0.
using PathStep = std::variant<std::string, std::size_t>;
using YamlPath = std::vector<PathStep>;

// The value at `path` becomes `value`, YAML of one line: a word, a number, a text in quotes, or a list or
// mapping in brackets. What is missing on the way is added as its neighbours are written, a section of the
// file where files have it; a word that stands for a mapping (`age: child`) becomes one, where the language
// has that. An item may be added right behind a list's last.
std::string set_value(const std::string& text, const YamlPath& path, const std::string& value);

// Without the value at `path` and its key; a mapping or list that would be empty goes too.
std::string remove_value(const std::string& text, const YamlPath& path);

// A key of the face.
struct KeyEdit {
  std::string actor;  // whose clip; empty: the file's own, or that of its only actor
  double at_s = 0;    // of the clip
  int fps = 24;
  Pose pose;  // that the key comes to, to a thousandth of a limit
};

// A key in `clip.keys`, in the order of time and written as its neighbours, at the frame nearest to `at_s`.
// One that stands there already keeps its time and its ways, and its `express` if that says most of the pose.
std::string write_key(const std::string& text, const KeyEdit& edit, const Language& language);

// An expression of the file's own; one of that name is replaced.
std::string write_expression(const std::string& text, const std::string& name, const Pose& pose);

// What stands there: "{brows: {up: 0.5}, lips: {press: 0.2}}".
std::string format_expression(const Pose& pose);

// Another time of a key, a cue or a blink.
struct TimeMove {
  int line = 0, column = 0;  // in it, as Place has them
  std::string member;        // "at", "from", "to"
  double to_s = 0;           // of the clip; moved to the nearest frame
  int fps = 24;
};

// The time in its own notation (1.5s, 36f, 500ms, 1.5). An item of a list whose times must rise goes to its
// new place among the others.
std::string move_time(const std::string& text, const TimeMove& move);

}  // namespace mien

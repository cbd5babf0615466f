// The YAML language, declared once: every mapping with its keys, and of each key what may stand there, in
// which range, what holds without it, and one line of help. The loaders take their keys, words and ranges
// from this table by the value they read (yaml_reader.hpp); the JSON Schema (schema.hpp) and
// docs/reference.md (reference.hpp) are written from it. A new key is a row here and the line of a loader
// that reads it.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "config/words.hpp"

namespace mien {

// What may stand for a value. Ranges are those of `low` and `high`.
enum class FormKind {
  version,      // kLanguageVersion
  word,         // one of `words`, or of the data's list `data`
  yes_no,       // true or false
  number,       // a plain number
  whole,        // one without a fraction
  formula,      // a text in quotes where a number could stand (formula.hpp)
  time,         // a moment of the clip: 1.5s, 36f, 500ms
  duration,     // a length of time, in the same units; below 0: earlier
  seconds,      // the same of what has no frames
  length,       // mm
  angle,        // deg
  lengths,      // three lengths x y z, each in the range, mm
  two_lengths,  // 6x2mm
  size,         // 480x600, each side in the range, px
  colour,       // "#dcae8f"
  line,         // one line of text of at most `high` bytes
  tag,          // a name of the author's own that fits `pattern`, or one of the data's list `data`
  file,         // a file's name that ends in one of `endings`
  curve,        // four numbers x1 y1 x2 y2: x from 0 to 1, y in the range
  list,         // of `items`, from `low` to `high` of them
  map,      // names to `items`, at least `low` of them: `words`, the data's list `data`, or fitting `pattern`
  section,  // a mapping whose keys are the section's
};

struct Section;
struct Form;
using Forms = std::vector<Form>;  // any one of them

struct Form {
  FormKind kind = FormKind::word;
  double low = 0, high = std::numeric_limits<double>::infinity();
  bool is_above_low = false;  // `low` itself is out of the range
  std::string noun = {};      // what messages call a word ("age"), or count ("blinks a minute")
  std::vector<Word> words = {};
  std::string data = {};     // a list of data_words.hpp
  std::string pattern = {};  // an ECMAScript expression for the whole name
  Names endings = {};
  Forms items = {};
  const Section* section = nullptr;
  Names excluded = {};  // keys of the section that do not stand here
};

struct Key {
  std::string name;
  Forms forms;
  std::string help;
  std::string otherwise = {};  // the value that holds without it; empty: none, or `help` says
  bool is_required = false;
};

// What keys of one mapping have to do with each other. The loaders say it in words of their own.
struct KeyRule {
  enum class Kind {
    apart,   // the first key stands beside none of the others; "clip.keys" is one of `clip`
    needs,   // the first key stands beside one of the others
    one_of,  // one of them at least stands there
  } kind;
  Names keys;
};

struct Section {
  std::string name;       // "camera_key", as the schema's definition and the manual's heading
  std::string help;       // what it is
  std::string expected;   // what a message asks for: "a mapping such as {age: adult}"
  std::vector<Key> keys;  // in the order in which messages tell them
  std::string noun = "key";
  std::vector<KeyRule> rules = {};
};

// All mappings of the language. The order is the manual's.
struct Sections {
  Section file, library_file;
  Section head, guides, look, sculpt, limits;
  Section areas, live_areas;                             // areas of a pose; in a clip with formulas
  std::array<Section, kAreas.size()> moves, live_moves;  // of an area
  Section muscles, live_muscles, candide, live_candide, parke, conformation;
  Section expression, dominance, growth;
  Section clip, pose_key, release, camera_key, turn_key, head_key, light_key, background_key, draw_change;
  Section input, input_point;  // of `inputs`
  Section lead, wait, cue, law, track, include, script;
  Section blink, gaze, gaze_key, direction, drift, asymmetry, sound, say;
  Section actor, place, place_key, render, ink, bust, bust_set;

  Sections();  // fills them; forms point at sections of the same object
  Sections(const Sections&) = delete;
  Sections& operator=(const Sections&) = delete;
};

// The only one, built once.
const Sections& find_sections();

// All of them, in the manual's order.
std::vector<const Section*> list_sections();

Names list_keys(const Section& section);
const Key* find_key(const Section& section, std::string_view name);
const Form* find_form(const Forms& forms, FormKind kind);

// Lengths of names, in letters or bytes.
inline constexpr std::size_t kMaxTitleLength = 200;    // bytes; it is shown in one line
inline constexpr std::size_t kMaxLabelLength = 200;    // bytes; far more than any base has room for
inline constexpr std::size_t kMaxSaidLength = 2000;    // bytes; some two minutes
inline constexpr std::size_t kMaxKeyName = 40;         // a name is a word, not a sentence
inline constexpr std::size_t kMaxActorName = 12;       // POV-Ray's words end after 40
inline constexpr std::size_t kMaxExpressionName = 64;  // names become file names

inline constexpr std::size_t kMaxFormulaLength = 1000;  // bytes; a longer one is no director's note

inline const Names kYamlEndings{".yaml", ".yml"};

// Keys of the `clip` at the top of a file with actors; the others stand in each actor's own.
inline const Names kSharedClipKeys{"fps", "draw", "length", "camera", "light", "background", "sound"};

// And those that stand in both: of everybody, and of an actor.
inline const Names kCommonClipKeys{"inputs", "laws"};

}  // namespace mien

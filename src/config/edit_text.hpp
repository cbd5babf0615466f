// A YAML text and where each of its values begins and ends: what edits (edit.hpp) are made of.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "config/edit.hpp"
#include "config/scan.hpp"

namespace mien {

// Bytes of the document's text, whose lines end with '\n'.
struct Range {
  std::size_t begin = 0, end = 0;
};

struct EditText {
  std::string bytes;  // as they were given
  YamlDocument document;
  std::vector<Range> ranges;  // of each node, without its anchor; of an absent one empty, where it would be
  std::set<std::uint32_t> repeated;  // nodes that an alias stands for
  bool is_empty = false;             // nothing but comments: there are no nodes
};

// Throws InputError if the text is no YAML or is not to be taken for a file of ours.
EditText open_text(const std::string& bytes);

// Whether a list or mapping stands in brackets.
bool is_in_brackets(const EditText& text, std::uint32_t node);
// Whether a value of nothing is not even written out as '~' or null.
bool is_absent(const EditText& text, std::uint32_t node);

// The entries of a list or mapping: from its item, or its key, to the end of its value.
std::size_t count_entries(const EditText& text, std::uint32_t node);
Range find_entry(const EditText& text, std::uint32_t node, std::size_t entry);
// The node of its value.
std::uint32_t find_entry_value(const EditText& text, std::uint32_t node, std::size_t entry);
// The '-' of an item of a list that is not in brackets.
std::size_t find_item_dash(const EditText& text, std::uint32_t list, std::size_t entry);

// How far a path leads into the text.
struct Trail {
  std::vector<std::uint32_t> nodes;  // the file's own, then one for each step that there is
  std::vector<std::size_t> entries;  // which entry of the node before each of them is
  bool is_in_brackets = false;       // where the last one stands
};
// Throws InputError where an alias is in the way, or where a value on the way is what an alias repeats.
Trail find_trail(const EditText& text, const YamlPath& path);

// Throws InputError if an alias elsewhere stands for something in the range.
void check_unrepeated(const EditText& text, Range range, const YamlPath& path);

// Lines of the text.
std::size_t find_line_begin(const EditText& text, std::size_t at);
std::size_t find_line_end(const EditText& text, std::size_t at);  // where its '\n' is, or the text ends
bool is_first_of_line(const EditText& text, std::size_t at);      // but for spaces
int find_column(const EditText& text, std::size_t at);            // from 0, in bytes
// Where the rest of a line has no more than spaces and a comment.
bool is_rest_comment(const EditText& text, std::size_t at);
// The first byte from there on that is neither space nor comment, over lines.
std::size_t skip_blanks(const EditText& text, std::size_t at);

// The bytes with a range of the document's text replaced; lines of `words` get the text's own ends.
std::string replace_range(const EditText& text, Range range, const std::string& words);

// "'clip.keys[2].strength'".
std::string describe_path(const YamlPath& path, std::size_t steps);
std::string describe_path(const YamlPath& path);

}  // namespace mien

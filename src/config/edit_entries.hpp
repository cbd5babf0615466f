// One entry of a list or mapping put in, taken out, or given another value, in the style that surrounds it.
#pragma once

#include <string>
#include <vector>

#include "config/edit_text.hpp"

namespace mien {

// A range of the text and what comes in its place.
struct Splice {
  Range range;
  std::string words;
};

// A new entry: `key: value`, or an item without its '-'.
struct EntryWords {
  std::string flow;                // on one line, as in brackets
  std::vector<std::string> block;  // in lines of their own, from the entry's own column; empty: as `flow`
};

// Columns of one step of indentation, as the text has them.
int find_indent_step(const EditText& text);

// Before the entry with that number, or behind the last.
Splice insert_entry(const EditText& text, std::uint32_t owner, std::size_t entry, const EntryWords& words);

// The first entry, under the key (or '-') of an absent value; `owner` is the mapping or list it stands in.
Splice fill_absent(const EditText& text, std::uint32_t owner, std::size_t entry, const EntryWords& words,
                   bool is_list);

// Another value for an entry.
Splice replace_value(const EditText& text, std::uint32_t owner, std::size_t entry, const std::string& value);

// Without an entry; there are others.
Splice remove_entry(const EditText& text, std::uint32_t owner, std::size_t entry);

// An item of a list before another one, or behind the last.
Splice move_item(const EditText& text, std::uint32_t list, std::size_t from, std::size_t before);

// `key`, in quotes if it is no plain word.
std::string quote_key(const std::string& key);

}  // namespace mien

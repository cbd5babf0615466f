// Text as UTF-8, character by character.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace mien {

// One character: its code point and its length in bytes; length 0 if it is malformed.
struct Character {
  std::uint32_t code = 0;
  std::size_t length = 0;
};

// The character of `text` that begins at a byte of it. Overlong forms, surrogates, what is cut off and what
// lies beyond U+10FFFF are malformed.
Character find_character(std::string_view text, std::size_t at);

// Whether a byte begins a character: those that do not are the rest of one.
bool is_first_of_character(char byte);

// How many characters a text has, by the bytes that begin one.
std::size_t count_characters(std::string_view text);

}  // namespace mien

#include "core/utf8.hpp"

#include <utf8cpp/utf8.h>

#include <algorithm>

namespace mien {

Character find_character(std::string_view text, std::size_t at) {
  const char* const begin = text.data() + at;
  const char* next = begin;
  try {
    const std::uint32_t code = utf8::next(next, text.data() + text.size());
    return {code, static_cast<std::size_t>(next - begin)};
  } catch (const utf8::exception&) {
    return {};
  }
}

bool is_first_of_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }

std::size_t count_characters(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, is_first_of_character));
}

}  // namespace mien

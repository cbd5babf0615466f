#include "scene/title.hpp"

#include <algorithm>

#include "core/utf8.hpp"

namespace mien {

std::string clean_title(const std::string& title, std::string_view unsafe, std::size_t most_bytes) {
  std::string clean = title.substr(0, most_bytes);
  if (clean.size() < title.size())
    while (!clean.empty() && !is_first_of_character(title[clean.size()])) clean.pop_back();
  std::ranges::replace_if(
      clean,
      [&](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte < ' ' || byte == 127 || unsafe.find(c) != unsafe.npos;
      },
      ' ');
  return clean;
}

}  // namespace mien

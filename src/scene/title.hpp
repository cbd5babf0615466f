// A title as a header or a comment of a file takes it.
#pragma once

#include <string>
#include <string_view>

namespace mien {

// In one line: control characters and those of `unsafe` become blanks, and what is more than `most_bytes` is
// cut off, but no character in two.
std::string clean_title(const std::string& title, std::string_view unsafe = "\\",
                        std::size_t most_bytes = std::string::npos);

}  // namespace mien

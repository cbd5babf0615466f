// Numbers, files and templates as text: the one way mien writes any of them.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

// `value` with `decimals` (0..9) digits behind the point, trailing zeros and "-0" folded: 1.50 -> "1.5",
// -0.001 with two decimals -> "0". Never depends on the locale. |value| must be below 1e9; throws RunError if
// it is not finite.
void append_number(std::string& text, double value, int decimals);

// The same into a buffer that has room for kLongestNumber more, all of which may be written over; returns
// where the number ends.
constexpr int kLongestNumber = 24;
char* write_number(char* text, double value, int decimals);
std::string format_number(double value, int decimals);

// The whole file; throws RunError "cannot read PATH: reason".
std::string read_file(const std::filesystem::path& path);

// A file is complete or absent: written beside as "NAME.PID.part", flushed, renamed. Folders are made.
// Throws RunError "cannot write PATH: reason" and leaves nothing behind, a full disk included. Unchanged
// content is left untouched, so that its time stamp stays.
void write_file(const std::filesystem::path& path, std::string_view content);

// The template with each {{name}} replaced by its value. A placeholder without a value and a value without a
// placeholder throw RunError naming `origin`, the template's path.
std::string fill_template(std::string_view text, const std::map<std::string, std::string>& values,
                          std::string_view origin);

// The nearest of `names` to a mistyped `word` (optimal string alignment, at most a third of the letters
// wrong); empty if none is near.
std::string find_nearest(std::string_view word, const std::vector<std::string>& names);

// The ending of a file's name in small letters: ".png"; empty if it has none.
std::string find_ending(const std::filesystem::path& path);

// 16 lower-case hexadecimal digits of the xxHash64 of `content`.
std::string hash_hex(std::string_view content);

}  // namespace mien

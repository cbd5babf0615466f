// What the readers share: lines, words, numbers, and how a mistake in a file is told.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "import/polygons.hpp"

namespace mien {

// A text file, line after line.
struct LineReader {
  std::string file;
  std::string_view rest;
  std::string_view line;  // the current one, without its end
  int number = 0;         // of the current line, from 1
};

// Moves on to the next line; false after the last one.
bool read_line(LineReader& reader);

// The words of a line, into `words` (a buffer that is used again).
void split_words(std::string_view line, std::vector<std::string_view>& words);

// The whole word as a finite number.
std::optional<double> parse_coordinate(std::string_view word);
std::optional<long long> parse_index(std::string_view word);

// A point's number in an OBJ, from 1, or from -1 back from the last of `count`; the point may follow later.
// `user` is what names it, in messages: "face".
std::uint32_t parse_point_number(const std::string& file, int line, std::string_view word, std::size_t count,
                                 const char* user);

// A word as a message shows it: short, and without control characters.
std::string show_found(std::string_view word);

// "12 bytes", "1 byte".
std::string count_bytes(std::size_t count);

[[noreturn]] void fail_file(const std::string& file, const std::string& message);
[[noreturn]] void fail_line(const std::string& file, int line, const std::string& message);

// The whole file; fails unless it is a plain one of `most` bytes at most that may be read. Messages call it
// `file`, and what it should be `expected`: "a mesh".
std::string read_plain_file(const std::filesystem::path& path, const std::string& file,
                            const std::string& expected, std::uintmax_t most);

// Three words as a position; `line` is told in messages.
glm::dvec3 parse_position(const std::string& file, int line, std::string_view x, std::string_view y,
                          std::string_view z);

// A position out of binary numbers; `offset` is told in messages.
void check_position(const std::string& file, std::size_t offset, const glm::dvec3& position);

// Throws when there are more points than are allowed.
void check_point_count(const std::string& file, int line, std::size_t count);

// One reader a format: `bytes` is the whole file.
Polygons read_obj(const std::string& file, std::string_view bytes);
Polygons read_ply(const std::string& file, std::string_view bytes);
Polygons read_stl(const std::string& file, std::string_view bytes);
Polygons read_gltf(const std::string& file, std::string_view bytes);
Polygons read_points(const std::string& file, std::string_view bytes);  // all files of points as text

}  // namespace mien

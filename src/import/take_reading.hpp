// What the readers of takes share: rows of a CSV as they come, names, angles and how a mistake is told.
#pragma once

#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "import/take.hpp"

namespace mien {

// A longer line is no row: OpenFace has 714 columns of some 10 bytes.
inline constexpr std::size_t kMaxTakeLine = 64 << 10;

// A place in a file that is read line by line.
struct TakePlace {
  std::string_view file;
  int line = 0;
  std::string_view text;  // of the line
  std::size_t at = 0;     // bytes from its start
  int column = 0;         // in characters from 1, of a text that is not there line by line
};
[[noreturn]] void fail_take(const TakePlace& place, const std::string& message);

struct TakeCell {
  std::string_view word;
  std::size_t at = 0;
};

// A CSV that is read row after row.
struct TakeRows {
  std::string file;
  std::ifstream stream;
  std::vector<char> buffer;
  std::string_view line;
  int number = 0;  // of the line, from 1
  std::vector<TakeCell> cells;
};

// Opens it and reads its first row that is not blank; throws if there is none. `kind` is what was expected:
// "a take of Live Link Face".
TakeRows open_take_rows(const std::filesystem::path& file, const std::string& kind);
// Moves on to the next row that is not blank; false after the last one.
bool read_take_row(TakeRows& rows);
TakePlace find_take_place(const TakeRows& rows, std::size_t cell);

// The index of the column; empty if there is none of the name.
std::optional<std::size_t> find_take_column(const TakeRows& rows, std::string_view name);

// The cell as a number from `low` to `high`; throws at its place. `name` is the column's.
double parse_take_number(const TakeRows& rows, std::size_t cell, std::string_view name, double low,
                         double high);

// Adds a channel; throws if the take has one of the name, or `most`.
void add_take_channel(Take& take, const TakePlace& place, std::string name,
                      std::size_t most = kMaxTakeChannels);

// After a channel was added to a take that has rows of `channels_before`: the rows have 0 of it.
void widen_take(Take& take, std::size_t channels_before);

// Whether a row at this time is to be taken: not if it repeats the time of the one before; throws if it lies
// before it, or if the take has too many rows. Counts it.
bool begin_take_row(Take& take, const TakePlace& place, double at_s);

// "EyeBlinkLeft", "eyeBlink_L" and "eyeBlinkLeft" as ARKit names it: "eyeBlinkLeft".
std::string build_arkit_name(std::string_view name);

// Turn, nod and tilt of a head whose axes, x to its left, y up, z forward, are these columns.
std::array<float, 3> find_turn_deg(const std::array<double, 9>& columns);

// One reader a format.
Take read_live_link(const std::filesystem::path& file, double fps);
Take read_openface(const std::filesystem::path& file, double fps);
Take read_arkit_json(const std::filesystem::path& file, double fps);
Take read_face_tracks(const std::filesystem::path& file, double fps);
Take read_vrma(const std::filesystem::path& file, double fps);
Take read_gltf_take(const std::filesystem::path& file, double fps);

}  // namespace mien

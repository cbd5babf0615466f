#include "import/take.hpp"

#include <fmt/format.h>
#include <utf8cpp/utf8.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "import/reading.hpp"
#include "import/take_reading.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kGlance = 4096;  // bytes of a file by which its kind is known

// The cells of a line, without blanks and quotes around them.
void split_take_cells(std::string_view line, std::vector<TakeCell>& cells) {
  cells.clear();
  const auto is_around = [](char c) { return c == ' ' || c == '\t' || c == '"'; };
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    std::size_t first = begin, last = end;
    while (first < last && is_around(line[first])) ++first;
    while (last > first && is_around(line[last - 1])) --last;
    cells.push_back({line.substr(first, last - first), first});
    begin = end + 1;
  }
}

int find_take_column_number(const TakePlace& place) {
  if (place.column > 0) return place.column;
  return 1 + static_cast<int>(count_characters(place.text.substr(0, std::min(place.at, place.text.size()))));
}

void check_take_file(const fs::path& path, const std::string& kind) {
  const std::string file = path.string();
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) fail_file(file, "there is no such file; expected " + kind);
  if (fs::is_directory(status)) fail_file(file, "is a folder; expected " + kind);
  if (!fs::is_regular_file(status)) fail_file(file, "is no plain file; expected " + kind);
}

}  // namespace

void fail_take(const TakePlace& place, const std::string& message) {
  constexpr std::size_t kLongestShown = 200;  // bytes; a longer line would hide its message
  const bool is_shown =
      place.text.size() <= kLongestShown && utf8::is_valid(place.text.begin(), place.text.end()) &&
      std::ranges::none_of(place.text, [](unsigned char c) { return c < 0x20 && c != '\t'; });
  throw InputError(
      std::vector<Diagnostic>{{{std::string(place.file), place.line, find_take_column_number(place)},
                               message,
                               is_shown ? std::string(place.text) : std::string(),
                               false}});
}

TakeRows open_take_rows(const fs::path& path, const std::string& kind) {
  check_take_file(path, kind);
  TakeRows rows;
  rows.file = path.string();
  rows.stream.open(path, std::ios::binary);
  if (!rows.stream) fail_file(rows.file, "cannot be read; expected a file that you may read");
  rows.buffer.resize(kMaxTakeLine + 1);
  if (!read_take_row(rows)) fail_file(rows.file, "is empty; expected " + kind);
  return rows;
}

bool read_take_row(TakeRows& rows) {
  while (true) {
    rows.stream.getline(rows.buffer.data(), static_cast<std::streamsize>(rows.buffer.size()));
    const auto count = static_cast<std::size_t>(rows.stream.gcount());
    if (count == 0 && rows.stream.eof()) return false;
    ++rows.number;
    if (rows.stream.fail())
      fail_line(rows.file, rows.number,
                fmt::format("the line has more than {} bytes; expected a row of a table", kMaxTakeLine));
    // What was read counts the line's end, except of a last line without one.
    rows.line = {rows.buffer.data(), rows.stream.eof() ? count : count - 1};
    if (rows.number == 1 && rows.line.starts_with("\xEF\xBB\xBF")) rows.line.remove_prefix(3);
    while (rows.line.ends_with('\r')) rows.line.remove_suffix(1);
    if (rows.line.find('\0') != std::string_view::npos)
      fail_line(rows.file, rows.number, "the line has a byte 00; expected a text");
    if (rows.line.find_first_not_of(" \t,") == std::string_view::npos) continue;
    split_take_cells(rows.line, rows.cells);
    return true;
  }
}

TakePlace find_take_place(const TakeRows& rows, std::size_t cell) {
  return {rows.file, rows.number, rows.line, cell < rows.cells.size() ? rows.cells[cell].at : 0};
}

std::optional<std::size_t> find_take_column(const TakeRows& rows, std::string_view name) {
  const auto found = std::ranges::find(rows.cells, name, &TakeCell::word);
  if (found == rows.cells.end()) return std::nullopt;
  return static_cast<std::size_t>(found - rows.cells.begin());
}

double parse_take_number(const TakeRows& rows, std::size_t cell, std::string_view name, double low,
                         double high) {
  const std::string_view word = rows.cells[cell].word;
  const auto number = parse_coordinate(word);
  if (number && *number >= low && *number <= high) return *number;
  fail_take(find_take_place(rows, cell), fmt::format("'{}' is '{}'; expected a number from {:.7g} to {:.7g}",
                                                     show_found(name), show_found(word), low, high));
}

void add_take_channel(Take& take, const TakePlace& place, std::string name, std::size_t most) {
  if (std::ranges::find(take.channels, name, &TakeChannel::name) != take.channels.end())
    fail_take(place, fmt::format("'{}' is there twice; expected it once", show_found(name)));
  if (take.channels.size() >= most)
    fail_take(place, fmt::format("more than {} units; expected those of a face", most));
  take.channels.push_back({std::move(name), place.line, find_take_column_number(place)});
}

void widen_take(Take& take, std::size_t channels_before) {
  const std::size_t rows = take.at_s.size(), width = take.channels.size();
  if (rows * width > kMaxTakeValues)
    fail_line(take.file, take.channels.back().line,
              fmt::format("more than {} numbers up to here; expected a shorter take", kMaxTakeValues));
  std::vector<float> wide(rows * width, 0.0F);
  for (std::size_t row = 0; row < rows; ++row)
    std::copy_n(take.values.begin() + static_cast<std::ptrdiff_t>(row * channels_before), channels_before,
                wide.begin() + static_cast<std::ptrdiff_t>(row * width));
  take.values = std::move(wide);
}

bool begin_take_row(Take& take, const TakePlace& place, double at_s) {
  constexpr double kSame_s = 1e-6;  // numbers in a text are rounded
  if (take.row_count > 0 && at_s < take.end_s - kSame_s)
    fail_take(place, "this time is before the one of the row before; expected rising times");
  if (at_s > kMaxTakeTime_s)
    fail_take(place, fmt::format("this is at {:.7g} s; expected {} s at most", at_s, kMaxTakeTime_s));
  if ((take.at_s.size() + 1) * std::max<std::size_t>(take.channels.size(), 1) > kMaxTakeValues)
    fail_take(place, fmt::format("more than {} numbers up to here; expected a shorter take", kMaxTakeValues));
  const bool is_repeated = take.row_count > 0 && at_s <= take.end_s + kSame_s;
  ++take.row_count;
  if (is_repeated) ++take.repeated_count;
  take.end_s = std::max(take.end_s, at_s);
  return !is_repeated;
}

std::string build_arkit_name(std::string_view name) {
  std::string built(name);
  if (name.starts_with(kOwnUnit)) return built;
  if (!built.empty() && built[0] >= 'A' && built[0] <= 'Z') built[0] = static_cast<char>(built[0] + 32);
  for (const auto& [ending, side] : {std::pair{"_L", "Left"}, std::pair{"_R", "Right"}})
    if (built.ends_with(ending)) built.replace(built.size() - 2, 2, side);
  return built;
}

std::array<float, 3> find_turn_deg(const std::array<double, 9>& columns) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  // columns: left, up, forward, of three numbers each. The neck turns, then nods, then tilts.
  const auto at = [&](int column, int row) { return columns[static_cast<std::size_t>(3 * column + row)]; };
  const double turn = std::atan2(at(2, 0), at(2, 2));
  const double nod = std::atan2(-at(2, 1), std::hypot(at(2, 0), at(2, 2)));
  const double tilt = std::atan2(-at(0, 1), at(1, 1));
  return {static_cast<float>(turn * kDegrees), static_cast<float>(nod * kDegrees),
          static_cast<float>(tilt * kDegrees)};
}

Take load_take(const fs::path& file, TakeKind kind, double fps) {
  check_take_file(file, "a take of a face");
  Take take = kind == TakeKind::live_link  ? read_live_link(file, fps)
              : kind == TakeKind::openface ? read_openface(file, fps)
              : kind == TakeKind::tracks   ? read_face_tracks(file, fps)
              : kind == TakeKind::vrma     ? read_vrma(file, fps)
              : kind == TakeKind::gltf     ? read_gltf_take(file, fps)
                                           : read_arkit_json(file, fps);
  if (take.channels.empty()) fail_file(take.file, "has no units of a face; expected some, such as jawOpen");
  if (take.at_s.empty()) fail_file(take.file, "has no row with a face; expected one at least");
  return take;
}

TakeGuess guess_take_kind(const fs::path& file) {
  const std::string ending = find_ending(file);
  if (ending == ".vrma") return TakeGuess::vrma;
  if (ending == ".glb" || ending == ".gltf") return TakeGuess::gltf;
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return TakeGuess::none;
  std::ifstream stream(file, std::ios::binary);
  std::string text(kGlance, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  const auto has = [&](std::string_view word) { return text.find(word) != text.npos; };
  if (ending == ".csv" && (has("Timecode,") || has("EyeBlinkLeft"))) return TakeGuess::live_link;
  if (ending == ".csv" && (has("AU01_r") || has("face_id"))) return TakeGuess::openface;
  if (ending != ".json") return TakeGuess::none;
  if (has("openfacefx")) return TakeGuess::tracks;
  for (const char* word :
       {"lendshapes", "lendShapes", "categoryName", "category_name", "eyeBlink", "jawOpen"})
    if (has(word)) return TakeGuess::arkit;
  return TakeGuess::none;
}

}  // namespace mien

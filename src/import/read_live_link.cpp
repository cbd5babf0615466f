// Live Link Face's CSV: a line of names, then a row each sixtieth of a second:
//   Timecode,BlendShapeCount,EyeBlinkLeft,...,TongueOut,HeadYaw,HeadPitch,HeadRoll,LeftEyeYaw,...
//   14:21:07:33.518,61,0.021,...
// Columns are read by their names. A timecode counts hours, minutes, seconds and frames. A row with a
// BlendShapeCount of 0 is one without a face. Angles are radians (readers of the same numbers, as JimWest's
// PyLiveLinkFace and players of VRM, take them so); a file with one beyond half a turn is in degrees. Yaw is
// to the character's left, pitch chin down, roll crown to the left. The eyes' angles say again what EyeLook*
// say, and are passed. Columns such as mien.lips.press are what our own table says beside the units.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "import/reading.hpp"
#include "import/take_reading.hpp"

namespace mien {

namespace {

constexpr double kMostWeight = 10;  // a unit's range is 0 to 1, calibrated ones pass it by a little
constexpr double kMostAngle = 360;  // degrees, or radians
constexpr double kPhoneRate = 60;
constexpr std::array<std::string_view, 6> kEyeAngles{"LeftEyeYaw",  "LeftEyePitch",  "LeftEyeRoll",
                                                     "RightEyeYaw", "RightEyePitch", "RightEyeRoll"};
constexpr std::array<std::string_view, 3> kHeadAngles{"HeadYaw", "HeadPitch", "HeadRoll"};

// "14:21:07:33.518": whole seconds of the day, and frames of the second.
struct Timecode {
  double seconds = 0, frame = 0;
};

Timecode parse_timecode(const TakeRows& rows, std::size_t cell) {
  const std::string_view word = rows.cells[cell].word;
  std::array<double, 4> parts{};
  std::size_t count = 0, begin = 0;
  bool is_right = true;
  while (is_right && begin <= word.size() && count < parts.size()) {
    const std::size_t end = count == 3 ? word.size() : std::min(word.find_first_of(":;", begin), word.size());
    const std::string_view part = word.substr(begin, end - begin);
    const auto number = parse_coordinate(part);
    const bool is_plain = !part.empty() && part.find_first_not_of("0123456789.") == part.npos &&
                          (count == 3 || part.find('.') == part.npos);
    is_right = is_plain && number.has_value();
    if (is_right) parts[count++] = *number;
    begin = end + 1;
  }
  constexpr double kMostRate = 240;
  if (!is_right || count != 4 || begin <= word.size() || parts[0] >= 24 || parts[1] >= 60 || parts[2] >= 60 ||
      parts[3] >= kMostRate)
    fail_take(
        find_take_place(rows, cell),
        fmt::format("'{}' is no timecode; expected hours:minutes:seconds:frames such as 14:21:07:33.518",
                    show_found(word)));
  return {3600 * parts[0] + 60 * parts[1] + parts[2], parts[3]};
}

// The rate that frames of a second count up to; only a file that passes a second lets it see.
double find_nominal_rate(double highest_frame, bool has_passed_second) {
  for (const double rate : {24.0, 25.0, 30.0, 48.0, 50.0, 60.0, 90.0, 100.0, 120.0, 240.0})
    if (highest_frame < rate) return has_passed_second ? rate : std::max(rate, kPhoneRate);
  return kPhoneRate;
}

struct LiveLinkColumns {
  std::size_t time = 0;
  std::optional<std::size_t> count;
  std::array<std::optional<std::size_t>, 3> head;
  std::vector<std::size_t> units;  // of the take's channels
  std::vector<std::string> names;
};

LiveLinkColumns find_live_link_columns(const TakeRows& rows, Take& take) {
  LiveLinkColumns columns;
  const auto time = find_take_column(rows, "Timecode");
  if (!time)
    fail_take(find_take_place(rows, 0),
              "no column is 'Timecode'; expected the first line of Live Link Face's CSV");
  columns.time = *time;
  for (std::size_t i = 0; i < rows.cells.size(); ++i) {
    const std::string_view name = rows.cells[i].word;
    columns.names.emplace_back(name);
    if (name == "BlendShapeCount" || name == "BlendshapeCount") columns.count = i;
    const auto head = std::ranges::find(kHeadAngles, name);
    if (head != kHeadAngles.end()) columns.head[static_cast<std::size_t>(head - kHeadAngles.begin())] = i;
    if (i == *time || columns.count == i || head != kHeadAngles.end() ||
        std::ranges::find(kEyeAngles, name) != kEyeAngles.end())
      continue;
    add_take_channel(take, find_take_place(rows, i), build_arkit_name(name));
    columns.units.push_back(i);
  }
  return columns;
}

// Whether the row says that no face was seen.
bool is_unseen(const TakeRows& rows, const LiveLinkColumns& columns) {
  return columns.count && *columns.count < rows.cells.size() && rows.cells[*columns.count].word == "0";
}

void check_row_width(const TakeRows& rows, const LiveLinkColumns& columns) {
  if (rows.cells.size() != columns.names.size())
    fail_take(find_take_place(rows, 0),
              fmt::format("this line has {} cell{}; expected {} as in the first line", rows.cells.size(),
                          rows.cells.size() == 1 ? "" : "s", columns.names.size()));
}

}  // namespace

Take read_live_link(const std::filesystem::path& file, double fps) {
  TakeRows rows = open_take_rows(file, "a take of Live Link Face");
  Take take;
  take.file = rows.file;
  take.mapping = "arkit";
  const LiveLinkColumns columns = find_live_link_columns(rows, take);
  const bool has_head = std::ranges::all_of(columns.head, [](const auto& cell) { return cell.has_value(); });
  // Frames are seconds only when their rate is known, which is after the last row; rows are judged by both.
  std::vector<Timecode> times;
  Timecode first, before;
  double highest = 0, widest = 0, days_s = 0;
  bool has_passed = false;
  constexpr double kDay_s = 24 * 3600, kFinest = 240;  // frames: judged as if they were that short
  while (read_take_row(rows)) {
    if (columns.time >= rows.cells.size()) check_row_width(rows, columns);
    Timecode now = parse_timecode(rows, columns.time);
    if (take.row_count == 0) {
      first = before = now;
      take.start = rows.cells[columns.time].word;
    }
    if (now.seconds + days_s < before.seconds - kDay_s / 2) days_s += kDay_s;  // past midnight
    now.seconds += days_s;
    has_passed = has_passed || now.seconds != before.seconds;
    highest = std::max(highest, now.frame);
    before = now;
    const double first_frame = now.seconds == first.seconds ? first.frame : 0;
    const double judged_s = now.seconds - first.seconds + (now.frame - first_frame) / kFinest;
    if (!begin_take_row(take, find_take_place(rows, columns.time), judged_s)) continue;
    if (is_unseen(rows, columns)) {
      ++take.unseen_count;
      continue;
    }
    check_row_width(rows, columns);
    times.push_back(now);
    take.at_s.push_back(0);  // once the rate is known
    for (const std::size_t cell : columns.units)
      take.values.push_back(
          static_cast<float>(parse_take_number(rows, cell, columns.names[cell], -kMostWeight, kMostWeight)));
    if (!has_head) continue;
    std::array<float, 3> turn{};
    for (std::size_t i = 0; i < 3; ++i) {
      turn[i] = static_cast<float>(
          parse_take_number(rows, *columns.head[i], kHeadAngles[i], -kMostAngle, kMostAngle));
      widest = std::max(widest, std::abs(static_cast<double>(turn[i])));
    }
    take.turn_deg.push_back(turn);
  }
  const double nominal = fps > 0 ? std::ceil(fps - 1e-9) : find_nominal_rate(highest, has_passed);
  const double rate = fps > 0 ? fps : nominal;
  const auto compute_s = [&](const Timecode& time) {
    return ((time.seconds - first.seconds) * nominal + time.frame - first.frame) / rate;
  };
  for (std::size_t i = 0; i < times.size(); ++i) take.at_s[i] = compute_s(times[i]);
  take.end_s = compute_s(before);
  if (widest <= std::numbers::pi)
    for (auto& turn : take.turn_deg)
      for (float& angle : turn) angle *= static_cast<float>(180 / std::numbers::pi);
  return take;
}

}  // namespace mien

// The animator's exposure chart turned on its side, as letters.
#include "timeline/chart.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/text.hpp"
#include "core/utf8.hpp"

namespace mien {
namespace {

constexpr int kNameWidth = kLongestAreaKey;  // wider than "head"
constexpr int kLeastWidth = 40;
constexpr std::size_t kLeastName = 3;  // of a key; fewer letters say nothing
constexpr int kLeastTick = 8;          // columns between two times, so that "12.25s" stands free

// From rest to the limit.
constexpr std::array<std::string_view, 9> kBlocks{"·", "▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
constexpr std::string_view kLetters = ".:-=+*#%@";

// Sides this near, as of eyes that meet at a point, look the same in so few steps.
constexpr double kSameSide = 1.0 / 8;

ChartRow build_area_row(const std::vector<Shown>& frames, const AreaKey& key) {
  ChartRow row{std::string(key.key), {}, {}};
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    const MoveInfo& info = kMoves[i];
    if (info.area != key.area || info.side != (key.is_both ? Side::left : key.side)) continue;
    row.moves.emplace_back(info.move);
    std::vector<double>& values = row.values.emplace_back();
    values.reserve(frames.size());
    for (const Shown& frame : frames) values.push_back(frame.pose.values[i]);
  }
  return row;
}

ChartRow build_head_row(const std::vector<Shown>& frames) {
  ChartRow row{"head", {"turn", "nod", "tilt"}, std::vector<std::vector<double>>(3)};
  for (const Shown& frame : frames) {
    row.values[0].push_back(frame.turn_deg / kMaxTurn_deg);
    row.values[1].push_back(frame.nod_deg / kMaxNod_deg);
    row.values[2].push_back(frame.tilt_deg / kMaxTilt_deg);
  }
  return row;
}

// Whether the sides of an area are ever further apart than that.
bool are_apart(const std::vector<Shown>& frames, std::string_view area, double apart) {
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    if (kMoves[i].area != area || kMoves[i].side != Side::left) continue;
    const std::size_t other = *find_move(area, Side::right, kMoves[i].move);
    for (const Shown& frame : frames)
      if (std::abs(frame.pose.values[i] - frame.pose.values[other]) > apart) return true;
  }
  return false;
}

// Whether an area beyond the nine stays at rest: then nobody asks for its row.
bool is_idle_extra(const std::vector<Shown>& frames, std::string_view area) {
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    if (kMoves[i].area != area) continue;
    if (!is_beyond(find_area(kMoves[i].of))) return false;
    for (const Shown& frame : frames)
      if (frame.pose.values[i] != 0) return false;
  }
  return true;
}

// Where the clip's frames and times stand in the chart.
struct Columns {
  int count = 0, frames = 0, fps = 24;

  int first_frame(int column) const { return static_cast<int>(static_cast<long>(column) * frames / count); }
  // The first column of a time's frame.
  int find(double time_s) const {
    const auto frame = std::clamp(std::lround(time_s * fps), 0L, frames - 1L);
    return static_cast<int>(count >= frames ? (frame * count + frames - 1) / frames
                                            : ((frame + 1) * count - 1) / frames);
  }
};

double compute_column_amount(const ChartRow& row, const Columns& columns, int column) {
  const int first = columns.first_frame(column);
  const int end = std::max(first + 1, columns.first_frame(column + 1));
  double amount = 0;
  for (int frame = first; frame < end; ++frame) amount = std::max(amount, compute_amount(row, frame));
  return amount;
}

// 0 is rest and nothing else.
std::size_t find_level(double amount) {
  constexpr double kSteps = kBlocks.size() - 1;
  if (amount < 1e-6) return 0;
  return static_cast<std::size_t>(std::clamp(std::round(amount * kSteps), 1.0, kSteps));
}

// The time between two of the ruler's words.
double compute_step_s(const Columns& columns) {
  constexpr std::array kSteps_s{0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 30.0, 60.0, 300.0, 600.0};
  for (const double step_s : kSteps_s)
    if (step_s * columns.fps * columns.count / columns.frames >= kLeastTick) return step_s;
  return 3600;
}

std::string trim_line(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::string build_ruler(const Columns& columns) {
  const double step_s = compute_step_s(columns);
  std::string line(static_cast<std::size_t>(columns.count), ' ');
  for (int i = 0; i * step_s * columns.fps < columns.frames; ++i) {
    const std::string time = format_number(i * step_s, 2) + "s";
    const auto at = static_cast<std::size_t>(columns.find(i * step_s));
    if (at + time.size() <= line.size()) line.replace(at, time.size(), time);
  }
  return trim_line(std::string(kNameWidth + 1, ' ') + line);
}

// The keys' names, each cut where the next key stands, and below them their marks.
std::string build_key_lines(const std::vector<PoseKey>& keys, const Columns& columns, bool is_ascii) {
  std::string names(static_cast<std::size_t>(columns.count), ' ');
  std::vector<bool> is_marked(names.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto at = static_cast<std::size_t>(columns.find(keys[i].at_s));
    if (is_marked[at]) continue;  // of keys in one column the first is told
    is_marked[at] = true;
    std::size_t end = names.size();
    for (std::size_t j = i + 1; j < keys.size() && end == names.size(); ++j)
      if (const auto next = static_cast<std::size_t>(columns.find(keys[j].at_s)); next > at) end = next - 1;
    if (end - at < std::min(kLeastName, keys[i].label.size())) continue;
    const std::string name = keys[i].label.substr(0, end - at);
    names.replace(at, name.size(), name);
  }
  std::string marks;
  for (const bool is_mark : is_marked) marks += !is_mark ? " " : is_ascii ? "v" : "▾";
  const std::string head = fmt::format("{:<{}} ", "keys", kNameWidth);
  return trim_line(head + names) + trim_line(std::string(kNameWidth + 1, ' ') + marks);
}

// What is said, each word where it begins; one that has no room before the next is left out.
std::string build_word_line(const std::vector<SpokenWord>& words, const Columns& columns) {
  std::vector<std::string> cells(static_cast<std::size_t>(columns.count), " ");
  std::size_t free = 0;
  for (const SpokenWord& word : words) {
    const auto begin = static_cast<std::size_t>(columns.find(word.from_s));
    const std::size_t size = count_characters(word.text);
    if (begin < free || begin + size > cells.size()) continue;
    for (std::size_t i = 0, at = 0; i < size; ++i) {
      const std::size_t length = std::max<std::size_t>(find_character(word.text, at).length, 1);
      cells[begin + i] = word.text.substr(at, length);
      at += length;
    }
    free = begin + size + 1;
  }
  return trim_line(fmt::format("{:<{}} {}", "words", kNameWidth, fmt::join(cells, "")));
}

}  // namespace

std::vector<ChartRow> list_chart_rows(const std::vector<Shown>& frames, double apart) {
  std::vector<ChartRow> rows;
  for (const AreaKey& key : kAreaKeys) {
    if (!key.is_both && key.side != Side::none) continue;  // comes with its plural
    if (is_idle_extra(frames, key.area)) continue;
    if (!key.is_both || !are_apart(frames, key.area, apart)) {
      rows.push_back(build_area_row(frames, key));
      continue;
    }
    for (const AreaKey& side : kAreaKeys)
      if (side.area == key.area && !side.is_both) rows.push_back(build_area_row(frames, side));
  }
  rows.push_back(build_head_row(frames));
  return rows;
}

double compute_amount(const ChartRow& row, int frame) {
  double amount = 0;
  for (const std::vector<double>& values : row.values)
    amount = std::max(amount, std::abs(values.at(static_cast<std::size_t>(frame))));
  return std::min(amount, 1.0);
}

std::string build_chart(const ClipSpec& clip, const std::vector<Shown>& frames, const ChartStyle& style) {
  const int width = std::max(style.width, kLeastWidth) - kNameWidth - 1;
  const Columns columns{width, static_cast<int>(frames.size()), clip.fps};
  std::string text = build_ruler(columns) + build_key_lines(clip.keys, columns, style.is_ascii);
  if (!clip.words.empty()) text += build_word_line(clip.words, columns);
  for (const ChartRow& row : list_chart_rows(frames, kSameSide)) {
    text += fmt::format("{:<{}} ", row.name, kNameWidth);
    for (int column = 0; column < columns.count; ++column) {
      const std::size_t level = find_level(compute_column_amount(row, columns, column));
      if (style.is_ascii)
        text += kLetters[level];
      else
        text += kBlocks[level];
    }
    text += '\n';
  }
  return text;
}

}  // namespace mien

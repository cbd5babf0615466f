#include "voice/mouth.hpp"

#include <algorithm>
#include <cmath>

#include "core/smooth.hpp"

namespace mien {

namespace {

constexpr double kRow_s = 0.01;
constexpr double kCore = 0.25;     // of a segment's length, at each end: there it gives way to its neighbours
constexpr double kFade_s = 0.045;  // after which a mouth insists on a third of itself
constexpr double kNear_s = 0.25;   // further away it has no say
constexpr double kTouch_s = 0.05;  // the way to what touches, and off it
constexpr double kTouchCore = 0.15;  // of a segment's length, at each end
constexpr double kJaw = 2.6;         // limits a second
constexpr double kStressed = 1.15, kUnstressed = 0.85;

bool is_of(std::size_t move, Area area) { return kMoves[move].of == area; }

std::vector<std::size_t> list_moves(bool (*is_wanted)(Area)) {
  std::vector<std::size_t> moves;
  for (std::size_t i = 0; i < kMoveCount; ++i)
    if (is_wanted(kMoves[i].of)) moves.push_back(i);
  return moves;
}

// How far a time lies outside of a span; 0 within it.
double compute_distance(double time_s, double from_s, double to_s) {
  return std::max({from_s - time_s, time_s - to_s, 0.0});
}

double compute_target(const Viseme& viseme, const MouthSegment& segment, std::size_t move,
                      const MouthSettings& settings) {
  double value = settings.strength * viseme.pose.values[move];
  if (viseme.is_vowel && !is_of(move, Area::corner))
    value *= segment.stress == 1 ? kStressed : segment.stress == 0 ? kUnstressed : 1;
  return value;
}

// What the neighbours make of a moment.
double mix(const SpeechData& data, const std::vector<MouthSegment>& segments, double time_s, std::size_t move,
           const MouthSettings& settings) {
  double sum = 0, all = 0;
  for (const MouthSegment& segment : segments) {
    if (segment.to_s < time_s - kNear_s) continue;
    if (segment.from_s > time_s + kNear_s) break;
    const Viseme& viseme = data.visemes[segment.viseme];
    const double core_s = kCore * (segment.to_s - segment.from_s);
    const double away_s = compute_distance(time_s, segment.from_s + core_s, segment.to_s - core_s);
    const double share = viseme.insists[move] * std::exp(-away_s / kFade_s);
    sum += share * compute_target(viseme, segment, move, settings);
    all += share;
  }
  return all > 0 ? sum / all : 0;
}

// When something touches, and what.
struct Touch {
  double from_s = 0, to_s = 0;
  const Viseme* viseme = nullptr;
};

std::vector<Touch> list_touches(const SpeechData& data, const std::vector<MouthSegment>& segments,
                                double frame_s) {
  std::vector<Touch> touches;
  for (const MouthSegment& segment : segments) {
    const Viseme& viseme = data.visemes[segment.viseme];
    if (viseme.contact == MouthContact::none) continue;
    const double length_s = segment.to_s - segment.from_s, middle_s = (segment.from_s + segment.to_s) / 2;
    const double half_s = std::max((0.5 - kTouchCore) * length_s, frame_s / 2);
    touches.push_back({middle_s - half_s, middle_s + half_s, &viseme});
  }
  return touches;
}

// Rows are changed in their own column alone.
struct Column {
  std::vector<double>& values;
  std::size_t at, width, rows;
  double& operator[](std::size_t row) const { return values[row * width + at]; }
};

void hold_jaw(const Column& column, const std::vector<double>& at_s) {
  for (std::size_t row = 1; row < column.rows; ++row)
    column[row] = std::min(column[row], column[row - 1] + kJaw * (at_s[row] - at_s[row - 1]));
  for (std::size_t row = column.rows - 1; row > 0; --row)
    column[row - 1] = std::min(column[row - 1], column[row] + kJaw * (at_s[row] - at_s[row - 1]));
}

void apply_touches(const Column& column, const std::vector<double>& at_s, std::size_t move,
                   const std::vector<Touch>& touches) {
  for (const Touch& touch : touches) {
    const double wanted = touch.viseme->pose.values[move];
    const auto begin = std::ranges::lower_bound(at_s, touch.from_s - kTouch_s);
    for (std::size_t row = static_cast<std::size_t>(begin - at_s.begin()); row < column.rows; ++row) {
      const double away_s = compute_distance(at_s[row], touch.from_s, touch.to_s);
      if (at_s[row] > touch.to_s + kTouch_s) break;
      const double share = smooth_share(1 - away_s / kTouch_s);
      column[row] = std::lerp(column[row], wanted, share);
    }
  }
}

}  // namespace

std::vector<std::size_t> list_lip_moves() {
  return list_moves([](Area area) { return area == Area::lips || area == Area::chin; });
}

std::vector<std::size_t> list_corner_moves() {
  return list_moves([](Area area) { return area == Area::corner; });
}

TimeTable build_mouth_table(const SpeechData& data, const std::vector<MouthSegment>& segments,
                            const std::vector<std::size_t>& moves, const MouthSettings& settings) {
  TimeTable table;
  table.moves = moves;
  if (segments.empty()) return table;
  const double from_s = segments.front().from_s, to_s = segments.back().to_s;
  const auto count = static_cast<std::size_t>(std::ceil((to_s - from_s) / kRow_s)) + 1;
  for (std::size_t row = 0; row < count; ++row)
    table.at_s.push_back(std::min(from_s + kRow_s * static_cast<double>(row), to_s));
  if (count > 1 && table.at_s[count - 2] >= to_s) table.at_s.pop_back();
  for (const double at_s : table.at_s)
    for (const std::size_t move : moves) table.values.push_back(mix(data, segments, at_s, move, settings));
  const std::vector<Touch> touches = list_touches(data, segments, settings.frame_s);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const Column column{table.values, i, moves.size(), table.at_s.size()};
    if (!is_of(moves[i], Area::corner)) apply_touches(column, table.at_s, moves[i], touches);
    if (is_of(moves[i], Area::chin)) hold_jaw(column, table.at_s);
    for (std::size_t row = 0; row < column.rows; ++row) {
      if (is_of(moves[i], Area::corner)) column[row] *= settings.corners;
      column[row] = std::clamp(column[row], kMoves[moves[i]].low, kMoves[moves[i]].high);
    }
  }
  return table;
}

}  // namespace mien

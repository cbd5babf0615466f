#include "voice/mouth.hpp"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

constexpr double kRow_s = 0.01;
constexpr double kCore = 0.25;     // of a segment's length, at each end: there it gives way to its neighbours
constexpr double kFade_s = 0.045;  // after which a mouth insists on a third of itself
constexpr double kNear_s = 0.25;   // further away it has no say
constexpr double kTouch_s = 0.3;   // after which lips have come anywhere
constexpr double kTouchCore = 0.15;  // of a segment's length, at each end
constexpr double kJaw = 1.8, kLips = 2.7, kPress = 5, kRoll = 3.5, kCorners = 8;  // limits a second
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

// What touches is where it has to be; before and after, lips are no further from it than they can come in
// that time. Of two that are nearer to each other than that, the nearer one has its way.
void apply_touches(const Column& column, const std::vector<double>& at_s, std::size_t move,
                   const std::vector<Touch>& touches) {
  const double rate = kMoves[move].low < 0 ? kLips : kMoves[move].move == "roll" ? kRoll : kPress;
  std::vector<std::pair<double, double>> near;  // how far in time, and what is wanted there
  for (std::size_t row = 0; row < column.rows; ++row) {
    near.clear();
    for (const Touch& touch : touches)
      if (const double away_s = compute_distance(at_s[row], touch.from_s, touch.to_s); away_s < kTouch_s)
        near.emplace_back(away_s, touch.viseme->pose.values[move]);
    std::ranges::stable_sort(near, [](const auto& a, const auto& b) { return a.first > b.first; });
    for (const auto& [away_s, wanted] : near)
      column[row] = std::clamp(column[row], wanted - rate * away_s, wanted + rate * away_s);
  }
}

// Between the nearest ways above and below that go no quicker.
void soften(const Column& column, const std::vector<double>& at_s, double rate) {
  std::vector<double> low(column.rows), high(column.rows);
  for (std::size_t row = 0; row < column.rows; ++row) low[row] = high[row] = column[row];
  const auto hold = [&](std::size_t row, std::size_t other) {
    const double way = rate * std::abs(at_s[row] - at_s[other]);
    low[row] = std::min(low[row], low[other] + way);
    high[row] = std::max(high[row], high[other] - way);
  };
  for (std::size_t row = 1; row < column.rows; ++row) hold(row, row - 1);
  for (std::size_t row = column.rows - 1; row > 0; --row) hold(row - 1, row);
  for (std::size_t row = 0; row < column.rows; ++row) column[row] = (low[row] + high[row]) / 2;
}

}  // namespace

std::vector<std::size_t> list_lip_moves(bool keeps_to_nine) {
  std::vector<std::size_t> moves =
      list_moves([](Area area) { return area == Area::lips || area == Area::chin || area == Area::tongue; });
  if (keeps_to_nine) std::erase_if(moves, [](std::size_t move) { return kMoves[move].is_beyond; });
  return moves;
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
    if (is_of(moves[i], Area::corner))
      soften(column, table.at_s, kCorners);
    else
      apply_touches(column, table.at_s, moves[i], touches);
    if (is_of(moves[i], Area::chin)) hold_jaw(column, table.at_s);
    for (std::size_t row = 0; row < column.rows; ++row) {
      if (is_of(moves[i], Area::corner)) column[row] *= settings.corners;
      column[row] = std::clamp(column[row], kMoves[moves[i]].low, kMoves[moves[i]].high);
    }
  }
  return table;
}

}  // namespace mien

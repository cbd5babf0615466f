#include "config/load_takes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bitset>

#include "config/expressions.hpp"
#include "takes/retarget.hpp"
#include "takes/thin_rows.hpp"

namespace mien {

namespace {

// Nobody sees a quarter of a degree; lower is more keys.
constexpr double kTurnTolerance_deg = 0.25;
// So many degrees of the head are noise as one limit of a move is.
constexpr double kTurnUnit_deg = 30;

// The moves that the rows ever set: a take has these, and leaves others to the clip.
std::bitset<kMoveCount> find_moved(const TakeMoves& moves) {
  std::bitset<kMoveCount> moved;
  for (std::size_t at = 0; at < moves.values.size(); ++at)
    if (moves.values[at] != 0) moved.set(at % moves.width);
  return moved;
}

TimeTable build_take_table(const TakeMoves& moves, Between between) {
  TimeTable table;
  table.between = between;
  const std::bitset<kMoveCount> moved = find_moved(moves);
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    // Both sides of an area together: one of them at rest is the take's, too.
    bool is_owned = moved[i];
    for (std::size_t other = 0; other < kMoveCount; ++other)
      is_owned = is_owned || (moved[other] && kMoves[other].of == kMoves[i].of);
    if (is_owned) table.moves.push_back(i);
  }
  table.at_s = moves.at_s;
  table.values.reserve(moves.at_s.size() * table.moves.size());
  for (std::size_t row = 0; row < moves.at_s.size(); ++row)
    for (const std::size_t move : table.moves)
      table.values.push_back(static_cast<double>(moves.values[row * moves.width + move]));
  return table;
}

// Shut lids are shut, and lips that press press: what was at its limit stays there, where noise is not seen.
void keep_limits(const std::vector<float>& before, const TakeReach& reach, TakeMoves& moves) {
  constexpr double kAtLimit = 0.98;  // of it
  for (std::size_t at = 0; at < before.size(); ++at) {
    const auto& [low, high] = reach.ranges[at % moves.width];
    const double value = static_cast<double>(before[at]), limit = value < 0 ? low : high;
    if (limit != 0 && value / limit >= kAtLimit) moves.values[at] = before[at];
  }
}

}  // namespace

std::optional<TakeKind> find_take_key(std::string_view key) {
  if (key == "live_link") return TakeKind::live_link;
  if (key == "arkit") return TakeKind::arkit;
  if (key == "openface") return TakeKind::openface;
  if (key == "openfacefx") return TakeKind::tracks;
  if (key == "vrma") return TakeKind::vrma;
  if (key == "gltf") return TakeKind::gltf;
  return std::nullopt;
}

TakeMoves build_take_moves(const Take& take, const TakeReading& reading, const MappingData& data) {
  TakeMoves moves = retarget_take(take, find_mapping(data, take.mapping), data.moves);
  SmoothSpec smooth;
  smooth.cutoff_hz = reading.smooth_hz;
  const std::vector<float> before = moves.values;
  smooth_rows(moves.at_s, moves.width, smooth, moves.values);
  keep_limits(before, data.moves, moves);
  smooth_angles(moves.at_s, smooth, kTurnUnit_deg, moves.turn_deg);
  return moves;
}

std::vector<TurnKey> build_turn_keys(const TakeMoves& moves, double tolerance_deg) {
  std::vector<float> angles;
  angles.reserve(3 * moves.turn_deg.size());
  for (const auto& turn : moves.turn_deg)
    for (std::size_t i = 0; i < 3; ++i)
      angles.push_back(std::clamp(turn[i], static_cast<float>(kTurnBounds[i].low),
                                  static_cast<float>(kTurnBounds[i].high)));
  std::vector<TurnKey> keys;
  if (angles.empty()) return keys;
  for (const std::size_t row : thin_rows(moves.at_s, angles, 3, {{0, 1}, {1, 1}, {2, 1}}, tolerance_deg)) {
    TurnKey key;
    key.at_s = moves.at_s[row];
    key.turn_deg = static_cast<double>(angles[3 * row]);
    key.nod_deg = static_cast<double>(angles[3 * row + 1]);
    key.tilt_deg = static_cast<double>(angles[3 * row + 2]);
    key.between = Between::linear;
    keys.push_back(std::move(key));
  }
  return keys;
}

TakeReading find_usual_reading(std::optional<TakeKind> kind) {
  TakeReading reading;
  if (kind == TakeKind::gltf) reading.smooth_hz = 0;
  return reading;
}

TakeReading load_take_reading(const YamlMapping& track, std::optional<TakeKind> kind) {
  TakeReading reading = find_usual_reading(kind);
  if (const YamlValue* smooth = find_value(track, "smooth")) load_number(*smooth, reading.smooth_hz);
  if (const YamlValue* fps = find_value(track, "fps")) load_number(*fps, reading.fps);
  return reading;
}

std::shared_ptr<const TakeTable> find_take(const YamlEntry& named, const TakeReading& reading,
                                           const std::filesystem::path& file, Between between,
                                           const ClipReader& reader) {
  auto& takes = reader.library->takes;
  const std::string key = fmt::format("{} {} {} {} {}", named.key, reading.smooth_hz, reading.fps,
                                      static_cast<int>(between), file.string());
  if (const auto known = takes.find(key); known != takes.end()) return known->second;
  if (!reader.book->mappings) return takes[key] = nullptr;
  try {
    const Take take = load_take(file, *find_take_key(named.key), reading.fps);
    const TakeMoves moves = build_take_moves(take, reading, *reader.book->mappings);
    return takes[key] = std::make_shared<const TakeTable>(
               TakeTable{build_take_table(moves, between), build_turn_keys(moves, kTurnTolerance_deg)});
  } catch (const InputError& error) {
    for (const Diagnostic& mistake : error.diagnostics)
      add_mistake(*named.value.findings, mistake.place, mistake.message, mistake.source_line);
  }
  return takes[key] = nullptr;
}

}  // namespace mien

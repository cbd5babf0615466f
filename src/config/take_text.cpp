#include "config/take_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "config/load_takes.hpp"
#include "core/text.hpp"
#include "takes/thin_rows.hpp"

namespace mien {

namespace {

constexpr int kValueDecimals = 2;  // a tenth of a millimetre of a brow
constexpr double kLeastTold = 0.005;
constexpr double kTurnPerTolerance = 0.5;  // degrees of the head for each mm: about its way at the nose

std::string_view find_script_name(const AreaInfo& area) { return area.has_sides() ? area.plural : area.name; }

std::string describe_side(const AreaInfo& area, Side side, const Pose& pose) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < kMoveCount; ++i)
    if (kMoves[i].of == area.area && kMoves[i].side == side && std::abs(pose.values[i]) >= kLeastTold)
      words.push_back(fmt::format("{}: {}", kMoves[i].move, format_number(pose.values[i], kValueDecimals)));
  return words.empty() ? "" : fmt::format("{{{}}}", fmt::join(words, ", "));
}

// The script of one area; empty if it never moves.
std::string build_script_text(const TakeMoves& moves, const MappingData& data, const AreaInfo& area,
                              double tolerance_mm, const std::string& end, std::size_t& key_count) {
  std::vector<KeyColumn> columns;
  for (std::size_t i = 0; i < kMoveCount; ++i)
    if (kMoves[i].of == area.area) columns.push_back({i, data.ways_mm[i]});
  const auto is_moved = [&](std::size_t row) {
    return std::ranges::any_of(columns, [&](const KeyColumn& column) {
      return std::abs(moves.values[row * moves.width + column.column]) >= static_cast<float>(kLeastTold);
    });
  };
  std::size_t first_moved = 0;
  while (first_moved < moves.at_s.size() && !is_moved(first_moved)) ++first_moved;
  if (first_moved == moves.at_s.size()) return "";
  std::string text = fmt::format("    {}:\n      length: {}\n      between: linear\n      keys:\n",
                                 find_script_name(area), end);
  for (const std::size_t row : thin_rows(moves.at_s, moves.values, moves.width, columns, tolerance_mm)) {
    Pose pose;
    for (const KeyColumn& column : columns)
      pose.values[column.column] = static_cast<double>(moves.values[row * moves.width + column.column]);
    const std::string areas = build_moves_text(pose);
    text += fmt::format("        - {{at: {}s{}}}\n", format_number(moves.at_s[row], 3),
                        areas.empty() ? ", express: neutral" : ", areas: {" + areas + "}");
    ++key_count;
  }
  return text;
}

std::string build_turn_text(const TakeMoves& moves, double tolerance_mm, std::size_t& key_count) {
  std::string text;
  for (const TurnKey& key : build_turn_keys(moves, tolerance_mm * kTurnPerTolerance)) {
    text += fmt::format("    - {{at: {}s, turn: {}deg, nod: {}deg, tilt: {}deg, between: linear}}\n",
                        format_number(key.at_s, 3), format_number(key.turn_deg, 1),
                        format_number(key.nod_deg, 1), format_number(key.tilt_deg, 1));
    ++key_count;
  }
  return text.empty() ? "" : "  turn:\n" + text;
}

}  // namespace

std::string build_moves_text(const Pose& pose) {
  std::vector<std::string> words;
  for (const AreaInfo& area : kAreas) {
    if (!area.has_sides()) {
      if (const std::string both = describe_side(area, Side::none, pose); !both.empty())
        words.push_back(fmt::format("{}: {}", area.name, both));
      continue;
    }
    const std::string left = describe_side(area, Side::left, pose),
                      right = describe_side(area, Side::right, pose);
    if (left == right && !left.empty()) words.push_back(fmt::format("{}: {}", area.plural, left));
    if (left == right) continue;
    if (!left.empty()) words.push_back(fmt::format("{}: {}", area.left_key, left));
    if (!right.empty()) words.push_back(fmt::format("{}: {}", area.right_key, right));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

TakeText build_take_text(const TakeMoves& moves, const MappingData& data, const TakeTextSpec& spec) {
  TakeText built;
  const std::string end = format_number(std::max(moves.at_s.back(), 0.001), 3) + "s";
  std::string scripts, cues;
  for (const AreaInfo& area : kAreas) {
    const std::string script = build_script_text(moves, data, area, spec.tolerance_mm, end, built.key_count);
    if (script.empty()) continue;
    scripts += script;
    cues += fmt::format("    - {{from: 0s, play: {0}, areas: [{0}], attack: 0s, release: 0s}}\n",
                        find_script_name(area));
  }
  const std::string turn = build_turn_text(moves, spec.tolerance_mm, built.key_count);
  built.text = fmt::format(
      "# A take, {}, as keys: straight between them, and nowhere more than {} mm from it. Each area of the\n"
      "# face has a script of its own; change its keys, or lay cues and laws on top.",
      show_word(spec.source), format_number(spec.tolerance_mm, 3));
  if (!spec.track.empty())
    built.text +=
        fmt::format(" tracks:\n# [{{{}: {}}}] follows the file itself.", spec.track, show_word(spec.source));
  built.text += fmt::format("\nmien: 1\ntitle: {}\nclip:\n  length: {}\n  draw: ones\n", spec.name, end);
  built.text += turn;
  if (!scripts.empty()) built.text += "  scripts:\n" + scripts + "  cues:\n" + cues;
  return built;
}

}  // namespace mien

#include "takes/retarget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"
#include "import/reading.hpp"

namespace mien {

namespace {

constexpr double kMissedRows = 2.5;   // times the usual step: more than one row is missing
constexpr double kHeldSlack = 0.02;   // of a limit: less is noise about it
constexpr double kLeastLoss = 0.01;   // of all that is lost; less is not worth a line
constexpr double kLeastWeight = 0.1;  // of a unit that moves no skin: less is noise

// What a channel is: a unit of the mapping, a way of ours, or neither.
struct ChannelUse {
  std::optional<std::size_t> unit = {};
  std::optional<MappedMove> own = {};
};

std::vector<ChannelUse> find_uses(const Take& take, const Mapping& mapping, const TakeReach& table,
                                  TakeReport& report) {
  std::vector<std::string> names;
  for (const MappedUnit& unit : mapping.units) names.push_back(unit.name);
  std::vector<ChannelUse> uses;
  std::vector<Diagnostic> mistakes;
  for (const TakeChannel& channel : take.channels) {
    ChannelUse& use = uses.emplace_back(ChannelUse{find_unit(mapping, channel.name)});
    if (use.unit) continue;
    if (channel.name.starts_with(kOwnUnit))
      if (const auto way = table.ways.find(channel.name.substr(kOwnUnit.size())); way != table.ways.end())
        use.own = way->second;
    if (use.own) continue;
    if (take.is_animation) {
      report.passed.push_back(channel.name);
      continue;
    }
    if (channel.name.starts_with(kOwnUnit))
      for (const auto& [way, end] : table.ways) names.push_back(fmt::format("{}{}", kOwnUnit, way));
    const std::string nearest = find_nearest(channel.name, names);
    mistakes.push_back({{take.file, channel.line, channel.column},
                        fmt::format("unknown unit '{}' of {}; {}", channel.name, mapping.name,
                                    nearest.empty() ? "expected one such as " + names.front()
                                                    : "did you mean '" + nearest + "'?"),
                        "",
                        false});
  }
  if (!mistakes.empty()) throw InputError(std::move(mistakes));
  if (report.passed.size() == uses.size())
    throw InputError(fmt::format(
        "{}: none of its {} targets is a unit of a face, such as '{}'; expected names of mien's moves, of "
        "ARKit's units or of VRM's expressions",
        take.file, uses.size(), show_found(report.passed.front())));
  return uses;
}

double find_usual_step(const std::vector<double>& at_s) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < at_s.size(); ++i) steps.push_back(at_s[i] - at_s[i - 1]);
  if (steps.empty()) return 0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

std::vector<TakeGap> find_gaps(const std::vector<double>& at_s) {
  const double most_s = kMissedRows * find_usual_step(at_s);
  std::vector<TakeGap> gaps;
  for (std::size_t i = 1; i < at_s.size(); ++i)
    if (at_s[i] - at_s[i - 1] > most_s) gaps.push_back({at_s[i - 1], at_s[i]});
  return gaps;
}

void add_gaze(const TakeReach& table, const std::array<float, 2>& gaze_deg, std::span<double> moves) {
  for (const auto& [move, is_up] : table.gaze) {
    const double angle = gaze_deg[is_up ? 1 : 0];
    moves[move] += angle / table.gaze_deg[!is_up ? 0 : angle > 0 ? 1 : 2];
  }
}

// Holds the row within its limits and counts what was held.
void hold_row(const TakeReach& table, double at_s, std::span<double> moves, std::vector<TakeHeld>& held) {
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const double asked = moves[i];
    moves[i] = std::clamp(asked, table.ranges[i].low, table.ranges[i].high);
    if (std::abs(asked - moves[i]) <= kHeldSlack) continue;
    TakeHeld& now = held[i];
    ++now.rows;
    if (std::abs(asked) > std::abs(now.most)) {
      now.most = asked;
      now.most_s = at_s;
    }
  }
}

// What each row loses, by the second in which it lies.
struct LossSums {
  std::vector<double> moved, lost;  // of each unit
  std::vector<double> most, most_s;
  double second_lost = 0, second_from_s = 0;
  int second_rows = 0;
};

void end_second(LossSums& sums, TakeReport& report) {
  const double mean = sums.second_rows > 0 ? sums.second_lost / sums.second_rows : 0;
  if (mean > report.worst_mm2) {
    report.worst_mm2 = mean;
    report.worst_s = sums.second_from_s;
  }
  sums.second_lost = 0;
  sums.second_rows = 0;
}

void add_losses(const Mapping& mapping, std::span<const double> weights, double at_s, LossSums& sums,
                TakeReport& report) {
  if (at_s >= sums.second_from_s + 1) {
    end_second(sums, report);
    sums.second_from_s = std::floor(at_s);
  }
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double weight = std::max(weights[i], 0.0), moved = weight * weight * mapping.units[i].motion_mm2;
    const double lost = moved * std::min(mapping.units[i].residual, 1.0);
    sums.moved[i] += moved;
    sums.lost[i] += lost;
    sums.second_lost += lost;
    if (weight > sums.most[i]) {
      sums.most[i] = weight;
      sums.most_s[i] = at_s;
    }
  }
  ++sums.second_rows;
}

// From when to when around its highest value a unit is half as high.
void find_span(const Take& take, std::size_t channel, UnitLoss& loss) {
  const std::size_t width = take.channels.size();
  const auto top =
      static_cast<std::size_t>(std::ranges::lower_bound(take.at_s, loss.most_s) - take.at_s.begin());
  const auto is_high = [&](std::size_t row) { return take.values[row * width + channel] >= loss.most / 2; };
  std::size_t first = top, last = top;
  while (first > 0 && is_high(first - 1)) --first;
  while (last + 1 < take.at_s.size() && is_high(last + 1)) ++last;
  loss.from_s = take.at_s[first];
  loss.to_s = take.at_s[last];
}

void build_losses(const Take& take, const Mapping& mapping, const std::vector<ChannelUse>& uses,
                  const LossSums& sums, TakeReport& report) {
  const auto rows = static_cast<double>(take.at_s.size());
  for (std::size_t i = 0; i < mapping.units.size(); ++i) {
    report.moved_mm2 += sums.moved[i] / rows;
    report.lost_mm2 += sums.lost[i] / rows;
  }
  for (std::size_t channel = 0; channel < uses.size(); ++channel) {
    if (!uses[channel].unit) continue;
    const std::size_t i = *uses[channel].unit;
    const MappedUnit& unit = mapping.units[i];
    const bool is_skinless =
        unit.motion_mm2 == 0 && unit.moves.empty() && unit.residual > 0 && sums.most[i] >= kLeastWeight;
    if (!is_skinless && (sums.lost[i] <= 0 || sums.lost[i] / rows < kLeastLoss * report.lost_mm2)) continue;
    UnitLoss loss{unit.name, sums.moved[i] / rows, sums.lost[i] / rows, sums.most[i], sums.most_s[i], 0, 0};
    find_span(take, channel, loss);
    report.losses.push_back(std::move(loss));
  }
  std::ranges::stable_sort(report.losses, std::ranges::greater{}, &UnitLoss::lost_mm2);
}

}  // namespace

TakeMoves retarget_take(const Take& take, const Mapping& mapping, const TakeReach& table) {
  TakeMoves moves{table.ranges.size(), take.at_s, {}, take.turn_deg, {}};
  const std::vector<ChannelUse> uses = find_uses(take, mapping, table, moves.report);
  moves.values.reserve(take.at_s.size() * moves.width);
  const std::size_t count = mapping.units.size(), channels = take.channels.size();
  LossSums sums;
  for (auto* numbers : {&sums.moved, &sums.lost, &sums.most, &sums.most_s}) numbers->assign(count, 0);
  std::vector<TakeHeld> held(moves.width);
  std::vector<double> weights(count), row(moves.width);
  for (std::size_t at = 0; at < take.at_s.size(); ++at) {
    std::ranges::fill(weights, 0.0);
    std::ranges::fill(row, 0.0);
    for (std::size_t i = 0; i < channels; ++i) {
      const auto value = static_cast<double>(take.values[at * channels + i]);
      if (uses[i].unit) weights[*uses[i].unit] = value;
      if (uses[i].own) row[uses[i].own->move] += value * uses[i].own->value;
    }
    add_mapped_moves(mapping, weights, row);
    if (!take.gaze_deg.empty()) add_gaze(table, take.gaze_deg[at], row);
    add_losses(mapping, weights, take.at_s[at], sums, moves.report);
    hold_row(table, take.at_s[at], row, held);
    for (const double value : row) moves.values.push_back(static_cast<float>(value));
  }
  end_second(sums, moves.report);
  build_losses(take, mapping, uses, sums, moves.report);
  for (std::size_t i = 0; i < held.size(); ++i) {
    held[i].move = i;
    if (held[i].rows > 0) moves.report.held.push_back(held[i]);
  }
  if (!take.is_animation) moves.report.gaps = find_gaps(take.at_s);
  return moves;
}

}  // namespace mien

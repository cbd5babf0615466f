#include "takes/mapping.hpp"

#include <algorithm>

namespace mien {

std::optional<std::size_t> find_unit(const Mapping& mapping, std::string_view name) {
  const auto found = std::ranges::find(mapping.units, name, &MappedUnit::name);
  if (found == mapping.units.end()) return std::nullopt;
  return static_cast<std::size_t>(found - mapping.units.begin());
}

namespace {

constexpr double kLeastCorrected = 0.05;  // of a unit less is noise, and so are shares of it

}  // namespace

void add_mapped_moves(const Mapping& mapping, std::span<double> weights, std::span<double> moves) {
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (const auto& other = mapping.units[i].corrects)
      weights[i] = std::clamp(weights[i], 0.0, std::max(weights[*other], 0.0));
  // What a blend takes of a unit, the unit does not do by itself.
  std::vector<double> rest(weights.begin(), weights.end());
  for (const MappedBlend& blend : mapping.blends) {
    double share = blend.units.empty() ? 0 : 1e9;
    for (const std::size_t unit : blend.units) share = std::min(share, rest[unit]);
    if (share <= 0) continue;
    for (const std::size_t unit : blend.units) rest[unit] -= share;
    for (const MappedMove& moved : blend.moves) moves[moved.move] += share * moved.value;
  }
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (rest[i] == 0) continue;
    const auto& other = mapping.units[i].corrects;
    const double share = other ? rest[i] / std::max(weights[*other], kLeastCorrected) : rest[i];
    for (const MappedMove& moved : mapping.units[i].moves) moves[moved.move] += share * moved.value;
  }
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (const auto& other = mapping.units[i].corrects) weights[*other] -= weights[i];
}

}  // namespace mien

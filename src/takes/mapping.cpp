#include "takes/mapping.hpp"

#include <algorithm>

namespace mien {

std::optional<std::size_t> find_unit(const Mapping& mapping, std::string_view name) {
  const auto found = std::ranges::find(mapping.units, name, &MappedUnit::name);
  if (found == mapping.units.end()) return std::nullopt;
  return static_cast<std::size_t>(found - mapping.units.begin());
}

void add_mapped_moves(const Mapping& mapping, std::span<double> weights, std::span<double> moves) {
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (const auto& most = mapping.units[i].at_most) weights[i] = std::min(weights[i], weights[*most]);
  // What a blend takes of a unit, the unit does not do by itself.
  std::vector<double> rest(weights.begin(), weights.end());
  for (const MappedBlend& blend : mapping.blends) {
    double share = blend.units.empty() ? 0 : 1e9;
    for (const std::size_t unit : blend.units) share = std::min(share, rest[unit]);
    if (share <= 0) continue;
    for (const std::size_t unit : blend.units) rest[unit] -= share;
    for (const MappedMove& moved : blend.moves) moves[moved.move] += share * moved.value;
  }
  for (std::size_t i = 0; i < rest.size(); ++i)
    if (rest[i] != 0)
      for (const MappedMove& moved : mapping.units[i].moves) moves[moved.move] += rest[i] * moved.value;
}

}  // namespace mien

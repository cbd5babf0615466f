// The nine areas as an author sets them: `brows: {up: 0.5}`, `brow.left: {up: 0.7}`.
#pragma once

#include "config/areas.hpp"
#include "config/live_pose.hpp"
#include "config/load_formula.hpp"
#include "config/yaml_reader.hpp"

namespace mien {

// "brows", "brow.left", ..., "chin".
Names list_area_keys();

// Where values may be formulas, and those that are.
struct LiveAreas {
  const FormulaReader* formulas = nullptr;
  std::vector<LivePose::Value> values = {};
};

// `areas: {...}`: a mapping of area keys. Without `live` a formula is a mistake.
AreaValues load_areas(const YamlValue& value, LiveAreas* live = nullptr);

// The area keys among the entries; others are passed over. A sided key overrides a plural one.
AreaValues load_areas(const YamlMapping& entries, LiveAreas* live = nullptr);

// How many numbers these entries say: of areas, muscles, units and parameters.
std::size_t count_area_numbers(const YamlMapping& entries);

// One number for each move, where the author wrote one.
using AreaNumbers = std::array<std::optional<double>, kChannelCount>;

// `{brows: 2, corner.left: 0.5}`: one number for all moves of an area. A sided key overrides a plural one.
AreaNumbers load_area_numbers(const YamlValue& value);

// False, with a mistake told at `spot`, if the move is beyond Tezuka's nine areas in a file that keeps to
// them.
bool check_nine(const YamlValue& value, const Spot& spot, std::size_t move);
// The same for what an expression does.
bool check_nine(const YamlValue& value, const Pose& pose);

// The moves that an area key such as "brows" or "lips" means.
std::vector<std::size_t> list_moves_of(const AreaKey& key);

}  // namespace mien

// VRM 1.0's presets: VRMC_vrm-1.0, expressions (VRM Consortium).
#include "exchange/target_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "config/load_spec.hpp"
#include "config/mapping_data.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

namespace mien {

namespace {

struct VrmPreset {
  const char* name;
  const char* expression;  // as --express takes it
};

constexpr std::array kVrmPresets{
    VrmPreset{"happy", "mien/smile"},
    VrmPreset{"angry", "mien/anger"},
    VrmPreset{"sad", "mien/sadness"},
    VrmPreset{"relaxed", "{corners: {up: 0.25, out: 0.1}, lids: {upper: -0.3}, brows: {up: 0.05}}"},
    VrmPreset{"surprised", "mien/surprise"},
    VrmPreset{"aa", "mouths/a"},
    VrmPreset{"ih", "mouths/i"},
    VrmPreset{"ou", "mouths/u"},
    VrmPreset{"ee", "mouths/e"},
    VrmPreset{"oh", "mouths/o"},
    VrmPreset{"blink", "{lids: {upper: -1}}"},
    VrmPreset{"blinkLeft", "{lid.left: {upper: -1}}"},
    VrmPreset{"blinkRight", "{lid.right: {upper: -1}}"},
};

// Those of the file, and of its library those that the file does not hide.
std::vector<TargetPose> list_expression_poses(const Spec& spec) {
  std::vector<TargetPose> poses;
  const std::string prefix = spec.library + "/";
  for (const Expression& expression : spec.expressions) {
    std::string name = expression.name;
    if (name.starts_with(prefix)) name.erase(0, prefix.size());
    if (name.find('/') != std::string::npos || expression.pose == Pose{}) continue;
    if (std::ranges::find(poses, name, &TargetPose::name) != poses.end()) continue;
    poses.push_back({name, expression.pose});
  }
  return poses;
}

std::vector<TargetPose> list_vrm_poses(const Spec& spec) {
  std::vector<TargetPose> poses;
  for (const VrmPreset& preset : kVrmPresets)
    poses.push_back({preset.name, take_expression(spec, preset.expression).pose});
  return poses;
}

// Each unit at 1; correctives of another one, which do nothing alone, at nothing.
std::vector<TargetPose> list_arkit_poses(const Spec& spec) {
  std::vector<TargetPose> poses;
  for (const MappedUnit& unit : spec.mappings->mappings.at("arkit").units) {
    TargetPose& target = poses.emplace_back(TargetPose{unit.name, {}});
    if (unit.corrects) continue;
    for (const MappedMove& move : unit.moves) target.pose.values[move.move] = move.value;
  }
  return poses;
}

}  // namespace

std::vector<std::string> list_target_sets() { return {"moves", "expressions", "arkit", "vrm"}; }

std::vector<TargetPose> build_target_set(const std::string& set, const Spec& spec) {
  if (set == "moves") return {};
  if (set == "expressions") return list_expression_poses(spec);
  if (set == "arkit") return list_arkit_poses(spec);
  if (set == "vrm") return list_vrm_poses(spec);
  throw InputError(fmt::format("--targets {}: unknown set of targets; expected one of: {}", set,
                               join_names(list_target_sets())));
}

}  // namespace mien

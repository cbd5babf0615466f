// Which poses are a rig's targets: --targets.
#pragma once

#include <string>
#include <vector>

#include "config/spec.hpp"
#include "frames/figure_rig.hpp"

namespace mien {

// What --targets may be: "moves", "expressions", "arkit", "vrm", in the order in which messages tell them.
std::vector<std::string> list_target_sets();

// Empty for "moves", of which the rig makes its own. "expressions": those of the file and of its library;
// "arkit": ARKit's units by configs/mappings, those that no move of ours does without a motion; "vrm":
// VRM 1.0's presets that a face has, neutral and gaze left out. Throws InputError for another word.
std::vector<TargetPose> build_target_set(const std::string& set, const Spec& spec);

}  // namespace mien

// USD as text (Pixar's Universal Scene Description, .usda): a model with UsdSkel joints, blend shapes and
// what they play. Millimetres, y up.
#pragma once

#include <string>

#include "core/rig.hpp"

namespace mien {

struct UsdScene {
  const Model& model;
  const Rig& rig;
  const RigTake& take;  // one pose is no animation
  std::string title;
  double fps = 24;  // time codes a second
};

// The content of a file, the same bytes for the same scene. Throws RunError for numbers that are not finite.
std::string build_usd(const UsdScene& scene);

}  // namespace mien

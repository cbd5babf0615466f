// VRM 1.0 (VRM Consortium): a glTF whose bones, expressions and gaze have the names that avatars' programs
// ask for.
#pragma once

#include <string>
#include <vector>

#include "core/rig.hpp"
#include "scene/gltf.hpp"

namespace mien {

struct VrmScene {
  const Model& model;
  const Rig& rig;  // "shoulders", "neck", "head", "eye_left", "eye_right", "jaw"; its targets are expressions
  std::string title, author, licence;
  const GltfPaint* paint = nullptr;
  double eye_up_deg = 20, eye_down_deg = 20, eye_side_deg = 25;  // how far eyes turn
  glm::dvec3 eyes_mm{0};                                         // midway between the pupils
};

// The content of a .vrm file. Its hips, arms and legs are joints without a body, as the format demands.
std::string build_vrm(const VrmScene& scene);

}  // namespace mien

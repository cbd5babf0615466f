// glTF 2.0 (Khronos, ISO/IEC 12113): a model with its rig and what it plays, through tinygltf. Metres, as
// that format has it; x to the character's left, y up, z forward, which is its own way.
//
// Parts are meshes with a colour a vertex and a material of their kind; bent parts are skinned and have
// morph targets, rigid parts hang on their joint. Names of targets stand in `extras.targetNames`, where
// Blender and three.js look for them.
#pragma once

#include <string>

#include "core/atlas.hpp"
#include "core/rig.hpp"

namespace mien {

// A picture over a part instead of its colours.
struct GltfPaint {
  std::size_t part = 0;  // in the model
  const Atlas& atlas;
  std::string png;  // a file's content, sRGB
};

struct GltfScene {
  const Model& model;
  const Rig& rig;
  const RigTake& take;  // one pose is no animation
  std::string title;
  const GltfPaint* paint = nullptr;
};

// The content of a file: .glb if `is_binary`, else .gltf with its numbers inside as base64. The same bytes
// for the same scene. Throws RunError "internal: a mesh holds a number that is not finite".
std::string build_gltf(const GltfScene& scene, bool is_binary);

}  // namespace mien

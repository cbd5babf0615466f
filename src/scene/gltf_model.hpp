// A glTF before it is written, for formats that add to it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scene/gltf.hpp"
#include "scene/tiny_gltf.hpp"

namespace mien {

struct GltfModel {
  tinygltf::Model model;
  int first_joint = 0;            // the node of the rig's first joint; the others follow
  std::vector<int> node_of_part;  // of each part of the model; -1: it has no triangles
};

// In the order of each part's targets are those of its mesh. Throws RunError as build_gltf does.
GltfModel build_gltf_model(const GltfScene& scene);

// The content of a file.
std::string write_gltf_model(tinygltf::Model& model, bool is_binary);

// JSON as tinygltf holds what extensions say.
tinygltf::Value to_gltf_value(const nlohmann::ordered_json& json);

}  // namespace mien

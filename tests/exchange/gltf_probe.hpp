// A glTF read back as its specification says, without a line of what wrote it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/tiny_gltf.hpp"

#include <glm/glm.hpp>

namespace mien {

// Throws std::runtime_error with the reader's words.
tinygltf::Model read_gltf(const std::string& bytes);

// Where the vertices of each node's mesh lie at a time of the first animation (at rest without one): mm, by
// the node's name.
std::map<std::string, std::vector<glm::dvec3>> place_gltf(const tinygltf::Model& model, double time_s);

}  // namespace mien

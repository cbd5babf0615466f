// Numbers as glTF holds them: in one buffer, told by views and accessors.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <vector>

#include "core/mesh.hpp"
#include "core/offsets.hpp"
#include "scene/tiny_gltf.hpp"

namespace mien {

// Appends to model.buffers[0] and gives the accessor's index. Throw RunError for numbers that are not finite.
int add_vectors(tinygltf::Model& model, const std::vector<glm::vec3>& vectors, bool has_bounds, int target);
int add_pairs(tinygltf::Model& model, const std::vector<glm::vec2>& pairs, int target);
int add_bytes(tinygltf::Model& model, const std::vector<glm::u8vec4>& bytes, bool is_normalized, int target);
int add_shares(tinygltf::Model& model, const std::vector<glm::u16vec4>& shares, int target);  // of 65535
int add_indices(tinygltf::Model& model, const std::vector<Triangle>& triangles);
int add_scalars(tinygltf::Model& model, const std::vector<float>& scalars, bool has_bounds);
int add_turns(tinygltf::Model& model, const std::vector<glm::quat>& turns);
int add_matrices(tinygltf::Model& model, const std::vector<glm::mat4>& matrices);

// `count` vectors that are 0 but for these: a sparse accessor.
int add_sparse_vectors(tinygltf::Model& model, std::size_t count, const VertexOffsets& offsets,
                       bool has_bounds);

// Bytes as they are, in a view of their own: pictures.
int add_view(tinygltf::Model& model, const std::string& bytes);

}  // namespace mien

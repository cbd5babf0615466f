#include "scene/gltf_buffer.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/error.hpp"

namespace mien {

namespace {

static_assert(std::endian::native == std::endian::little, "glTF's numbers are little-endian");

void check_finite(const float* numbers, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    if (!std::isfinite(numbers[i])) throw RunError("internal: a mesh holds a number that is not finite");
}

// A view of its own for what lies at `data`; 4 bytes are the coarsest that any of our numbers needs.
int add_raw_view(tinygltf::Model& model, const void* data, std::size_t size, int target) {
  if (model.buffers.empty()) model.buffers.emplace_back();
  std::vector<unsigned char>& bytes = model.buffers[0].data;
  bytes.resize((bytes.size() + 3) / 4 * 4);
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = bytes.size();
  view.byteLength = size;
  view.target = target;
  bytes.resize(bytes.size() + size);
  std::memcpy(bytes.data() + view.byteOffset, data, size);
  model.bufferViews.push_back(view);
  return static_cast<int>(model.bufferViews.size()) - 1;
}

int add_accessor(tinygltf::Model& model, int view, int component, int type, std::size_t count) {
  tinygltf::Accessor accessor;
  accessor.bufferView = view;
  accessor.componentType = component;
  accessor.type = type;
  accessor.count = count;
  model.accessors.push_back(accessor);
  return static_cast<int>(model.accessors.size()) - 1;
}

// The bounds of vectors of `width` floats; 0 is among them if `has_zero`.
void set_bounds(tinygltf::Accessor& accessor, const float* numbers, std::size_t count, int width,
                bool has_zero) {
  for (int k = 0; k < width; ++k) {
    float low = has_zero ? 0.0f : INFINITY, high = has_zero ? 0.0f : -INFINITY;
    for (std::size_t i = 0; i < count; ++i) {
      low = std::min(low, numbers[i * width + k]);
      high = std::max(high, numbers[i * width + k]);
    }
    accessor.minValues.push_back(low);
    accessor.maxValues.push_back(high);
  }
}

}  // namespace

int add_vectors(tinygltf::Model& model, const std::vector<glm::vec3>& vectors, bool has_bounds, int target) {
  const float* numbers = &vectors.front().x;
  check_finite(numbers, 3 * vectors.size());
  const int view = add_raw_view(model, numbers, vectors.size() * sizeof(glm::vec3), target);
  const int accessor =
      add_accessor(model, view, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, vectors.size());
  if (has_bounds) set_bounds(model.accessors[accessor], numbers, vectors.size(), 3, false);
  return accessor;
}

int add_pairs(tinygltf::Model& model, const std::vector<glm::vec2>& pairs, int target) {
  check_finite(&pairs.front().x, 2 * pairs.size());
  const int view = add_raw_view(model, pairs.data(), pairs.size() * sizeof(glm::vec2), target);
  return add_accessor(model, view, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC2, pairs.size());
}

int add_bytes(tinygltf::Model& model, const std::vector<glm::u8vec4>& bytes, bool is_normalized, int target) {
  const int view = add_raw_view(model, bytes.data(), bytes.size() * sizeof(glm::u8vec4), target);
  const int accessor =
      add_accessor(model, view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_TYPE_VEC4, bytes.size());
  model.accessors[accessor].normalized = is_normalized;
  return accessor;
}

int add_shares(tinygltf::Model& model, const std::vector<glm::u16vec4>& shares, int target) {
  const int view = add_raw_view(model, shares.data(), shares.size() * sizeof(glm::u16vec4), target);
  const int accessor =
      add_accessor(model, view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_VEC4, shares.size());
  model.accessors[accessor].normalized = true;
  return accessor;
}

int add_indices(tinygltf::Model& model, const std::vector<Triangle>& triangles) {
  const int view = add_raw_view(model, triangles.data(), triangles.size() * sizeof(Triangle),
                                TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  return add_accessor(model, view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR,
                      3 * triangles.size());
}

int add_scalars(tinygltf::Model& model, const std::vector<float>& scalars, bool has_bounds) {
  check_finite(scalars.data(), scalars.size());
  const int view = add_raw_view(model, scalars.data(), scalars.size() * sizeof(float), 0);
  const int accessor =
      add_accessor(model, view, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_SCALAR, scalars.size());
  if (has_bounds) set_bounds(model.accessors[accessor], scalars.data(), scalars.size(), 1, false);
  return accessor;
}

int add_turns(tinygltf::Model& model, const std::vector<glm::quat>& turns) {
  std::vector<glm::vec4> numbers;  // x, y, z, w
  for (const glm::quat& turn : turns) numbers.emplace_back(turn.x, turn.y, turn.z, turn.w);
  check_finite(&numbers.front().x, 4 * numbers.size());
  const int view = add_raw_view(model, numbers.data(), numbers.size() * sizeof(glm::vec4), 0);
  return add_accessor(model, view, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC4, numbers.size());
}

int add_matrices(tinygltf::Model& model, const std::vector<glm::mat4>& matrices) {
  const int view = add_raw_view(model, matrices.data(), matrices.size() * sizeof(glm::mat4), 0);
  return add_accessor(model, view, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_MAT4, matrices.size());
}

int add_sparse_vectors(tinygltf::Model& model, std::size_t count, const VertexOffsets& offsets,
                       bool has_bounds) {
  const float* numbers = &offsets.offsets.front().x;
  check_finite(numbers, 3 * offsets.offsets.size());
  const int indices = add_raw_view(model, offsets.vertices.data(), offsets.vertices.size() * 4, 0);
  const int values = add_raw_view(model, numbers, offsets.offsets.size() * sizeof(glm::vec3), 0);
  const int at = add_accessor(model, -1, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, count);
  tinygltf::Accessor& accessor = model.accessors[at];
  accessor.sparse.isSparse = true;
  accessor.sparse.count = static_cast<int>(offsets.vertices.size());
  accessor.sparse.indices.bufferView = indices;
  accessor.sparse.indices.byteOffset = 0;
  accessor.sparse.indices.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  accessor.sparse.values.bufferView = values;
  accessor.sparse.values.byteOffset = 0;
  if (has_bounds) set_bounds(accessor, numbers, offsets.offsets.size(), 3, offsets.vertices.size() < count);
  return at;
}

int add_view(tinygltf::Model& model, const std::string& bytes) {
  return add_raw_view(model, bytes.data(), bytes.size(), 0);
}

}  // namespace mien

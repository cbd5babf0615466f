// What a shape adds to some of a mesh's vertices.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace mien {

// Example: vertices {3, 7}, offsets {(0,1,0), (0,2,0)} lift two vertices of all.
struct VertexOffsets {
  std::vector<std::uint32_t> vertices;  // rising
  std::vector<glm::vec3> offsets;       // mm, one of each
};

}  // namespace mien

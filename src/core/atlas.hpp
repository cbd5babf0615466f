// A surface laid flat, so that a picture can be painted over it.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/mesh.hpp"

namespace mien {

// Where the layout is cut, a vertex of the surface is there twice: each atlas vertex is one of the surface's.
struct Atlas {
  std::vector<glm::vec2> places;        // of each atlas vertex, 0..1: x to the right, y up
  std::vector<std::uint32_t> vertices;  // the surface's vertex that each is
  std::vector<Triangle> triangles;      // the surface's, in their order, of atlas vertices
};

}  // namespace mien

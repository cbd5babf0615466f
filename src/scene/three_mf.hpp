// 3MF: a print with its unit, its name and its colours.
#pragma once

#include <string>
#include <vector>

#include "core/mesh.hpp"

namespace mien {

// The colour of some triangles of an object.
struct ColourRange {
  std::string name;
  glm::vec3 srgb{0.8f};              // 0..1
  std::size_t first = 0, count = 0;  // triangles; ranges do not overlap
};

// A closed solid, wound outwards, mm, z up; where it lies on the plate is in its positions.
struct PrintObject {
  std::string name;
  Mesh mesh;
  std::vector<ColourRange> colours;  // triangles in no range have the first one's
};

// The content of a .3mf file, by lib3mf: the same bytes for the same objects. Any text may be in title and
// names. Throws RunError "internal: a mesh holds a number that is not finite".
std::string build_3mf(const std::string& title, const std::vector<PrintObject>& objects);

}  // namespace mien

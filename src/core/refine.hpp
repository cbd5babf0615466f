// More triangles where detail is to stand, none elsewhere, and no cracks between.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh.hpp"

namespace mien {

// Splits each triangle with a marked corner into four, and its neighbours so that no edge opens.
// `mesh.normals` are needed: a new vertex is lifted off its edge onto the curve that the normals at both ends
// suggest (Phong tessellation, Boubekeur and Alexa 2008). `marks` (one a vertex) and normals grow with the
// mesh: a new vertex is marked if both ends of its edge are. Old vertices keep their index. Returns the ends
// of the edge in whose middle each new vertex stands.
std::vector<std::array<std::uint32_t, 2>> refine_marked(Mesh& mesh, std::vector<bool>& marks);

// Where a new vertex stands between two ends with unit normals.
glm::vec3 compute_middle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& normal_a,
                         const glm::vec3& normal_b);

}  // namespace mien

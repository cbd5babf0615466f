// The half head as a mesh that people edit, and back.
#pragma once

#include "head/wrap.hpp"

namespace mien {

// Where the points of the half lie, in the order of half_points.csv: on the skin; hard ones as the control
// points that they are. Rounded to the digits that an OBJ file holds, so that what is read back is equal.
std::vector<glm::dvec3> compute_half_places(const HeadStock& stock, const std::vector<glm::dvec3>& points);

// The faces of half_quads.csv over these points.
std::vector<Quad> compute_half_quads(const HeadStock& stock);

// The shipped adult with its half moved to the mesh of `file`: the same faces, either side of the mid-plane.
// A mesh that equals the shipped half gives the shipped head bit for bit. The eyeball follows the lids. Half
// a head of other faces is wrapped as a scan is. Throws InputError for a file that is no such half.
Wrap build_own_half(const HeadStock& stock, const std::filesystem::path& file);

}  // namespace mien

// Ears, lids and lips thick enough to print.
#pragma once

#include <vector>

#include "core/mesh.hpp"

namespace mien {

// For each vertex of `body` (closed, or open along edges that stay where they are) how far to move it, so
// that the body is at least `least_mm` thick as measure_thickness_mm has it. Both sides of what is thin move
// apart, along their normals, fading out over its neighbours; never so far that a triangle turns over, or
// into what is opposite in the air: what remains thin for that is for the report to tell. Nothing moves where
// z is 0. Mirror-symmetric bodies give mirror-symmetric moves.
std::vector<glm::vec3> compute_thickening(const Mesh& body, double least_mm);

// Takes back those of the moves that lead the surface of any of the poses through itself where it did not
// before, in a wider and wider circle up to three times `least_mm`. The same for any number of threads.
void hold_apart(const std::vector<std::vector<glm::vec3>>& poses, const std::vector<Triangle>& triangles,
                double least_mm, std::vector<glm::vec3>& moves);

}  // namespace mien

// A cloud of points as a surface of little triangles, each in the plane of its neighbours.
#pragma once

#include <string_view>
#include <vector>

#include "import/polygons.hpp"

namespace mien {

// Fewer points tell of no surface.
inline constexpr std::size_t kLeastCloudPoints = 100;

// Throws InputError if the mesh has neither faces nor points enough; `points` is what they are called.
void check_cloud_size(const Polygons& mesh, std::string_view points = "points");

struct CloudSurface {
  Polygons mesh;           // three corners a point, counter-clockwise from outside
  std::vector<bool> rims;  // of each corner: the cloud ends beside its point
};

// `cloud` has kLeastCloudPoints positions at least and no faces. Dense clouds are thinned to some ten
// thousand points, each the mean of those around it. Outward is where the cloud's normals point, if it has
// any, else away from its middle, and from there on what neighbours agree about. The same cloud gives the
// same surface, always.
CloudSurface build_cloud_surface(const Polygons& cloud);

}  // namespace mien

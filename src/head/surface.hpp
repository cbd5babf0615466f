// The smooth skin of a cage: Catmull-Clark limit positions as weighted sums of control points, computed once.
#pragma once

#include <cstdint>
#include <vector>

#include "core/float4.hpp"
#include "head/head.hpp"
#include "head/pairs.hpp"

namespace mien {

// A left quad by its corners' slots; bit i of `middle` says that corner i lies on the mid-plane.
struct PairedQuad {
  Quad slots{};
  std::uint32_t middle = 0;
};

// Fine vertex v is the sum over [first[v], first[v + 1]) of weight * control point. Vertex i is cage point i
// for i below the number of cage points. Fixed for a cage's quads: every head and every pose shares it.
struct Surface {
  std::vector<std::uint32_t> first;  // one more than there are vertices
  std::vector<std::uint32_t> point;  // index of the control point
  std::vector<float> weight;
  std::vector<Quad> quads;  // of the fine mesh, counter-clockwise from outside: each left one and then its
                            // mirror image; 32 in a row lie in one quad of the cage's left half and its image
  std::vector<std::uint32_t> mirror;  // the fine vertex that is the mirror image
  std::vector<MirrorPair> pairs;  // all vertices: those of left quads and their images, or of the mid-plane
  std::vector<PairedQuad> pair_quads;  // every other one of `quads`, and with it the one behind it

  std::size_t vertex_count() const { return first.empty() ? 0 : first.size() - 1; }
};

// Two levels of Catmull-Clark (OpenSubdiv), pushed to the limit. The rows of mirror images hold mirrored
// points in the same order, and quads come in pairs: a mirrored cage gives bit for bit the mirrored skin and
// normals, and a mirror-symmetric one a mid-plane of x exactly 0. The cage's quads must be those of its left
// half and then their mirror images in the same order.
Surface build_surface(const Cage& cage);

// The skin of `points` (the cage's, deformed), into `positions` (resized). For every frame: deform_pairs and
// update_pair_normals, which leave out the packing.
void deform_surface(const Surface& surface, const std::vector<Float4>& points,
                    std::vector<glm::vec3>& positions);

// The same surface for those who ask for some vertices only: all others have empty rows, which deform_surface
// puts at 0, and the quads are those around the vertices with a wanted normal. Mirror images are wanted as
// well. Both have a value for each fine vertex.
Surface select_vertices(const Surface& surface, std::vector<bool> is_wanted,
                        const std::vector<bool>& is_normal_wanted);

// The same for one number a control point: a mask, a weight. Values are averages of neighbours, so a mask
// stays within its range but for a little overshoot nowhere: all weights are positive.
std::vector<float> spread_over_surface(const Surface& surface, const std::vector<double>& values);

// Each quad as two triangles along its shorter diagonal at `positions`, mirror images alike.
std::vector<Triangle> split_quads(const Surface& surface, const std::vector<glm::vec3>& positions);

// Area-weighted vertex normals from the fine quads, into `normals` (resized). Quick: for every frame.
void update_surface_normals(const Surface& surface, const std::vector<glm::vec3>& positions,
                            std::vector<glm::vec3>& normals);

// Control points as the four-float rows that deform_surface wants, into `packed` (resized).
void pack_points(const std::vector<glm::dvec3>& points, std::vector<Float4>& packed);

}  // namespace mien

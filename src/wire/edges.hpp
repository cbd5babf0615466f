// The edges of a surface that are drawn whatever its net: where it turns away from who looks, where it ends,
// where it is sharp.
#pragma once

#include "wire/camera.hpp"
#include "wire/solid.hpp"

namespace mien {

// One edge with the triangles on both sides of it.
struct WireEdge {
  static constexpr std::uint32_t kNone = 0xffffffffU;
  std::uint32_t from = 0, to = 0;
  std::uint32_t left = 0, right = kNone;  // triangles; a border has one, of an edge of more the first two
};

// Each edge once, in a fixed order.
std::vector<WireEdge> list_edges(const std::vector<Triangle>& triangles);

// Contours, borders and sharp edges of a solid, joined to lines as long as they go. A contour is what the
// outline of the polyhedron is made of: an edge between a triangle that faces the camera and one that does
// not.
std::vector<WireLine> list_edge_lines(const WireSolid& solid, const std::vector<WireEdge>& edges,
                                      const WireCamera& camera);

}  // namespace mien

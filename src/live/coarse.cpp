#include "live/coarse.hpp"

#include <algorithm>
#include <numeric>

#include "core/thin.hpp"

namespace mien {

namespace {

constexpr std::size_t kSmall = 120;       // triangles of a part that is left as it is
constexpr std::size_t kClosedShare = 20;  // one triangle in so many stays
constexpr std::size_t kPieceShare = 6;    // one piece in so many stays
constexpr std::size_t kManyPieces = 20;   // a part of so many is of hairs

std::uint32_t find_root(std::vector<std::uint32_t>& parent, std::uint32_t v) {
  while (parent[v] != v) v = parent[v] = parent[parent[v]];
  return v;
}

// Of each triangle the piece that hangs together with it, counted from 0; returns how many there are.
std::size_t find_pieces(const std::vector<Triangle>& triangles, std::size_t count,
                        std::vector<std::size_t>& of) {
  std::vector<std::uint32_t> parent(count);
  std::iota(parent.begin(), parent.end(), 0u);
  for (const Triangle& triangle : triangles)
    for (const std::uint32_t corner : {triangle[1], triangle[2]})
      parent[find_root(parent, corner)] = find_root(parent, triangle[0]);
  std::vector<std::size_t> number(count, count);  // by its root
  std::size_t pieces = 0;
  for (const Triangle& triangle : triangles) {
    std::size_t& piece = number[find_root(parent, triangle[0])];
    if (piece == count) piece = pieces++;
    of.push_back(piece);
  }
  return pieces;
}

}  // namespace

std::vector<Triangle> take_pieces(const ViewPart& part) {
  std::vector<Triangle> taken;
  std::vector<std::size_t> piece;
  if (find_pieces(part.triangles, part.vertices.size(), piece) <= kManyPieces) return taken;
  for (std::size_t i = 0; i < piece.size(); ++i)
    if (piece[i] % kPieceShare == 0) taken.push_back(part.triangles[i]);
  return taken;
}

std::vector<Triangle> build_coarse(const ViewPart& part, const Mesh& rest) {
  if (part.triangles.size() <= kSmall) return part.triangles;
  if (!part.pieces.empty()) return part.pieces;
  const std::size_t count = part.vertices.size();
  std::vector<glm::vec3> places;
  for (const std::uint32_t vertex : part.vertices) places.push_back(rest.positions[vertex]);
  return thin_posed({places}, part.triangles, std::vector<bool>(count, false),
                    std::max(part.triangles.size() / kClosedShare, kSmall));
}

}  // namespace mien

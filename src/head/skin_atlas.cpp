#include "head/skin_atlas.hpp"

#include <Eigen/Sparse>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/error.hpp"

namespace mien {

namespace {

using Places = std::vector<glm::vec3>;

// The cut ends where the skin's mid-line has come this far forward of upright over the middle of the head.
constexpr double kCutEnd_deg = 35;
constexpr double kFaceHeight = 0.58;  // of the face's middle in the square, before it is given room

struct CutSkin {
  Places positions;
  std::vector<std::uint32_t> vertices, mirror;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> seam;  // of the skin, from the neck up; the last is not doubled
};

// The neighbours of mid-plane vertices within it.
std::map<std::uint32_t, std::set<std::uint32_t>> list_middle_edges(const std::vector<Triangle>& triangles,
                                                                   const std::vector<std::uint32_t>& mirror) {
  std::map<std::uint32_t, std::set<std::uint32_t>> edges;
  for (const Triangle& triangle : triangles)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3];
      if (mirror[a] != a || mirror[b] != b) continue;
      edges[a].insert(b);
      edges[b].insert(a);
    }
  return edges;
}

// The vertices behind, from the neck's edge up and over the crown.
std::vector<std::uint32_t> find_seam(const Places& positions, const std::vector<Triangle>& triangles,
                                     const std::vector<std::uint32_t>& mirror) {
  const auto edges = list_middle_edges(triangles, mirror);
  std::uint32_t at = 0;
  bool has_begin = false;
  for (const auto& [v, next] : edges) {
    if (next.size() != 1) continue;  // an end of the mid-line
    if (!has_begin || positions[v].z < positions[at].z) at = v;
    has_begin = true;
  }
  if (!has_begin) throw RunError("internal: the skin has no mid-line that ends at the neck");
  const Box box = compute_bounds(positions);
  const glm::vec3 middle(0, glm::mix(box.low.y, box.high.y, 0.7f), 0.5f * (box.low.z + box.high.z));
  std::vector<std::uint32_t> seam{at};
  for (std::uint32_t before = at;;) {
    std::uint32_t next = at;
    for (const std::uint32_t v : edges.at(at))
      if (v != before && std::ranges::find(seam, v) == seam.end()) next = v;
    if (next == at) throw RunError("internal: the skin's mid-line does not reach the crown");
    before = at;
    at = next;
    seam.push_back(at);
    const glm::vec3 from = positions[at] - middle;
    if (from.y > 0 && from.z > 0 && glm::degrees(std::atan2(from.z, from.y)) > kCutEnd_deg) return seam;
  }
}

CutSkin cut_skin(const Places& positions, const std::vector<Triangle>& triangles,
                 const std::vector<std::uint32_t>& mirror) {
  CutSkin cut{positions, {}, mirror, triangles, find_seam(positions, triangles, mirror)};
  for (std::uint32_t v = 0; v < positions.size(); ++v) cut.vertices.push_back(v);
  std::map<std::uint32_t, std::uint32_t> second;  // the right half's
  for (std::size_t i = 0; i + 1 < cut.seam.size(); ++i) {
    const std::uint32_t v = cut.seam[i];
    const auto other = static_cast<std::uint32_t>(cut.positions.size());
    second[v] = other;
    cut.positions.push_back(positions[v]);
    cut.vertices.push_back(v);
    cut.mirror[v] = other;
    cut.mirror.push_back(v);
  }
  for (Triangle& triangle : cut.triangles) {
    const float x = positions[triangle[0]].x + positions[triangle[1]].x + positions[triangle[2]].x;
    if (x >= 0) continue;
    for (std::uint32_t& v : triangle)
      if (const auto found = second.find(v); found != second.end()) v = found->second;
  }
  return cut;
}

// The mesh's rims, each as the vertices round it, the longest first.
std::vector<std::vector<std::uint32_t>> find_rims(const std::vector<Triangle>& triangles) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Triangle& triangle : triangles)
    for (int k = 0; k < 3; ++k) edges.emplace(triangle[k], triangle[(k + 1) % 3]);
  std::map<std::uint32_t, std::uint32_t> next;  // along the rim, as the missing triangle would have it
  for (const auto& [a, b] : edges)
    if (!edges.contains({b, a})) next[b] = a;
  std::vector<std::vector<std::uint32_t>> rims;
  while (!next.empty()) {
    std::vector<std::uint32_t> rim;
    std::uint32_t at = next.begin()->first;
    for (auto step = next.find(at); step != next.end(); step = next.find(at)) {
      rim.push_back(at);
      at = step->second;
      next.erase(step);
    }
    rims.push_back(std::move(rim));
  }
  std::ranges::sort(rims, std::ranges::greater{}, &std::vector<std::uint32_t>::size);
  return rims;
}

// How far along a line of vertices each of them is, 0..1.
std::vector<double> measure_along(const Places& positions, const std::vector<std::uint32_t>& line) {
  std::vector<double> along{0};
  for (std::size_t i = 1; i < line.size(); ++i)
    along.push_back(along.back() + glm::distance(positions[line[i - 1]], positions[line[i]]));
  for (double& share : along) share /= along.back();
  return along;
}

// The rim on the square: the cut up the sides and along the top, the neck along the bottom.
std::map<std::uint32_t, glm::dvec2> lay_rim(const CutSkin& cut, const std::vector<std::uint32_t>& rim) {
  std::map<std::uint32_t, glm::dvec2> places;
  const std::vector<double> along = measure_along(cut.positions, cut.seam);
  const auto crown =
      std::ranges::max_element(cut.seam, {}, [&](std::uint32_t v) { return cut.positions[v].y; });
  const double corner = along[crown - cut.seam.begin()];
  for (std::size_t i = 0; i < cut.seam.size(); ++i) {
    const double s = along[i];
    const glm::dvec2 place =
        s <= corner ? glm::dvec2(1, s / corner) : glm::dvec2(1 - 0.5 * (s - corner) / (1 - corner), 1);
    places[cut.seam[i]] = place;
    if (i + 1 < cut.seam.size()) places[cut.mirror[cut.seam[i]]] = {1 - place.x, place.y};
  }
  std::vector<std::uint32_t> neck = rim;
  std::rotate(neck.begin(), std::ranges::find(neck, cut.seam.front()), neck.end());
  if (neck[1] == cut.seam[1]) std::reverse(neck.begin() + 1, neck.end());
  neck.erase(std::ranges::find(neck, cut.mirror[cut.seam.front()]) + 1, neck.end());
  const std::vector<double> round = measure_along(cut.positions, neck);
  for (std::size_t i = 1; i + 1 < neck.size(); ++i) places[neck[i]] = {1 - round[i], 0};
  return places;
}

struct Weight {
  std::uint32_t from, to;
  double weight;
};

std::vector<Weight> list_mean_values(const Places& positions, const std::vector<Triangle>& triangles) {
  std::vector<Weight> weights;
  for (const Triangle& triangle : triangles)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t at = triangle[k], b = triangle[(k + 1) % 3], c = triangle[(k + 2) % 3];
      const glm::dvec3 to_b(positions[b] - positions[at]), to_c(positions[c] - positions[at]);
      const double far_b = std::max(glm::length(to_b), 1e-6), far_c = std::max(glm::length(to_c), 1e-6);
      const double cosine = std::clamp(glm::dot(to_b, to_c) / (far_b * far_c), -0.999, 1.0);
      const double half = std::max(std::sqrt((1 - cosine) / (1 + cosine)), 1e-3);  // tan of half the angle
      weights.push_back({at, b, half / far_b});
      weights.push_back({at, c, half / far_c});
    }
  return weights;
}

// Each vertex that is not on the rim is the mean of its neighbours.
std::vector<glm::dvec2> solve_means(std::size_t count, const std::vector<Weight>& weights,
                                    const std::map<std::uint32_t, glm::dvec2>& rim) {
  std::vector<double> sums(count, 0);
  for (const Weight& weight : weights) sums[weight.from] += weight.weight;
  std::vector<Eigen::Triplet<double>> rows;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(static_cast<Eigen::Index>(count), 2);
  for (std::uint32_t v = 0; v < count; ++v) {
    rows.emplace_back(v, v, 1);
    if (const auto found = rim.find(v); found != rim.end()) right.row(v) << found->second.x, found->second.y;
  }
  for (const Weight& weight : weights)
    if (!rim.contains(weight.from))
      rows.emplace_back(weight.from, weight.to, -weight.weight / sums[weight.from]);
  Eigen::SparseMatrix<double> matrix(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(count));
  matrix.setFromTriplets(rows.begin(), rows.end());
  Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(matrix);
  if (solver.info() != Eigen::Success) throw RunError("internal: the skin cannot be laid flat");
  const Eigen::MatrixX2d solved = solver.solve(right);
  std::vector<glm::dvec2> places;
  for (Eigen::Index v = 0; v < solved.rows(); ++v) places.emplace_back(solved(v, 0), solved(v, 1));
  return places;
}

// More room for the middle, where the face is: steady and rising, so that nothing comes to overlap.
double widen_middle(double at, double middle) {
  constexpr double kSteep = 1.6;  // in the middle; 2 - 1.6 at the far end
  const auto widen = [](double off) { return off * (kSteep - (kSteep - 1) * std::abs(off)); };
  const double far = std::max(middle, 1 - middle);
  const double low = widen(-middle / far), high = widen((1 - middle) / far);
  return (widen((at - middle) / far) - low) / (high - low);
}

}  // namespace

Atlas build_skin_atlas(const Places& positions, const std::vector<Triangle>& triangles,
                       const std::vector<std::uint32_t>& mirror) {
  CutSkin cut = cut_skin(positions, triangles, mirror);
  const std::vector<std::vector<std::uint32_t>> rims = find_rims(cut.triangles);
  if (rims.size() != 3) throw RunError("internal: the skin is not open at neck and eyes alone");
  const std::map<std::uint32_t, glm::dvec2> rim = lay_rim(cut, rims.front());
  // Eye openings are closed by fans.
  const std::size_t count = cut.positions.size();
  Places closed = cut.positions;
  std::vector<Triangle> all = cut.triangles;
  for (std::size_t r = 1; r < rims.size(); ++r) {
    glm::vec3 middle(0);
    for (const std::uint32_t v : rims[r]) middle += closed[v] / static_cast<float>(rims[r].size());
    for (std::size_t i = 0; i < rims[r].size(); ++i)
      all.push_back(
          {rims[r][i], rims[r][(i + 1) % rims[r].size()], static_cast<std::uint32_t>(closed.size())});
    closed.push_back(middle);
  }
  const std::vector<glm::dvec2> laid = solve_means(closed.size(), list_mean_values(closed, all), rim);
  Atlas atlas{{}, cut.vertices, cut.triangles};
  for (std::uint32_t v = 0; v < count; ++v) {
    // Both halves are alike to the last bit.
    const glm::dvec2 image = laid[cut.mirror[v]];
    const double right = widen_middle(0.5 * (laid[v].x + 1 - image.x), 0.5);
    atlas.places.emplace_back(right, widen_middle(0.5 * (laid[v].y + image.y), kFaceHeight));
  }
  return atlas;
}

}  // namespace mien

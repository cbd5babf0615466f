// Ear clipping (Meisters 1975) after each hole was joined to the outline by a bridge: David Eberly,
// "Triangulation by Ear Clipping" (2002).
#include "print/flat_cap.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace mien {

namespace {

constexpr const char* kMisfit = "the holes of the underside do not fit into its outline";

// The plane seen from below: outlines run counter-clockwise, holes clockwise.
struct Plan {
  const std::vector<glm::vec3>& positions;

  glm::dvec2 at(std::uint32_t v) const { return {positions[v].x, -double(positions[v].y)}; }
  // Twice the signed area of a triangle.
  double turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const glm::dvec2 u = at(b) - at(a), v = at(c) - at(a);
    return u.x * v.y - u.y * v.x;
  }
  double measure_area(const Loop& loop) const {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const glm::dvec2 a = at(loop[i]), b = at(loop[(i + 1) % loop.size()]);
      sum += (a.x * b.y - a.y * b.x) / 2;
    }
    return sum;
  }
  // Whether the segments meet; those that share a vertex do not.
  bool crosses(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    if (a == c || a == d || b == c || b == d) return false;
    return turn(a, b, c) * turn(a, b, d) <= 0 && turn(c, d, a) * turn(c, d, b) <= 0;
  }
  bool crosses(std::uint32_t a, std::uint32_t b, const Loop& loop) const {
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (crosses(a, b, loop[i], loop[(i + 1) % loop.size()])) return true;
    return false;
  }
};

struct Bridge {
  double square_mm2 = 0;
  std::size_t hole = 0, from = 0, to = 0;  // positions in the hole's loop and in the walk
};

// Takes the nearest hole that sees the walk into it.
void join_hole(const Plan& plan, Loop& walk, std::vector<Loop>& holes) {
  std::vector<Bridge> bridges;
  for (std::size_t h = 0; h < holes.size(); ++h)
    for (std::size_t i = 0; i < holes[h].size(); ++i)
      for (std::size_t j = 0; j < walk.size(); ++j) {
        const glm::dvec2 way = plan.at(holes[h][i]) - plan.at(walk[j]);
        bridges.push_back({glm::dot(way, way), h, i, j});
      }
  std::stable_sort(bridges.begin(), bridges.end(),
                   [](const Bridge& a, const Bridge& b) { return a.square_mm2 < b.square_mm2; });
  for (const Bridge& bridge : bridges) {
    const Loop& hole = holes[bridge.hole];
    const std::uint32_t a = hole[bridge.from], b = walk[bridge.to];
    if (std::count(walk.begin(), walk.end(), b) > 1) continue;  // a bridge ends here already
    if (plan.crosses(a, b, walk) ||
        std::any_of(holes.begin(), holes.end(), [&](const Loop& other) { return plan.crosses(a, b, other); }))
      continue;
    Loop way(hole.begin() + bridge.from, hole.end());
    way.insert(way.end(), hole.begin(), hole.begin() + bridge.from + 1);
    way.push_back(b);
    walk.insert(walk.begin() + bridge.to + 1, way.begin(), way.end());
    holes.erase(holes.begin() + bridge.hole);
    return;
  }
  throw RunError(kMisfit);
}

// How good an ear the corner `at` of the walk is, or below 0 if it is none.
double rate_ear(const Plan& plan, const Loop& walk, std::size_t at) {
  const std::size_t n = walk.size();
  const std::uint32_t a = walk[(at + n - 1) % n], b = walk[at], c = walk[(at + 1) % n];
  const double area = plan.turn(a, b, c);
  if (area <= 0) return -1;
  for (const std::uint32_t v : walk) {
    if (v == a || v == b || v == c) continue;
    if (plan.turn(a, b, v) >= 0 && plan.turn(b, c, v) >= 0 && plan.turn(c, a, v) >= 0) return -1;
  }
  const glm::dvec2 p = plan.at(a), q = plan.at(b), r = plan.at(c);
  return area / std::max({glm::dot(q - p, q - p), glm::dot(r - q, r - q), glm::dot(p - r, p - r)});
}

}  // namespace

void append_flat_cap(Mesh& mesh, const Loop& outline, const std::vector<Loop>& holes) {
  mesh.normals.clear();
  const Plan plan{mesh.positions};
  double area = plan.measure_area(outline);
  for (const Loop& hole : holes) area += plan.measure_area(hole);
  Loop walk = outline;
  for (std::vector<Loop> left = holes; !left.empty();) join_hole(plan, walk, left);

  double filled = 0;
  std::vector<double> rating(walk.size());
  for (std::size_t i = 0; i < walk.size(); ++i) rating[i] = rate_ear(plan, walk, i);
  while (walk.size() >= 3) {
    const std::size_t n = walk.size();
    const auto at = static_cast<std::size_t>(std::max_element(rating.begin(), rating.end()) - rating.begin());
    if (rating[at] < 0) throw RunError(kMisfit);
    const Triangle ear{walk[(at + n - 1) % n], walk[at], walk[(at + 1) % n]};
    filled += plan.turn(ear[0], ear[1], ear[2]) / 2;
    mesh.triangles.push_back(ear);
    walk.erase(walk.begin() + at);
    rating.erase(rating.begin() + at);
    for (std::size_t i = 0; i < walk.size(); ++i)  // any may have come free of what hid it
      if (rating[i] < 0 || i == at % walk.size() || i == (at + walk.size() - 1) % walk.size())
        rating[i] = rate_ear(plan, walk, i);
  }
  if (!(std::abs(filled - area) <= 1e-6 * std::abs(area))) throw RunError(kMisfit);
}

}  // namespace mien

#include "head/lip_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "head/cage.hpp"

namespace mien {

namespace {

// The column of a point of the lips' rings, counted from the middle of either lip; -1 for any other point.
int compute_lip_column(std::string_view name, bool is_upper) {
  for (const char* ring : kLipRings)
    if (const int column = compute_ring_column(name, ring); column >= 0)
      return is_upper ? column : 2 * kLipColumns - column;
  return -1;
}

std::uint32_t find_slot(const LipSheet& sheet, std::uint32_t vertex) {
  return static_cast<std::uint32_t>(std::ranges::lower_bound(sheet.vertices, vertex) -
                                    sheet.vertices.begin());
}

// A quad of a sheet, and where it lies: only a vertex within can be over it.
struct StripQuad {
  std::uint32_t quad = 0;
  double nearest = 0;  // y of the corner that is furthest toward the other lip, up or down as `sign` says
  double low_z = 0, high_z = 0;
};

// The quads of a sheet by their places along x, so that a vertex is asked only where it can be.
struct Strips {
  static constexpr std::size_t kCount = 48;
  double low = 0, step = 1;
  std::array<std::vector<StripQuad>, kCount> quads;

  std::size_t find(double x) const {
    return static_cast<std::size_t>(std::clamp((x - low) / step, 0.0, kCount - 1.0));
  }
};

void fill_strips(const LipSheet& sheet, const std::vector<glm::dvec3>& at, double sign, Strips& strips) {
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
  for (const glm::dvec3& p : at) {
    low = std::min(low, p.x);
    high = std::max(high, p.x);
  }
  strips.low = low;
  strips.step = std::max(1e-6, high - low) / Strips::kCount;
  for (auto& strip : strips.quads) strip.clear();
  for (std::uint32_t q = 0; q < sheet.quads.size(); ++q) {
    const auto& [i, j, k, l] = sheet.quads[q];
    const auto [from, to] = std::minmax({at[i].x, at[j].x, at[k].x, at[l].x});
    const auto [low_z, high_z] = std::minmax({at[i].z, at[j].z, at[k].z, at[l].z});
    const double nearest = std::max({sign * at[i].y, sign * at[j].y, sign * at[k].y, sign * at[l].y});
    const std::size_t last = strips.find(to);
    for (std::size_t s = strips.find(from); s <= last; ++s)
      strips.quads[s].push_back({q, nearest, low_z, high_z});
  }
}

// The height of a triangle straight above or below `p`, into `y`. False where it is not.
bool find_height(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& p,
                 double& y) {
  constexpr double kEdge = 1e-9;  // of a triangle: what lies on its edge is over it
  const double area = (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x);
  if (std::abs(area) < kEdge) return false;
  const double u = ((b.x - p.x) * (c.z - p.z) - (b.z - p.z) * (c.x - p.x)) / area;
  const double w = ((a.x - p.x) * (b.z - p.z) - (a.z - p.z) * (b.x - p.x)) / area;
  if (u < -kEdge || w < -kEdge || u + w > 1 + kEdge) return false;
  y = u * a.y + w * c.y + (1 - u - w) * b.y;
  return true;
}

// `sign` is 1 if `one` is the upper lip.
void compute_shortfalls_of(const LipSheet& one, const std::vector<glm::dvec3>& at, const LipSheet& other,
                           const std::vector<glm::dvec3>& other_at, double sign, double apart_mm,
                           LipShortfalls& shortfalls) {
  static thread_local Strips strips;  // kept: it is filled for every frame
  fill_strips(other, other_at, sign, strips);
  for (std::size_t v = 0; v < at.size(); ++v) {
    const glm::dvec3& p = at[v];
    const double wanted = apart_mm * std::clamp(kLipColumns - one.column[v], 0.0, 1.0);
    for (const StripQuad& strip : strips.quads[strips.find(p.x)]) {
      if (sign * p.y - strip.nearest >= wanted || p.z < strip.low_z || p.z > strip.high_z) continue;
      const auto& quad = other.quads[strip.quad];
      const glm::dvec3 &a = other_at[quad[0]], &b = other_at[quad[1]], &c = other_at[quad[2]],
                       &d = other_at[quad[3]];
      if (std::ranges::any_of(quad, [&](auto i) { return other.vertices[i] == one.vertices[v]; })) continue;
      double y = 0;
      for (const bool is_first : {true, false}) {
        if (!(is_first ? find_height(a, b, c, p, y) : find_height(a, c, d, p, y))) continue;
        const double shortfall = wanted - sign * (p.y - y);
        if (shortfall <= 0) continue;
        for (int column = 0; column < kLipColumns; ++column)
          if (const double near = 1 - std::abs(one.column[v] - column); near > 0)
            shortfalls[column] = std::max(shortfalls[column], shortfall * near);
      }
    }
  }
}

}  // namespace

int compute_ring_column(std::string_view name, std::string_view ring) {
  name = strip_side(name);
  if (!name.starts_with(ring)) return -1;
  int column = 0;
  for (const char digit : name.substr(ring.size())) column = 10 * column + (digit - '0');
  return column;
}

LipSheet build_lip_sheet(const Surface& surface, const Cage& cage, bool is_upper) {
  std::vector<int> column(cage.points.size());
  for (std::size_t i = 0; i < column.size(); ++i) column[i] = compute_lip_column(cage.names[i], is_upper);
  const auto is_of_lip = [&](std::uint32_t p) { return column[p] >= 0 && column[p] <= kLipColumns; };
  LipSheet sheet;
  std::vector<Quad> quads;
  for (std::size_t q = 0; q < cage.quads.size() / 2; ++q)
    if (std::ranges::all_of(cage.quads[q], is_of_lip))
      for (std::size_t i = 0; i < 32; i += 2) quads.push_back(surface.quads[32 * q + i]);
  for (const Quad& quad : quads) sheet.vertices.insert(sheet.vertices.end(), quad.begin(), quad.end());
  std::ranges::sort(sheet.vertices);
  sheet.vertices.erase(std::unique(sheet.vertices.begin(), sheet.vertices.end()), sheet.vertices.end());
  for (const Quad& quad : quads)
    sheet.quads.push_back({find_slot(sheet, quad[0]), find_slot(sheet, quad[1]), find_slot(sheet, quad[2]),
                           find_slot(sheet, quad[3])});
  sheet.first.push_back(0);
  for (const std::uint32_t v : sheet.vertices) {
    double sum = 0, weights = 0;
    for (std::uint32_t k = surface.first[v]; k < surface.first[v + 1]; ++k) {
      const std::uint32_t point = surface.point[k];
      sheet.left.push_back(point);
      sheet.right.push_back(cage.mirror[point]);
      sheet.weight.push_back(surface.weight[k]);
      if (column[point] < 0) continue;
      sum += surface.weight[k] * static_cast<double>(column[point]);
      weights += surface.weight[k];
    }
    sheet.first.push_back(static_cast<std::uint32_t>(sheet.left.size()));
    sheet.column.push_back(weights > 0 ? sum / weights : kLipColumns);
  }
  return sheet;
}

void place_lip(const LipSheet& sheet, const std::vector<glm::dvec3>& points, Side side,
               std::vector<glm::dvec3>& at) {
  const bool is_right = side == Side::right;
  const std::vector<std::uint32_t>& own = is_right ? sheet.right : sheet.left;
  at.resize(sheet.vertices.size());
  for (std::size_t v = 0; v < at.size(); ++v) {
    glm::dvec3 sum(0);
    for (std::uint32_t k = sheet.first[v]; k < sheet.first[v + 1]; ++k)
      sum += sheet.weight[k] * points[own[k]];
    if (is_right) sum.x = -sum.x;
    at[v] = sum;
  }
}

void compute_lip_shortfalls(const LipSheet& upper, const std::vector<glm::dvec3>& upper_at,
                            const LipSheet& lower, const std::vector<glm::dvec3>& lower_at, double apart_mm,
                            LipShortfalls& shortfalls) {
  compute_shortfalls_of(upper, upper_at, lower, lower_at, 1, apart_mm, shortfalls);
  compute_shortfalls_of(lower, lower_at, upper, upper_at, -1, apart_mm, shortfalls);
}

}  // namespace mien

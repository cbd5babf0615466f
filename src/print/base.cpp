// The mouldings of a column's foot, as every handbook of ornament draws them: a hollow (scotia), a round
// (torus) and the drum.
#include "print/base.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "core/error.hpp"
#include "core/print_numbers.hpp"
#include "print/label_panel.hpp"

namespace mien {

namespace {

std::span<const ProfilePoint> find_profile(BaseShape shape) {
  if (shape == BaseShape::plinth) return kBlock;
  return kSocle;
}

// The outline's distance from the axis in the direction (c, s).
double compute_outline_mm(const Base& base, double c, double s) {
  const double n = base.shape == BaseShape::round ? 2 : kSquareness;
  return base.radius_mm * std::pow(std::pow(std::abs(c), n) + std::pow(std::abs(s), n), -1 / n);
}

void require_base(const Base& base) {
  if (!(base.height_mm > 0) && base.shape != BaseShape::none)
    throw RunError(fmt::format("the base's height of {} mm is not above 0", base.height_mm));
  if (!(base.radius_mm > 0) && base.shape != BaseShape::none)
    throw RunError(fmt::format("the base's radius of {} mm is not above 0", base.radius_mm));
}

// Star-shaped: each step goes the same way round the axis.
void require_star(const std::vector<glm::vec3>& foot) {
  int left = 0, right = 0;
  for (std::size_t i = 0; i < foot.size(); ++i) {
    const glm::dvec3 a(foot[i]), b(foot[(i + 1) % foot.size()]);
    (a.x * b.y - a.y * b.x > 0 ? left : right) += 1;
  }
  if (foot.size() < 3 || (left > 0 && right > 0))
    throw RunError("internal: the figure's foot does not go round its axis");
}

Loop append_ring(Mesh& mesh, const std::vector<glm::vec3>& ring) {
  Loop loop;
  for (const glm::vec3& p : ring) {
    loop.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.push_back(p);
  }
  return loop;
}

// A circle about the axis with a point in the direction of each of `around`, so wide that what is as thick as
// `diameter_mm` goes through the polygon.
std::vector<glm::vec3> build_circle(const std::vector<glm::vec3>& around, double diameter_mm, double z) {
  double closest = 1;  // the cosine of half the widest gap
  for (std::size_t i = 0; i < around.size(); ++i) {
    const glm::dvec2 a = glm::normalize(glm::dvec2(around[i])),
                     b = glm::normalize(glm::dvec2(around[(i + 1) % around.size()]));
    closest = std::min(closest, std::sqrt((1 + glm::dot(a, b)) / 2));
  }
  std::vector<glm::vec3> circle;
  for (const glm::vec3& p : around)
    circle.emplace_back(glm::normalize(glm::dvec2(p)) * (diameter_mm / 2 / closest), z);
  return circle;
}

void require_pocket(const Base& base, const std::vector<glm::vec3>& underside) {
  double narrowest = 1e9;
  for (const glm::vec3& p : underside) narrowest = std::min(narrowest, std::hypot(double(p.x), double(p.y)));
  if (base.magnet_diameter_mm / 2 + kPocketRoof_mm > narrowest ||
      base.magnet_depth_mm + kPocketRoof_mm > base.height_mm)
    throw RunError(fmt::format("the magnet's pocket of {} x {} mm does not fit the base",
                               base.magnet_diameter_mm, base.magnet_depth_mm));
}

}  // namespace

std::vector<std::vector<glm::vec3>> list_base_rings(const Base& base, const std::vector<glm::vec3>& foot) {
  require_base(base);
  require_star(foot);
  std::vector<std::vector<glm::vec3>> rings;
  if (base.shape == BaseShape::none) {
    if (base.height_mm <= 0) return rings;
    std::vector<glm::vec3>& ring = rings.emplace_back(foot);
    for (glm::vec3& p : ring) p.z = 0;
    return rings;
  }
  for (const auto& [out, up] : find_profile(base.shape)) {
    std::vector<glm::vec3>& ring = rings.emplace_back();
    for (const glm::vec3& p : foot) {
      const double x = p.x, y = p.y, from = std::hypot(x, y), c = x / from, s = y / from;
      const double to = std::max(compute_outline_mm(base, c, s), kSpread * from);
      const double radius = from + out * (to - from);
      ring.emplace_back(radius * c, radius * s, base.height_mm * up);
    }
  }
  return rings;
}

Label fit_label(const Base& base, const std::vector<glm::vec3>& foot, const Letters& letters) {
  if (base.shape == BaseShape::none || base.label.empty()) return {};
  if (letters.glyphs.empty()) throw RunError("internal: a label without letters");
  std::vector<std::vector<glm::vec3>> rings = list_base_rings(base, foot);
  const double area = foot[0].x * foot[1].y - foot[0].y * foot[1].x;
  for (std::vector<glm::vec3>& ring : rings)
    if (area < 0) std::reverse(ring.begin(), ring.end());
  const LabelRoom room =
      compute_label_room(rings[rings.size() - kLabelRing - 1], rings[rings.size() - kLabelRing]);
  const double asked = base.label_size_mm > 0 ? base.label_size_mm : kMostLetter_mm;
  return set_label(letters, base.label, std::min(asked, room.height_mm), std::min(asked, kLeastLetter_mm),
                   room.width_mm);
}

Loop append_base(Mesh& body, const Loop& foot_loop, const Base& base, const Letters& letters,
                 double drain_mm) {
  std::vector<glm::vec3> foot;
  for (const std::uint32_t v : foot_loop) foot.push_back(body.positions[v]);
  const Label label = fit_label(base, foot, letters);
  const auto rings = list_base_rings(base, foot);
  Loop last = foot_loop;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const Loop ring = append_ring(body, rings[i]);
    if (!label.strokes.empty() && i + kLabelRing == rings.size())
      append_label_band(body, {last.rbegin(), last.rend()}, {ring.rbegin(), ring.rend()}, label,
                        base.label_raise_mm);
    else
      append_band(body, last, ring);
    last = ring;
    foot = rings[i];
  }
  const auto append_circle = [&](double diameter_mm, double z) {
    const Loop circle = append_ring(body, build_circle(foot, diameter_mm, z));
    append_band(body, last, circle);
    last = circle;
  };
  double ceiling = 0;
  if (base.magnet_diameter_mm > 0 && base.magnet_depth_mm > 0) {
    require_pocket(base, foot);
    ceiling = base.magnet_depth_mm;
    append_circle(base.magnet_diameter_mm, 0);
    append_circle(base.magnet_diameter_mm, ceiling);
  }
  if (drain_mm > 0) {
    append_circle(drain_mm, ceiling);
    return last;
  }
  append_fan_cap(body, last, {0, 0, ceiling});
  return {};
}

}  // namespace mien

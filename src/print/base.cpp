// The mouldings of a column's foot, as every handbook of ornament draws them: a hollow (scotia), a round
// (torus) and the drum.
#include "print/base.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
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

void append_quad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

}  // namespace

Vent find_vent(const Base& base, double drain_mm) {
  if (base.shape == BaseShape::none || !(drain_mm > 0)) return {};
  const std::span<const ProfilePoint> profile = find_profile(base.shape);
  const auto find_height = [&](std::size_t from_below) {
    return profile[profile.size() - from_below].up * base.height_mm;
  };
  const double lower = find_height(kLabelRing), upper = find_height(kLabelRing + 1),
               ledge = find_height(kLabelRing + 2);
  const bool has_pocket = base.magnet_diameter_mm > 0 && base.magnet_depth_mm > 0;
  Vent vent;
  vent.width_mm = kVentShare * drain_mm;
  vent.low_mm = std::max(
      {kVentPlate_mm, lower + kVentEdge_mm, has_pocket ? base.magnet_depth_mm + kMagnetLedge_mm : 0});
  vent.high_mm = std::min({vent.low_mm + vent.width_mm, upper - kVentEdge_mm, ledge - kVentPlate_mm});
  if (std::min(vent.width_mm, vent.high_mm - vent.low_mm) < kLeastDrain_mm) return {};
  return vent;
}

VentMouth cut_vent_mouth(Mesh& mesh, std::size_t first, const Loop& from, const Loop& to, const Vent& vent) {
  const std::size_t n = to.size();
  const auto at = [&](std::size_t i) { return glm::dvec3(mesh.positions[to[i % n]]); };
  const double half = vent.width_mm / 2;
  std::size_t begin = n, end = n;  // columns: those on either side of the back's middle, then beyond the vent
  for (std::size_t i = n; i < 2 * n; ++i)
    if (at(i).y > 0 && (at(i).x <= 0) != (at(i + 1).x <= 0)) begin = i, end = i + 1;
  if (begin == end) throw RunError("internal: the base has no back");
  while (std::abs(at(begin).x) <= half) --begin;
  while (std::abs(at(end).x) <= half) ++end;
  const std::size_t last = end - begin;

  std::set<std::uint32_t> opened;
  for (std::size_t i = begin; i <= end; ++i) opened.insert({from[i % n], to[i % n]});
  const auto is_opened = [&](const Triangle& t) {
    return opened.contains(t[0]) && opened.contains(t[1]) && opened.contains(t[2]);
  };
  const auto tail = mesh.triangles.begin() + static_cast<std::ptrdiff_t>(first);
  mesh.triangles.erase(std::remove_if(tail, mesh.triangles.end(), is_opened), mesh.triangles.end());

  // Where |x| is half the width on the way from a column beyond the vent to the next one.
  const auto find_edge = [&](const glm::dvec3& beyond, const glm::dvec3& next) {
    return glm::mix(beyond, next, (std::copysign(half, beyond.x) - beyond.x) / (next.x - beyond.x));
  };
  std::vector<glm::dvec3> line;
  for (std::size_t c = 0; c <= last; ++c)
    line.push_back(c == 0      ? find_edge(at(begin), at(begin + 1))
                   : c == last ? find_edge(at(end), at(end - 1))
                               : at(begin + c));
  const auto append_line = [&](double z) {
    std::vector<glm::vec3> places;
    for (const glm::dvec3& p : line) places.emplace_back(p.x, p.y, z);
    return append_ring(mesh, places);
  };
  VentMouth mouth{vent, append_line(vent.low_mm), append_line(vent.high_mm)};
  const bool is_downward = mesh.positions[from[0]].z > mesh.positions[to[0]].z;
  const Loop &a = is_downward ? mouth.high : mouth.low, &b = is_downward ? mouth.low : mouth.high;
  const auto f = [&](std::size_t c) { return from[(begin + c) % n]; };
  const auto t = [&](std::size_t c) { return to[(begin + c) % n]; };
  for (std::size_t c = 0; c < last; ++c) {
    append_quad(mesh, f(c), f(c + 1), a[c + 1], a[c]);
    append_quad(mesh, b[c], b[c + 1], t(c + 1), t(c));
  }
  append_quad(mesh, f(0), a[0], b[0], t(0));
  append_quad(mesh, a[last], f(last), t(last), b[last]);
  return mouth;
}

void append_tunnel(Mesh& mesh, const VentMouth& outside, const VentMouth& inside) {
  append_strip(mesh, outside.high, inside.high);
  append_strip(mesh, inside.low, outside.low);
  append_quad(mesh, outside.low.front(), outside.high.front(), inside.high.front(), inside.low.front());
  append_quad(mesh, outside.high.back(), outside.low.back(), inside.low.back(), inside.high.back());
}

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

Loop append_base(Mesh& body, const Loop& foot_loop, const Base& base, const Letters& letters, double drain_mm,
                 VentMouth* outside) {
  std::vector<glm::vec3> foot;
  for (const std::uint32_t v : foot_loop) foot.push_back(body.positions[v]);
  const Label label = fit_label(base, foot, letters);
  const auto rings = list_base_rings(base, foot);
  Loop last = foot_loop;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const Loop ring = append_ring(body, rings[i]);
    const std::size_t first = body.triangles.size();
    const bool is_upright = i + kLabelRing == rings.size();
    if (!label.strokes.empty() && is_upright)
      append_label_band(body, {last.rbegin(), last.rend()}, {ring.rbegin(), ring.rend()}, label,
                        base.label_raise_mm);
    else
      append_band(body, last, ring);
    if (is_upright && outside != nullptr && outside->vent.width_mm > 0)
      *outside = cut_vent_mouth(body, first, last, ring, outside->vent);
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

#include "frames/pose_soundness.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "head/binding.hpp"
#include "head/dental_arch.hpp"
#include "head/surface.hpp"

namespace mien {

namespace {

enum Check { finite, turned, ball, cornea, gap, order, lips, bite, hair = bite + 3 };

using Positions = std::vector<glm::vec3>;

void raise(Finding& finding, double value, std::uint32_t vertex) {
  if (value > finding.value) finding = {value, vertex};
}

glm::vec3 find_area_vector(const Positions& p, const Triangle& t) {
  return glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
}

// The rotation that carries the patch best from its place at rest: Kabsch 1976.
glm::mat3 find_rotation(const std::array<std::uint32_t, 25>& patch, const Positions& rest,
                        const Positions& now) {
  Eigen::Matrix<double, 3, 25> from, to;
  for (Eigen::Index i = 0; i < 25; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      from(axis, i) = rest[patch[static_cast<std::size_t>(i)]][axis];
      to(axis, i) = now[patch[static_cast<std::size_t>(i)]][axis];
    }
  const Eigen::Matrix4d best = Eigen::umeyama(from, to, false);
  glm::mat3 rotation;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) rotation[j][i] = static_cast<float>(best(i, j));
  return rotation;
}

void measure_turned(const PoseProbe& probe, const Positions& now, PoseFindings& found) {
  constexpr float kPlain = 0.4f;  // cosine: a patch that turned by less as a whole needs no closer look
  const Positions& rest = probe.figure->head.skin.positions;
  for (std::size_t i = 0; i < probe.patches.size(); ++i) {
    const bool is_plain =
        std::all_of(probe.patch_triangles[i].begin(), probe.patch_triangles[i].end(), [&](const Triangle& t) {
          const glm::vec3 then = find_area_vector(rest, t), area = find_area_vector(now, t);
          return glm::dot(then, area) > kPlain * glm::length(then) * glm::length(area);
        });
    if (is_plain) continue;
    const glm::mat3 rotation = find_rotation(probe.patches[i], rest, now);
    for (const Triangle& t : probe.patch_triangles[i])
      if (glm::dot(rotation * find_area_vector(rest, t), find_area_vector(now, t)) <= 0) {
        ++found[turned].value;
        found[turned].vertex = t[0];
      }
  }
}

glm::dvec3 to_left(const glm::vec3& p, bool is_right) { return glm::dvec3(is_right ? -p.x : p.x, p.y, p.z); }

// How far `p` lies above the line `lower`, both seen from the ball's centre: the angle between them at the
// same place along the eye, as a way on the ball.
double find_opening_mm(const glm::dvec3& p, const std::vector<glm::dvec3>& lower, const Eye& eye) {
  const auto height = [&](const glm::dvec3& q) { return std::atan2(q.y - eye.centre.y, q.z - eye.centre.z); };
  for (std::size_t i = 1; i < lower.size(); ++i) {
    if (p.x < lower[i - 1].x || p.x > lower[i].x) continue;
    const double t = (p.x - lower[i - 1].x) / std::max(1e-9, lower[i].x - lower[i - 1].x);
    return (height(p) - glm::mix(height(lower[i - 1]), height(lower[i]), t)) *
           std::hypot(p.y - eye.centre.y, p.z - eye.centre.z);
  }
  return std::numeric_limits<double>::max();
}

double compute_distance_mm(const glm::dvec3& p, const std::vector<glm::dvec3>& line) {
  double distance = 1e9;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const glm::dvec3 ab = line[i] - line[i - 1];
    const double t = glm::clamp(glm::dot(p - line[i - 1], ab) / std::max(1e-12, glm::dot(ab, ab)), 0.0, 1.0);
    distance = std::min(distance, glm::distance(p, line[i - 1] + t * ab));
  }
  return distance;
}

void measure_eye(const PoseProbe& probe, const Pose& pose, const Positions& now, bool is_right,
                 PoseFindings& found) {
  const NeutralHead& head = probe.figure->head;
  const auto vertex = [&](std::uint32_t v) { return is_right ? head.surface->mirror[v] : v; };
  const auto at = [&](std::uint32_t v) { return to_left(now[vertex(v)], is_right); };
  const Side side = is_right ? Side::right : Side::left;
  const glm::dmat3 mirror = glm::dmat3(glm::dvec3(is_right ? -1 : 1, 0, 0), {0, 1, 0}, {0, 0, 1});
  const glm::dmat3 ahead = mirror * glm::transpose(compute_gaze(probe.figure->face, pose, side)) * mirror;
  for (const std::uint32_t v : probe.lid_skin) {
    const glm::dvec3 p = at(v);
    raise(found[ball], head.eye.radius_mm - glm::distance(p, head.eye.centre), vertex(v));
    const glm::dvec3 looked = head.eye.centre + ahead * (p - head.eye.centre);
    raise(found[cornea], -compute_standoff_mm(probe.eye, head.eye, looked), vertex(v));
  }
  const bool is_shut = pose.values[*find_move(Area::lid, side, "upper")] == -1;
  for (std::size_t rim = 0; rim < probe.rims.size(); ++rim) {
    std::vector<glm::dvec3> lower;
    for (const std::uint32_t v : probe.rims[rim].lower) lower.push_back(at(v));
    const auto& upper = probe.rims[rim].upper;
    for (std::size_t i = 1; i + 1 < upper.size(); ++i) {
      const glm::dvec3 p = at(upper[i]);
      raise(found[order], -find_opening_mm(p, lower, head.eye), vertex(upper[i]));
      if (is_shut && rim == 1) raise(found[gap], compute_distance_mm(p, lower), vertex(upper[i]));
    }
  }
}

// Triangles by the place of their boxes along x, to be asked what lies above or before a place.
struct Strips {
  static constexpr int kCount = 64;
  static constexpr float kHalf_mm = 64;
  const Positions* positions = nullptr;
  const std::vector<Triangle>* triangles = nullptr;
  std::array<std::vector<std::uint32_t>, kCount> strips;

  static int find_strip(float x) {
    return std::clamp(static_cast<int>((x + kHalf_mm) * kCount / (2 * kHalf_mm)), 0, kCount - 1);
  }
};

Strips build_strips(const Positions& positions, const std::vector<Triangle>& triangles) {
  Strips strips{&positions, &triangles, {}};
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    const auto [low, high] = std::minmax({positions[a].x, positions[b].x, positions[c].x});
    for (int s = Strips::find_strip(low); s <= Strips::find_strip(high); ++s) strips.strips[s].push_back(t);
  }
  return strips;
}

// Calls `use(t, weights)` for the triangles that hold `p` when looked at along the axis that is not x and not
// `across` (1 y, 2 z). Weights are of the corners.
template <typename Use>
void for_each_over(const Strips& strips, const glm::vec3& p, int across, const Use& use) {
  for (const std::uint32_t t : strips.strips[Strips::find_strip(p.x)]) {
    const Triangle& triangle = (*strips.triangles)[t];
    const glm::dvec3 a((*strips.positions)[triangle[0]]), b((*strips.positions)[triangle[1]]),
        c((*strips.positions)[triangle[2]]);
    const double low = std::min({a[across], b[across], c[across]}),
                 high = std::max({a[across], b[across], c[across]});
    if (p[across] < low || p[across] > high) continue;
    const double area = (b.x - a.x) * (c[across] - a[across]) - (b[across] - a[across]) * (c.x - a.x);
    if (std::abs(area) < 1e-9) continue;
    const double u = ((b.x - p.x) * (c[across] - p[across]) - (b[across] - p[across]) * (c.x - p.x)) / area;
    const double v = ((c.x - p.x) * (a[across] - p[across]) - (c[across] - p[across]) * (a.x - p.x)) / area;
    if (u < 0 || v < 0 || u + v > 1) continue;
    use(triangle, glm::dvec3(u, v, 1 - u - v));
  }
}

double mix_axis(const Positions& p, const Triangle& t, const glm::dvec3& weights, int axis) {
  return weights.x * p[t[0]][axis] + weights.y * p[t[1]][axis] + weights.z * p[t[2]][axis];
}

void measure_lips(const PoseProbe& probe, const Positions& now, PoseFindings& found) {
  for (const bool is_upper : {true, false}) {
    const Strips other = build_strips(now, probe.lips[is_upper ? 1 : 0]);
    for (const Triangle& t : probe.lips[is_upper ? 0 : 1]) {
      const glm::vec3& p = now[t[0]];
      for_each_over(other, p, 2, [&](const Triangle& over, const glm::dvec3& weights) {
        if (std::find(over.begin(), over.end(), t[0]) != over.end()) return;
        const double y = mix_axis(now, over, weights, 1);
        raise(found[lips], is_upper ? y - p.y : p.y - y, t[0]);
      });
    }
  }
}

void measure_bites(const PoseProbe& probe, const Drawing& drawing, PoseFindings& found) {
  const Positions& now = drawing.parts.front().positions;
  const Strips outside = build_strips(now, probe.outside);
  for (std::size_t kind = 0; kind < probe.bites.size(); ++kind)
    for (const std::size_t part : probe.bites[kind]) {
      const Mesh& rest = probe.figure->model.parts[part].rest;
      for (std::size_t v = 0; v < rest.positions.size(); ++v) {
        if (rest.normals[v].z <= 0) continue;  // the back is behind a front that would be through first
        if (!is_carried(probe.figure->model.parts[part], drawing.parts[part])) continue;
        const glm::vec3 p(drawing.parts[part].world_from_rest * glm::vec4(rest.positions[v], 1));
        double front = -1e9, through = 0;
        std::uint32_t vertex = 0;
        for_each_over(outside, p, 1, [&](const Triangle& over, const glm::dvec3& weights) {
          const glm::vec3 area = find_area_vector(now, over);
          const double z = mix_axis(now, over, weights, 2);
          if (area.z <= 0 || z < front) return;
          front = z;
          through = (p.z - z) * area.z / glm::length(area);
          vertex = over[0];
        });
        raise(found[bite + kind], through, vertex);
      }
    }
}

// How far beyond a triangle the way from `a` to `b` ends that goes through it, mm; 0 if it does not.
double find_crossing_mm(const Positions& now, const Triangle& t, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 p(now[t[0]]), u = glm::dvec3(now[t[1]]) - p, v = glm::dvec3(now[t[2]]) - p;
  const glm::dvec3 normal = glm::cross(u, v), way = b - a;
  const double length = glm::length(normal), steep = glm::dot(normal, way);
  if (length < 1e-9 || std::abs(steep) < 1e-12) return 0;
  const double at = glm::dot(normal, p - a) / steep;
  if (at <= 0 || at >= 1) return 0;
  const glm::dvec3 hit = a + at * way - p;
  const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v), hu = glm::dot(hit, u),
               hv = glm::dot(hit, v), whole = uu * vv - uv * uv;
  const double s = (hu * vv - hv * uv) / whole, r = (hv * uu - hu * uv) / whole;
  return s < 0 || r < 0 || s + r > 1 ? 0 : (1 - at) * std::abs(steep) / length;
}

// A tongue that is bent may be out between the lips: along none of its lines may it go through skin.
void measure_tongue(const PoseProbe& probe, const Drawing& drawing, PoseFindings& found) {
  const Positions& now = drawing.parts.front().positions;
  for (const std::size_t part : probe.bites[2]) {
    const PartShape& shape = drawing.parts[part];
    if (is_carried(probe.figure->model.parts[part], shape)) continue;
    Box box = compute_bounds(shape.positions);
    std::vector<Triangle> near;
    for (const auto* skin : {&probe.outside, &probe.lips[0], &probe.lips[1]})
      for (const Triangle& t : *skin) {
        const auto [low, high] = std::minmax({now[t[0]].z, now[t[1]].z, now[t[2]].z});
        const auto [left, right] = std::minmax({now[t[0]].x, now[t[1]].x, now[t[2]].x});
        const auto [down, up] = std::minmax({now[t[0]].y, now[t[1]].y, now[t[2]].y});
        if (low <= box.high.z && high >= box.low.z && left <= box.high.x && right >= box.low.x &&
            down <= box.high.y && up >= box.low.y)
          near.push_back(t);
      }
    if (near.empty()) continue;
    for (std::size_t ring = 0; ring + 1 < kTongueRings; ++ring)
      for (std::size_t k = 0; k < kTonguePoints; ++k) {
        const std::size_t v = 1 + ring * kTonguePoints + k;
        const glm::dvec3 a(shape.positions[v]), b(shape.positions[v + kTonguePoints]);
        for (const Triangle& t : near) {
          const auto [low, high] = std::minmax({now[t[0]].z, now[t[1]].z, now[t[2]].z});
          if (std::max(a.z, b.z) < low || std::min(a.z, b.z) > high) continue;
          raise(found[bite + 2], find_crossing_mm(now, t, a, b), t[0]);
        }
      }
  }
}

void measure_hairs(const PoseProbe& probe, const Drawing& drawing, PoseFindings& found) {
  const PartShape& skin = drawing.parts.front();
  for (const HairProbe& probed : probe.hairs) {
    const SkinFrame frame = compute_skin_frame(
        skin.positions, skin.normals, probe.figure->head.skin.triangles[probed.triangle], probed.barycentric);
    const glm::vec3 arm = drawing.parts[probed.part].positions[probed.vertex] - frame.origin;
    raise(found[hair], std::abs(glm::dot(arm, frame.axes[2])),
          probe.figure->head.skin.triangles[probed.triangle][0]);
  }
}

void count_broken(const Drawing& drawing, PoseFindings& found) {
  for (const PartShape& shape : drawing.parts)
    for (std::uint32_t v = 0; v < shape.positions.size(); ++v) {
      const glm::vec3 sum = shape.positions[v] + shape.normals[v];
      if (!std::isfinite(sum.x + sum.y + sum.z)) ++found[finite].value;
    }
}

}  // namespace

PoseFindings measure_pose(const PoseProbe& probe, const Pose& pose, DeformBuffers& buffers,
                          Drawing& drawing) {
  PoseFindings found;
  deform_figure(*probe.figure, pose, TurnKey{}, buffers, drawing);
  const Positions& now = drawing.parts.front().positions;
  count_broken(drawing, found);
  measure_turned(probe, now, found);
  for (const bool is_right : {false, true}) measure_eye(probe, pose, now, is_right, found);
  measure_lips(probe, now, found);
  measure_bites(probe, drawing, found);
  measure_tongue(probe, drawing, found);
  measure_hairs(probe, drawing, found);
  return found;
}

}  // namespace mien

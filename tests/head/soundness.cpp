#include "head/soundness.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <unordered_map>

#include "core/crossings.hpp"
#include "head/cage.hpp"
#include "head/contact.hpp"
#include "head/surface.hpp"

namespace mien {

std::vector<bool> find_visible(const NeutralHead& head) {
  std::vector<double> hidden(head.cage.points.size(), 0);
  for (std::size_t i = 0; i < hidden.size(); ++i)
    for (const char* ring : {"EB_", "M0_", "M1_6", "M2_6", "MB1_", "MB2_", "ni_", "nd_"})
      if (has_prefix(head.cage.names[i], ring)) hidden[i] = 1;
  const std::vector<float> spread = spread_over_surface(*head.surface, hidden);
  std::vector<bool> visible(spread.size());
  for (std::size_t v = 0; v < spread.size(); ++v) visible[v] = spread[v] < 0.5f;
  return visible;
}

namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

std::string describe_place(const NeutralHead& head, std::uint32_t vertex) {
  const glm::vec3& p = head.skin.positions[vertex];
  return fmt::format("{} at {:.2f} {:.2f} {:.2f}", find_nearest_name(head, vertex), p.x, p.y, p.z);
}

std::array<glm::dvec3, 3> compute_corners(const NeutralHead& head, const Triangle& t) {
  const auto& p = head.skin.positions;
  return {glm::dvec3(p[t[0]]), glm::dvec3(p[t[1]]), glm::dvec3(p[t[2]])};
}

glm::dvec3 find_area_vector(const std::array<glm::dvec3, 3>& c) {
  return 0.5 * glm::cross(c[1] - c[0], c[2] - c[0]);
}

void measure_triangles(const NeutralHead& head, Soundness& sound) {
  const std::vector<bool> visible = find_visible(head);
  sound.angle_deg.value = sound.area_mm2.value = std::numeric_limits<double>::max();
  const auto& triangles = head.skin.triangles;
  std::unordered_map<std::uint64_t, glm::dvec3> normal_at;  // by directed edge
  normal_at.reserve(3 * triangles.size());
  const auto key = [](std::uint64_t from, std::uint64_t to) { return from << 32 | to; };
  for (const Triangle& t : triangles) {
    if (!visible[t[0]] || !visible[t[1]] || !visible[t[2]]) continue;
    const auto corners = compute_corners(head, t);
    const glm::dvec3 area = find_area_vector(corners);
    if (glm::length(area) < sound.area_mm2.value)
      sound.area_mm2 = {glm::length(area), describe_place(head, t[0])};
    const glm::dvec3 normal = area / std::max(glm::length(area), 1e-12);
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3 a = corners[(i + 1) % 3] - corners[i], b = corners[(i + 2) % 3] - corners[i];
      const double angle = kDegrees * std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
      if (angle < sound.angle_deg.value) sound.angle_deg = {angle, describe_place(head, t[i])};
      const std::uint32_t from = t[i], to = t[(i + 1) % 3];
      normal_at[key(from, to)] = normal;
      const auto other = normal_at.find(key(to, from));
      if (other == normal_at.end()) continue;
      const double fold = kDegrees * std::acos(std::clamp(glm::dot(other->second, normal), -1.0, 1.0));
      if (fold > sound.fold_deg.value) sound.fold_deg = {fold, describe_place(head, from)};
    }
  }
}

// The rotation that carries a patch of the adult's vertices best onto the same vertices of `head`: Kabsch
// 1976.
glm::dmat3 find_rotation(const NeutralHead& head, const NeutralHead& adult,
                         const std::set<std::uint32_t>& patch) {
  Eigen::Matrix3Xd from(3, patch.size()), to(3, patch.size());
  Eigen::Index column = 0;
  for (const std::uint32_t v : patch) {
    for (int i = 0; i < 3; ++i) {
      from(i, column) = adult.skin.positions[v][i];
      to(i, column) = head.skin.positions[v][i];
    }
    ++column;
  }
  const Eigen::Matrix4d best = Eigen::umeyama(from, to, false);
  glm::dmat3 rotation;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) rotation[j][i] = best(i, j);
  return rotation;
}

// One rotation for the 32 triangles of each quad of the cage; the left half stands for both.
void find_inverted(const NeutralHead& head, const NeutralHead& adult, Soundness& sound) {
  for (std::size_t q = 0; q < head.cage.quads.size() / 2; ++q) {
    std::set<std::uint32_t> patch;
    for (std::size_t i = 0; i < 32; i += 2)
      patch.insert(head.surface->quads[32 * q + i].begin(), head.surface->quads[32 * q + i].end());
    const glm::dmat3 rotation = find_rotation(head, adult, patch);
    for (std::size_t t = 64 * q; t < 64 * (q + 1); ++t) {
      if ((t / 2) % 2 == 1) continue;  // the mirror image's
      const Triangle& triangle = head.skin.triangles[t];
      const glm::dvec3 then = rotation * find_area_vector(compute_corners(adult, triangle));
      if (glm::dot(then, find_area_vector(compute_corners(head, triangle))) > 0) continue;
      if (sound.inverted++ == 0) sound.first_inverted = describe_place(head, triangle[0]);
    }
  }
}

// How far out along the ray from the ball's centre through `point` the eye's parts reach, mm.
double compute_reach(const std::vector<const Mesh*>& meshes, const glm::dvec3& centre,
                     const glm::dvec3& point) {
  const glm::dvec3 way = glm::normalize(point - centre);
  double reach = 0;
  for (const Mesh* mesh : meshes)
    for (const Triangle& t : mesh->triangles) {  // Moeller and Trumbore 1997
      const glm::dvec3 a(mesh->positions[t[0]]);
      const glm::dvec3 ab = glm::dvec3(mesh->positions[t[1]]) - a, ac = glm::dvec3(mesh->positions[t[2]]) - a;
      const glm::dvec3 p = glm::cross(way, ac), s = centre - a, q = glm::cross(s, ab);
      const double determinant = glm::dot(ab, p);
      if (std::abs(determinant) < 1e-12) continue;
      const double u = glm::dot(s, p) / determinant, v = glm::dot(way, q) / determinant;
      if (u < -1e-9 || v < -1e-9 || u + v > 1 + 1e-9) continue;
      reach = std::max(reach, glm::dot(ac, q) / determinant);
    }
  return reach;
}

void measure_eye(const NeutralHead& head, Soundness& sound) {
  const std::vector<HeadPart> parts = build_eyes(head, Look{});
  std::vector<const Mesh*> meshes;
  for (const HeadPart& part : parts)
    if (part.part.name == "eye_left" || part.part.name == "cornea_left") meshes.push_back(&part.part.rest);
  for (const MarginVertex& margin : compute_lid_ring(*head.surface, head.cage)) {
    const glm::dvec3 p(head.skin.positions[margin.vertex]);
    const double off = glm::length(p - head.eye.centre) - compute_reach(meshes, head.eye.centre, p);
    if (-off > sound.into_eye_mm.value) sound.into_eye_mm = {-off, fmt::format("margin {:.2f}", margin.at)};
    if (touches_eye(margin.at) && off > sound.off_eye_mm.value)
      sound.off_eye_mm = {off, fmt::format("margin {:.2f}", margin.at)};
  }
  sound.lids_mm.value = std::numeric_limits<double>::max();
  for (int column = 1; column < 8; ++column)
    for (const char* ring : {"E0", "E1"}) {
      const auto at = [&](int i) {
        return head.skin.positions[find_point(head.cage, fmt::format("{}_{}", ring, i))];
      };
      const double height = at(column).y - at(16 - column).y;
      if (height < sound.lids_mm.value) sound.lids_mm = {height, fmt::format("{}_{}", ring, column)};
    }
}

void measure_lips(const NeutralHead& head, Soundness& sound) {
  sound.lips_mm.value = std::numeric_limits<double>::max();
  for (int column = 0; column < 6; ++column)
    for (const char* ring : {"M0", "M1", "M2"}) {
      const auto at = [&](int i) {
        return head.skin.positions[find_point(head.cage, fmt::format("{}_{}", ring, i))];
      };
      const double height = at(column).y - at(12 - column).y;
      if (height < sound.lips_mm.value) sound.lips_mm = {height, fmt::format("{}_{}", ring, column)};
    }
}

std::size_t count_unmirrored(const NeutralHead& head) {
  std::size_t count = 0;
  for (std::uint32_t v = 0; v < head.skin.positions.size(); ++v) {
    const std::uint32_t m = head.surface->mirror[v];
    for (const auto* values : {&head.skin.positions, &head.skin.normals}) {
      const glm::vec3 &here = (*values)[v], &there = (*values)[m];
      count += here.x != -there.x;
      count += here.y != there.y;
      count += here.z != there.z;
    }
  }
  return count;
}

}  // namespace

std::string find_nearest_name(const NeutralHead& head, std::uint32_t vertex) {
  const Surface& surface = *head.surface;
  std::uint32_t best = surface.first[vertex];
  for (std::uint32_t k = best; k < surface.first[vertex + 1]; ++k)
    if (surface.weight[k] > surface.weight[best]) best = k;
  return head.cage.names[surface.point[best]];
}

bool is_manifold(const Mesh& mesh) {
  // A vertex's triangles make one fan if, going from each to the one across the edge that leaves the vertex,
  // all are met: as many steps as triangles, from the open edge if there is one.
  std::vector<std::map<std::uint32_t, std::uint32_t>> next(mesh.positions.size());
  for (const Triangle& t : mesh.triangles)
    for (int i = 0; i < 3; ++i)
      if (!next[t[i]].emplace(t[(i + 1) % 3], t[(i + 2) % 3]).second) return false;
  for (const auto& fan : next) {
    if (fan.empty()) return false;
    std::set<std::uint32_t> ends;
    for (const auto& [from, to] : fan) ends.insert(to);
    std::uint32_t start = fan.begin()->first;
    for (const auto& [from, to] : fan)
      if (!ends.contains(from)) start = from;
    std::uint32_t at = start;
    for (std::size_t step = 0; step < fan.size(); ++step) {
      const auto found = fan.find(at);
      if (found == fan.end()) return false;
      at = found->second;
      if (at == start && step + 1 < fan.size()) return false;
    }
  }
  return true;
}

Soundness measure_soundness(const NeutralHead& head, const NeutralHead& adult) {
  Soundness sound;
  sound.has_adults_triangles = head.skin.triangles == adult.skin.triangles;
  const auto crossings = find_crossings(head.skin.positions, head.skin.triangles);
  sound.crossings = crossings.size();
  if (!crossings.empty()) {
    const auto& [one, two] = crossings.front();
    sound.first_crossing = describe_place(head, head.skin.triangles[one][0]) + " and " +
                           describe_place(head, head.skin.triangles[two][0]);
  }
  measure_triangles(head, sound);
  find_inverted(head, adult, sound);
  measure_eye(head, sound);
  measure_lips(head, sound);
  sound.mirror_bits = count_unmirrored(head);
  return sound;
}

}  // namespace mien

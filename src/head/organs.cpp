#include "head/organs.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>

#include "core/conventions.hpp"
#include "head/cage.hpp"

namespace mien {

namespace {

// The bottom of the ear's cavity, the edge of the hole it stands in, and the points around that, ring by
// ring.
constexpr std::array<std::string_view, 5> kEarFloor{"s4_L8", "s4_L9", "s4_L10", "s4_C1", "s4_C2"};
constexpr std::array<std::string_view, 16> kEarEdge{"s3_L7", "s4_L7",  "s5_L7", "s5_L8", "s5_L9", "s5_L10",
                                                    "s5_C1", "s5_C2",  "s5_C3", "s4_C3", "s3_C3", "s3_C2",
                                                    "s3_C1", "s3_L10", "s3_L9", "s3_L8"};
constexpr std::array<std::string_view, 24> kAroundEar{"s2_L6", "s3_L6", "s4_L6",  "s5_L6", "s6_L6", "s6_L7",
                                                      "s6_L8", "s6_L9", "s6_L10", "s6_C1", "s6_C2", "s6_C3",
                                                      "s6_C4", "s5_C4", "s4_C4",  "s3_C4", "s2_C4", "s2_C3",
                                                      "s2_C2", "s2_C1", "s2_L10", "s2_L9", "s2_L8", "s2_L7"};

constexpr std::array<std::string_view, 32> kNearEar{
    "s1_F1",  "s2_F1", "s3_F1", "s4_F1", "s5_F1", "s6_F1",  "s7_F1", "s7_L6", "s7_L7", "s7_L8", "s7_L9",
    "s7_L10", "s7_C1", "s7_C2", "s7_C3", "s7_C4", "s7_C5",  "s6_C5", "s5_C5", "s4_C5", "s3_C5", "s2_C5",
    "s1_C5",  "s1_C4", "s1_C3", "s1_C2", "s1_C1", "s1_L10", "s1_L9", "s1_L8", "s1_L7", "s1_L6"};
constexpr std::array<std::string_view, 8> kFarFromEar{"s1_C6", "s2_C6", "s3_C6", "s4_C6",
                                                      "s5_C6", "s6_C6", "s7_C6", "s8_C6"};

// Where the ear is rooted: before its hole, at the height of its middle.
glm::dvec3 compute_ear_root(const Cage& cage, const HeadForm& shape) {
  return (shape.points[find_point(cage, "er1_13")] + shape.points[find_point(cage, "er1_14")]) / 2.0;
}

}  // namespace

void move_shares(const Cage& cage, const std::function<double(std::string_view)>& compute_share,
                 const std::function<glm::dvec3(const glm::dvec3&)>& move, HeadForm& shape) {
  for (std::size_t i = 0; i < shape.points.size(); ++i) {
    const double share = compute_share(cage.names[i]);
    if (share == 0) continue;
    const glm::dvec3 side(cage.names[i].starts_with("R:") ? -1 : 1, 1, 1);
    const glm::dvec3 left = shape.points[i] * side;
    shape.points[i] = glm::mix(left, move(left), share) * side;
  }
}

double compute_eye_share(std::string_view name, double e3, double e4, double e5) {
  name = strip_side(name);
  for (const std::string_view lid : {"EB_", "E0_", "E1_", "E2_"})
    if (name.starts_with(lid)) return 1;
  if (name.starts_with("E3_")) return e3;
  if (name.starts_with("E4_")) return e4;
  if (name.starts_with("E5_")) return e5;
  return 0;
}

double compute_ear_share(std::string_view name, const EarShares& shares) {
  name = strip_side(name);
  if (name.starts_with("er1_")) return shares.first;
  if (name.starts_with("er2_")) return shares.second;
  if (name.starts_with("er3_")) return shares.third;
  if (name.starts_with("er")) return 1;
  const auto is_one_of = [&](const auto& names) { return std::ranges::find(names, name) != names.end(); };
  if (is_one_of(kEarFloor)) return 1;
  if (is_one_of(kEarEdge)) return shares.edge;
  if (is_one_of(kAroundEar)) return shares.around;
  if (is_one_of(kNearEar)) return shares.near;
  if (is_one_of(kFarFromEar)) return shares.far;
  return 0;
}

void change_eyes(const Cage& cage, const EyeChange& change, HeadForm& shape) {
  if (change.is_none()) return;
  const glm::dvec3 centre = shape.eye.centre;
  // The ball's front keeps its depth when it grows, or it would stare.
  const double back_mm = shape.eye.radius_mm * (change.size - 1);
  const glm::dvec3 now = centre + glm::dvec3(change.move_mm, -back_mm);
  const glm::dmat4 turn =
      glm::rotate(glm::dmat4(1), change.tilt_deg * kRadiansPerDegree, glm::dvec3(0, 0, 1));
  move_shares(
      cage, [](std::string_view name) { return compute_eye_share(name, 0.8, 0.55, 0.25); },
      [&](const glm::dvec3& p) { return now + change.size * glm::dvec3(turn * glm::dvec4(p - centre, 0)); },
      shape);
  shape.eye.centre = now;
  shape.eye.radius_mm *= change.size;
}

void change_ears(const Cage& cage, const EarChange& change, HeadForm& shape) {
  if (change.is_none()) return;
  const glm::dvec3 root = compute_ear_root(cage, shape);
  const glm::dmat4 turn =
      glm::rotate(glm::dmat4(1), -change.out_deg * kRadiansPerDegree, glm::dvec3(0, 1, 0));
  move_shares(
      cage, [](std::string_view name) { return compute_ear_share(name, kGrownEar); },
      [&](const glm::dvec3& p) { return root + change.size * (p - root); }, shape);
  move_shares(
      cage, [](std::string_view name) { return compute_ear_share(name, kTurnedEar); },
      [&](const glm::dvec3& p) { return root + glm::dvec3(turn * glm::dvec4(p - root, 0)); }, shape);
}

}  // namespace mien

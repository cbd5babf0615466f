// The device is Bernini's and Houdon's: the iris a shallow dish, the pupil a deep bore, and between them a
// peg of marble that catches the light (Houdon's Voltaire, 1778).
#include "frames/bust_eyes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace mien {

namespace {

constexpr int kSpokes = 72;            // around the gaze: the iris' rim looks round at any print size
constexpr float kPupilPerIris = 0.5f;  // radius; a smaller bore closes up in print
constexpr float kWall = 0.05f;         // of the iris radius: how far a carved wall leans
constexpr float kPi = std::numbers::pi_v<float>;

float smooth_step(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

// 1 on the peg of light, 0 away from it; x and y in iris radii, y up. It hangs from the rim into the pupil, a
// little to the character's right in both eyes, as one lamp would have it.
float find_light(float x, float y) {
  constexpr glm::vec2 kFrom{-0.16f, 0.34f}, kTo{-0.42f, 0.92f};
  constexpr float kHalfWidth = 0.17f, kSoft = 0.08f;
  const glm::vec2 along = kTo - kFrom, at = glm::vec2(x, y) - kFrom;
  const float share = std::clamp(glm::dot(at, along) / glm::dot(along, along), 0.0f, 1.0f);
  return 1 - smooth_step(kHalfWidth, kHalfWidth + kSoft, glm::length(at - share * along));
}

// How deep the carving goes at (x, y) iris radii from the gaze.
float find_depth_mm(const CarvedEye& eye, float x, float y) {
  const float r = std::hypot(x, y);
  const float iris = 1 - smooth_step(1 - kWall, 1 + kWall, r);
  const float pupil = 1 - smooth_step(kPupilPerIris - kWall, kPupilPerIris + kWall, r);
  const float depth = glm::mix(iris * eye.iris_depth_mm, eye.pupil_depth_mm, pupil);
  return depth * (1 - find_light(x, y));
}

// Polar angles of the rings: dense over the carving, with a ring at the foot and head of each wall.
std::vector<float> list_rings(float iris_angle) {
  std::vector<float> rings;
  for (int i = 1; i <= 20; ++i) rings.push_back(iris_angle * (1 + kWall) * float(i) / 20);
  for (const float wall : {kPupilPerIris, 1.0f})
    for (const float side : {-kWall, 0.0f, kWall}) rings.push_back(iris_angle * (wall + side));
  for (int i = 1; i < 9; ++i) {
    const float start = iris_angle * (1 + kWall);
    rings.push_back(start + (kPi - start) * float(i) / 9);
  }
  std::sort(rings.begin(), rings.end());
  const float apart = iris_angle * 0.01f;
  rings.erase(std::unique(rings.begin(), rings.end(), [&](float a, float b) { return b - a < apart; }),
              rings.end());
  return rings;
}

}  // namespace

Mesh build_carved_eye(const CarvedEye& eye) {
  const glm::vec3 z = glm::normalize(eye.gaze);
  const glm::vec3 x = glm::normalize(glm::cross(eye.up, z));
  const glm::vec3 y = glm::cross(z, x);
  const float iris_angle = std::asin(std::min(eye.iris_mm / eye.radius_mm, 0.9f));
  const auto place = [&](float angle, int spoke) {
    const float turn = 2 * kPi * float(spoke) / kSpokes;
    const float u = angle / iris_angle * std::cos(turn), v = angle / iris_angle * std::sin(turn);
    const float radius = eye.radius_mm - find_depth_mm(eye, u, v);
    const glm::vec3 out = x * std::cos(turn) + y * std::sin(turn);
    return eye.centre + radius * (z * std::cos(angle) + out * std::sin(angle));
  };

  const std::vector<float> rings = list_rings(iris_angle);
  Mesh mesh;
  mesh.positions.push_back(place(0, 0));
  for (const float angle : rings)
    for (int spoke = 0; spoke < kSpokes; ++spoke) mesh.positions.push_back(place(angle, spoke));
  const auto last = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.push_back(eye.centre - z * eye.radius_mm);

  const auto vertex = [](std::size_t ring, int spoke) {
    return static_cast<std::uint32_t>(1 + ring * kSpokes + spoke % kSpokes);
  };
  for (int s = 0; s < kSpokes; ++s) {
    mesh.triangles.push_back({0, vertex(0, s), vertex(0, s + 1)});
    for (std::size_t ring = 0; ring + 1 < rings.size(); ++ring) {
      mesh.triangles.push_back({vertex(ring, s), vertex(ring + 1, s), vertex(ring + 1, s + 1)});
      mesh.triangles.push_back({vertex(ring, s), vertex(ring + 1, s + 1), vertex(ring, s + 1)});
    }
    mesh.triangles.push_back({vertex(rings.size() - 1, s), last, vertex(rings.size() - 1, s + 1)});
  }
  return mesh;
}

}  // namespace mien

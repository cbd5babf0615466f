#include "frames/ink_round.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/smooth.hpp"

namespace mien {

namespace {

// The lips' edge as it is seen: about its middle, in shares of half its width and half its height, by the
// angle.
struct SeenEdge {
  glm::vec3 middle, right, up;
  glm::vec2 half_mm{0};
  std::vector<glm::vec2> spokes;  // angle and length, by the angle; the first again at the end
};

SeenEdge see_edge(const std::vector<glm::vec3>& ring, const glm::vec3& up, const glm::vec3& to_camera) {
  SeenEdge edge;
  edge.right = glm::normalize(glm::cross(up, to_camera));
  edge.up = glm::cross(to_camera, edge.right);
  glm::vec3 middle(0);
  for (const glm::vec3& p : ring) middle += p / static_cast<float>(ring.size());
  const auto place = [&](const glm::vec3& p) {
    return glm::vec2(glm::dot(p - middle, edge.right), glm::dot(p - middle, edge.up));
  };
  glm::vec2 low(1e9f), high(-1e9f);
  for (const glm::vec3& p : ring) {
    low = glm::min(low, place(p));
    high = glm::max(high, place(p));
  }
  edge.half_mm = 0.5f * (high - low);
  const glm::vec2 at = 0.5f * (low + high);
  edge.middle = middle + at.x * edge.right + at.y * edge.up;
  for (const glm::vec3& p : ring) {
    const glm::vec2 q = (place(p) - at) / edge.half_mm;
    edge.spokes.emplace_back(std::atan2(q.y, q.x), glm::length(q));
  }
  std::sort(edge.spokes.begin(), edge.spokes.end(),
            [](const glm::vec2& a, const glm::vec2& b) { return a.x < b.x; });
  edge.spokes.push_back(edge.spokes.front() + glm::vec2(2 * std::numbers::pi_v<float>, 0));
  return edge;
}

// How far the edge lies from its middle at an angle, -pi to pi.
float find_length(const SeenEdge& edge, float angle) {
  if (angle < edge.spokes.front().x) angle += 2 * std::numbers::pi_v<float>;
  const auto next = std::upper_bound(edge.spokes.begin() + 1, edge.spokes.end() - 1, angle,
                                     [](float value, const glm::vec2& spoke) { return value < spoke.x; });
  const glm::vec2 &a = *(next - 1), &b = *next;
  return glm::mix(a.y, b.y, b.x > a.x ? std::clamp((angle - a.x) / (b.x - a.x), 0.0f, 1.0f) : 0.0f);
}

}  // namespace

void round_mouth(const Ink& ink, float share, float inset, const glm::vec3& to_camera, Drawing& drawing) {
  constexpr float kFade_mm = 10, kLips_mm = 7, kNear = 1.2f,
                  kFar = 2.2f;  // the latter: behind the edge, of half its width
  if (share == 0) return;
  std::vector<glm::vec3>& skin = drawing.parts.front().positions;
  std::vector<glm::vec3> ring;
  for (const std::uint32_t v : ink.mouth_ring) ring.push_back(skin[v]);
  const glm::vec3 up = glm::normalize(glm::vec3(drawing.parts[ink.teeth].world_from_rest[1]));
  const SeenEdge edge = see_edge(ring, up, to_camera);
  const float wide_mm = 0.5f * glm::distance(skin[ink.corners[0]], skin[ink.corners[1]]);
  const glm::vec3 across = skin[ink.corners[0]] - skin[ink.corners[1]];
  const float far = glm::dot(across, edge.right) * glm::dot(across, to_camera) > 0 ? -1.0f : 1.0f;
  for (glm::vec3& p : skin) {
    const glm::vec3 off = p - edge.middle;
    const float deep = -glm::dot(off, to_camera) / wide_mm;
    if (std::abs(deep) >= kFar) continue;
    const glm::vec2 q = glm::vec2(glm::dot(off, edge.right), glm::dot(off, edge.up)) / edge.half_mm;
    const float away = glm::length(q);
    if (away < 1e-6f) continue;
    const glm::vec2 way = q / away;
    const float length = find_length(edge, std::atan2(q.y, q.x));
    const float beyond_mm = std::max(away - length, 0.0f) * glm::length(way * edge.half_mm);
    const float about = (1 - smooth_step(0.0f, kFade_mm * ink.eye_size, beyond_mm)) *
                        (1 - smooth_step(kNear, kFar, std::abs(deep)));
    glm::vec2 shift = share * about * std::min(away / length, 1.0f) * (1 - length) * way * edge.half_mm;
    shift.x -= share * about * (1 - smooth_step(0.0f, kLips_mm * ink.eye_size, beyond_mm)) * inset * far *
               std::max(far * q.x + 1, 0.0f) * edge.half_mm.x;
    p += shift.x * edge.right + shift.y * edge.up;
  }
}

}  // namespace mien

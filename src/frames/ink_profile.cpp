#include "frames/ink_profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/smooth.hpp"

namespace mien {

InkSight measure_sight(const Ink& ink, const InkView& view, const std::vector<glm::vec3>& skin) {
  constexpr float kQuarter = 0.88f, kProfile = 0.98f;  // sines of the camera's way round the head
  constexpr float kFront = 0.25f, kTurned = 0.5f;
  const glm::vec3 &left = skin[ink.sides[0]], &right = skin[ink.sides[1]];
  const glm::vec3 to_camera = glm::normalize(glm::vec3(view.camera_mm) - 0.5f * (left + right));
  const float sine = std::abs(glm::dot(to_camera, glm::normalize(left - right)));
  return {smooth_step(kQuarter, kProfile, sine), 1 - smooth_step(kFront, kTurned, sine)};
}

void widen_eyes(const Ink& ink, float beside, Drawing& drawing) {
  constexpr float kDeeper = 0.7f;             // of what lies in the lids
  constexpr float kLids = 0.9f, kFar = 3.2f;  // behind the balls' front, in their radii: all of it, and none
  constexpr float kNear_high = 1.5f, kFar_high = 2.6f;  // over the balls' middle, in their half heights
  constexpr float kNose = 0.2f, kInside = 0.7f;         // from the middle of the face to that of an eye
  if (beside == 0 || !ink.redraw.lens.is_on()) return;
  const glm::mat4& skull = drawing.parts[ink.teeth].world_from_rest;
  const glm::vec3 up = glm::normalize(glm::vec3(skull[1])), forward = glm::normalize(glm::vec3(skull[2]));
  const auto find_middle = [&](std::size_t part) {
    const Box box = compute_bounds(drawing.parts[part].positions);
    return 0.5f * (box.low + box.high);
  };
  const std::array middles{find_middle(ink.whites[0]), find_middle(ink.whites[1])};
  const glm::vec3 middle = 0.5f * (middles[0] + middles[1]);
  const float aside_mm = 0.5f * glm::distance(middles[0], middles[1]);
  const glm::vec3 aside = (middles[0] - middles[1]) / (2 * aside_mm);
  float front_mm = -INFINITY, high_mm = 0;
  for (const std::size_t part : ink.balls)
    for (const glm::vec3& p : drawing.parts[part].positions) {
      front_mm = std::max(front_mm, glm::dot(p - middle, forward));
      high_mm = std::max(high_mm, std::abs(glm::dot(p - middle, up)));
    }
  const float radius_mm = static_cast<float>(ink.redraw.lens.radius_mm);
  const auto widen = [&](glm::vec3& p) {
    const glm::vec3 way = p - middle;
    const float behind = (front_mm - glm::dot(way, forward)) / radius_mm;
    const float high = std::abs(glm::dot(way, up)) / high_mm;
    if (behind <= 0 || behind >= kFar || high >= kFar_high) return;
    const float share = smooth_step(kNose, kInside, std::abs(glm::dot(way, aside)) / aside_mm) *
                        (1 - smooth_step(kNear_high, kFar_high, high)) *
                        (1 - smooth_step(kLids, kFar, behind));
    p -= beside * kDeeper * radius_mm * std::min(behind, kLids) * share * forward;
  };
  for (glm::vec3& p : drawing.parts.front().positions) widen(p);
  for (const std::size_t part : ink.balls)
    for (glm::vec3& p : drawing.parts[part].positions) widen(p);
}

void lift_tones(const Ink& ink, float beside, const glm::vec3& to_light, std::vector<glm::vec3>& tones) {
  constexpr float kLit = 0.7f;
  constexpr float kDown = -0.85f, kMiddle = -0.65f, kLifted = -0.2f;  // heights of unit normals
  if (beside == 0) return;
  for (std::size_t v = 0; v < tones.size(); ++v)
    tones[v] = glm::normalize(glm::mix(tones[v], to_light, kLit * beside * (1 - ink.hull[v])));
  for (glm::vec3& tone : tones) {
    if (tone.y >= 0 || tone.y <= kDown) continue;
    const float lifted = tone.y > kMiddle ? tone.y * kLifted / kMiddle
                                          : glm::mix(kLifted, kDown, (tone.y - kMiddle) / (kDown - kMiddle));
    tone.y = glm::mix(tone.y, lifted, beside);
    tone = glm::normalize(tone);
  }
}

void place_mouth_sheet(const Ink& ink, float beside, const std::vector<glm::vec3>& skin, PartShape& sheet) {
  const glm::vec3 throat = 0.5f * (skin[ink.sheet_points[ink.sheet_points.size() - 1]] +
                                   skin[ink.sheet_points[ink.sheet_points.size() - 2]]);
  sheet.positions.clear();
  for (const std::uint32_t v : ink.sheet_points) sheet.positions.push_back(glm::mix(throat, skin[v], beside));
}

}  // namespace mien

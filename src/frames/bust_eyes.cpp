// The device is Bernini's and Houdon's: the iris a shallow dish, the pupil a deep bore, and between them a
// peg of marble that catches the light (Houdon's Voltaire, 1778).
#include "frames/bust_eyes.hpp"

#include <algorithm>
#include <cmath>

#include "core/print_numbers.hpp"
#include "core/smooth.hpp"

namespace mien {

namespace {

// 1 on the peg of light, 0 away from it; x and y in iris radii, y up.
float compute_light(float half_width, float x, float y) {
  const glm::vec2 along = kLightTo - kLightFrom, at = glm::vec2(x, y) - kLightFrom;
  const float share = std::clamp(glm::dot(at, along) / glm::dot(along, along), 0.0f, 1.0f);
  return 1 - smooth_step(half_width, half_width + kLightSoft, glm::length(at - share * along));
}

// How deep the carving goes at (x, y) iris radii from the gaze.
float compute_depth_mm(const CarvedEye& eye, float x, float y) {
  const float r = std::hypot(x, y);
  const float iris = 1 - smooth_step(1 - kIrisWall, 1 + kIrisWall, r);
  const float pupil = 1 - smooth_step(kPupilPerIris - kIrisWall, kPupilPerIris + kIrisWall, r);
  return glm::mix(iris * eye.iris_depth_mm, eye.pupil_depth_mm, pupil) * (1 - compute_light(eye.light, x, y));
}

}  // namespace

glm::vec3 place_on_eye(const CarvedEye& eye, const PatchPlace& at) {
  const glm::vec3 up = at.upper - eye.centre, low = at.lower - eye.centre;
  const glm::vec3 out = glm::normalize(glm::mix(up, low, at.down));
  const float rim_mm = glm::mix(glm::length(up), glm::length(low), at.down);
  const float gap_mm = glm::distance(at.upper, at.lower);

  const glm::vec3 x = glm::normalize(glm::cross(glm::vec3(0, 1, 0), eye.gaze));
  const glm::vec3 y = glm::cross(eye.gaze, x);
  const float sine = std::hypot(glm::dot(out, x), glm::dot(out, y));
  const float angle = std::atan2(sine, glm::dot(out, eye.gaze));
  const float per_sine = angle / std::asin(eye.iris_mm / eye.radius_mm) / std::max(sine, kLeastSine);
  const float carved_mm = compute_depth_mm(eye, glm::dot(out, x) * per_sine, glm::dot(out, y) * per_sine);

  const float seat = smooth_step(0, kEyeSeat_mm, std::min(at.down, 1 - at.down) * gap_mm);
  const float line = 1 - smooth_step(eye.slit_mm, 2 * eye.slit_mm, gap_mm);
  const float groove_mm = line * eye.line_mm * 4 * at.down * (1 - at.down);
  const float radius_mm = glm::mix(rim_mm, eye.radius_mm - carved_mm * (1 - line), seat) - groove_mm;
  return eye.centre + out * radius_mm;
}

}  // namespace mien

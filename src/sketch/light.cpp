#include "sketch/light.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mien {

namespace {

// A metal's highlight has its colour, but for that at a grazing angle.
glm::vec3 tint_highlight(const SketchSurface& surface, const glm::vec3& light, float cosine) {
  if (surface.finish.metallic <= 0) return light;
  const float x = 2 * std::acos(std::clamp(cosine, 0.0f, 1.0f)) / std::numbers::pi_v<float> - 1.12f;
  const float fresnel = std::clamp(0.014567225f / (x * x) - 0.011612903f, 0.0f, 1.0f);
  return light * (1.0f + surface.finish.metallic * (1 - fresnel) * (surface.colour.rgb - 1.0f));
}

glm::vec3 compute_highlight(const SketchSurface& surface, const glm::vec3& to_lamp, const glm::vec3& to_eye,
                            const glm::vec3& light, float cosine) {
  const SketchFinish& finish = surface.finish;
  float strength = 0;
  if (finish.specular > 0) {
    const float half = glm::dot(glm::normalize(to_lamp + to_eye), surface.normal);
    if (half > 0) strength += finish.specular * std::pow(half, 1 / finish.roughness);
  }
  if (finish.phong > 0) {
    const float mirror = glm::dot(glm::reflect(-to_eye, surface.normal), to_lamp);
    if (mirror > 0) strength += finish.phong * std::pow(mirror, finish.phong_size);
  }
  return strength > 0 ? strength * tint_highlight(surface, light, cosine) : glm::vec3(0);
}

}  // namespace

bool faces_lamp(const SketchLamp& lamp, const SketchSurface& surface) {
  return glm::dot(lamp.at - surface.at, surface.normal) > 0;
}

glm::vec3 light_surface(const SketchStage& stage, const SketchSurface& surface, const glm::vec3& to_eye,
                        std::span<const float> visible) {
  const SketchFinish& finish = surface.finish;
  const float opaque = std::max(0.0f, 1 - surface.colour.filter - surface.colour.transmit);
  const glm::vec3 diffuse = opaque * finish.diffuse * surface.colour.rgb;
  glm::vec3 sum = opaque * finish.emission * surface.colour.rgb;
  for (std::size_t i = 0; i < stage.lamps.size(); ++i) {
    const SketchLamp& lamp = stage.lamps[i];
    const glm::vec3 away = lamp.at - surface.at;
    const float height = glm::dot(away, surface.normal);
    if (height <= 0 || visible[i] <= 0) continue;
    const float distance = glm::length(away), cosine = height / distance;
    glm::vec3 light = visible[i] * lamp.colour;
    if (lamp.fade_power > 0) light *= 2 / (1 + std::pow(distance / lamp.fade_distance, lamp.fade_power));
    const float turned = finish.brilliance == 1   ? cosine
                         : finish.brilliance == 0 ? 1.0f
                                                  : std::pow(cosine, finish.brilliance);
    sum += turned * light * diffuse;
    if (lamp.has_shadow) sum += compute_highlight(surface, away / distance, to_eye, light, cosine);
  }
  return sum;
}

float encode_srgb(float value) {
  return value <= 0.0031308f ? 12.92f * value : 1.055f * std::pow(value, 1 / 2.4f) - 0.055f;
}

}  // namespace mien

#include "clip/ink_lamp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "clip/view.hpp"
#include "core/conventions.hpp"
#include "core/error.hpp"
#include "core/smooth.hpp"

namespace mien {

namespace {

// A light set of templates/povray as ink has it.
struct InkLightSet {
  std::string_view name;
  double aside_deg = 0, up_deg = 0;  // of its key, to the picture's left and up
  glm::vec3 lit{1}, dark{1};         // the hues of its key and of what fills its shadows
};

// The studio's is ink's own lamp, and stands in no row.
constexpr std::array kInkLightSets{InkLightSet{"side", 58, 30, {1, 0.98f, 0.95f}, {0.46f, 0.54f, 0.70f}},
                                   InkLightSet{"low", 14, -48, {1, 0.97f, 0.88f}, {0.50f, 0.58f, 0.78f}},
                                   InkLightSet{"candle", 26, -17, {1, 0.80f, 0.52f}, {0.42f, 0.36f, 0.38f}},
                                   InkLightSet{"moon", -62, 42, {0.55f, 0.72f, 1}, {0.20f, 0.32f, 0.62f}},
                                   InkLightSet{"rim", 138, 24, {1, 0.97f, 0.92f}, {0.22f, 0.25f, 0.32f}}};

// As stage_lights of templates/povray/lights.inc.
constexpr double kFollow_deg = 40;

glm::dvec3 find_way(const InkLightSet& set, double angle_deg, const CameraView& view) {
  return find_direction(
      kFollow_deg * std::sin(view.angle_deg * kRadiansPerDegree) - set.aside_deg + angle_deg, set.up_deg);
}

}  // namespace

std::optional<InkLamp> find_ink_lamp(const std::vector<LightShare>& lights, const CameraView& view) {
  if (lights.empty()) return {};
  constexpr double kNoWay = 1e-3;                   // of two lamps that stand opposite each other
  constexpr float kBeside = -0.1f, kBefore = 0.5f;  // cosines of a lamp's angle to the view
  InkLamp lamp{{0, 0, 0}, glm::vec3(0), glm::vec3(0), glm::vec3(1)};
  for (const LightShare& light : lights) {
    const auto set = std::ranges::find(kInkLightSets, light.set, &InkLightSet::name);
    const bool is_own = set == kInkLightSets.end();
    const auto bright = static_cast<float>(light.bright);
    lamp.to_light += light.bright *
                     (is_own ? find_own_lamp(view, light.angle_deg) : find_way(*set, light.angle_deg, view));
    lamp.lit += bright * (is_own ? glm::vec3(1) : set->lit);
    lamp.dark += bright * (is_own ? glm::vec3(1) : set->dark);
  }
  lamp.to_light =
      glm::length(lamp.to_light) > kNoWay ? glm::normalize(lamp.to_light) : find_own_lamp(view, 0);
  const glm::dvec3 to_camera = find_direction(view.angle_deg, view.height_deg);
  const auto before = static_cast<float>(glm::dot(lamp.to_light, to_camera));
  lamp.flat = glm::mix(lamp.dark, lamp.lit, smooth_step(kBeside, kBefore, before));
  return lamp;
}

}  // namespace mien

// sRGB to linear light: IEC 61966-2-1.
#include "scene/surface_look.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mien {

namespace {

struct NamedLook {
  std::string_view material;
  SurfaceLook look;
};

constexpr std::array kLooks{
    NamedLook{"skin", {0.55f}},          NamedLook{"spot", {0.55f, 0.7f, true, true}},
    NamedLook{"sclera", {0.25f}},        NamedLook{"iris", {0.6f}},
    NamedLook{"cornea", {0.02f, 0.08f}}, NamedLook{"tear", {0.05f, 0.3f}},
    NamedLook{"caruncle", {0.25f}},      NamedLook{"teeth", {0.25f}},
    NamedLook{"gum", {0.35f}},           NamedLook{"tongue", {0.4f}},
    NamedLook{"hair", {0.7f, 1, true}},  NamedLook{"brow", {0.75f, 1, true}},
    NamedLook{"tress", {0.6f, 1, true}}, NamedLook{"lock", {0.5f, 1, true}},
};

}  // namespace

bool has_strands(const Part& part) { return part.material == "lock" || part.material == "tress"; }

SurfaceLook find_surface_look(const std::string& material) {
  const auto found = std::ranges::find(kLooks, material, &NamedLook::material);
  return found == kLooks.end() ? SurfaceLook{} : found->look;
}

float linearize(float srgb) {
  return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

glm::vec4 compute_vertex_colour(const Part& part, const SurfaceLook& look, std::size_t vertex,
                                std::uint16_t shade) {
  const glm::vec3 srgb = glm::clamp(part.palette.at(shade).srgb, 0.0f, 1.0f);
  glm::vec4 colour(linearize(srgb.x), linearize(srgb.y), linearize(srgb.z), look.alpha);
  if (part.grain.empty()) return colour;
  if (look.is_faded) colour.w *= std::clamp(1 - glm::length(part.grain[vertex]), 0.0f, 1.0f);
  if (has_strands(part)) {
    const float along = std::clamp(part.grain[vertex].y / 100, 0.0f, 1.0f);
    const float light = along < 0.3f ? 0.75f + along / 0.3f * 0.25f : 1 + (along - 0.3f) / 0.7f * 0.2f;
    for (int k = 0; k < 3; ++k) colour[k] = std::min(colour[k] * light, 1.0f);
  }
  return colour;
}

}  // namespace mien

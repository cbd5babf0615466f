#include "head/skin_texture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/error.hpp"
#include "core/text.hpp"
#include "import/read_picture.hpp"

namespace mien {

namespace {

constexpr std::size_t kMostShades = 4096;
constexpr int kPaintGlossSteps = 12;

using Stepped = std::array<int, 4>;  // a colour and a gloss in steps

Stepped step_shade(const Shade& shade, int steps) {
  const auto step = [&](float value, int count) {
    return static_cast<int>(std::lround(value * static_cast<float>(count)));
  };
  return {step(shade.srgb.x, steps), step(shade.srgb.y, steps), step(shade.srgb.z, steps),
          step(shade.gloss, kPaintGlossSteps)};
}

// False: more shades than there may be.
bool share_shades(const std::vector<Shade>& wanted, int steps, Part& skin) {
  std::map<Stepped, std::uint16_t> known;
  skin.palette.clear();
  skin.shade.clear();
  for (const Shade& shade : wanted) {
    const auto [found, is_new] =
        known.emplace(step_shade(shade, steps), static_cast<std::uint16_t>(known.size()));
    if (is_new) skin.palette.push_back(shade);
    if (known.size() > kMostShades) return false;
    skin.shade.push_back(found->second);
  }
  return true;
}

// The mean of the picture round each vertex, as far as half-way to its neighbours: one place alone would make
// steps of every painted edge.
std::vector<glm::vec3> average_around(const Atlas& atlas, const Picture& picture, std::size_t count) {
  std::vector<glm::vec3> sums(count, glm::vec3(0));
  std::vector<float> weights(count, 0);
  for (const Triangle& triangle : atlas.triangles)
    for (int k = 0; k < 3; ++k) {
      const glm::vec2 &own = atlas.places[triangle[k]], &one = atlas.places[triangle[(k + 1) % 3]],
                      &other = atlas.places[triangle[(k + 2) % 3]];
      const std::uint32_t v = atlas.vertices[triangle[k]];
      for (const glm::vec2& place : {own, 0.75f * own + 0.25f * one, 0.6f * own + 0.2f * (one + other)}) {
        sums[v] += sample_picture(picture, place);
        weights[v] += 1;
      }
    }
  for (std::size_t v = 0; v < count; ++v) sums[v] /= std::max(weights[v], 1.0f);
  return sums;
}

// How long a side of the picture is on the skin, mm: of a picture of as much area.
float compute_side_mm(const Atlas& atlas, const Mesh& rest) {
  double skin_mm2 = 0, picture = 0;
  for (const Triangle& triangle : atlas.triangles) {
    std::array<glm::dvec3, 3> at{};
    std::array<glm::dvec2, 3> place{};
    for (int k = 0; k < 3; ++k) {
      at[k] = rest.positions[atlas.vertices[triangle[k]]];
      place[k] = atlas.places[triangle[k]];
    }
    skin_mm2 += 0.5 * glm::length(glm::cross(at[1] - at[0], at[2] - at[0]));
    const glm::dvec2 a = place[1] - place[0], b = place[2] - place[0];
    picture += 0.5 * std::abs(a.x * b.y - a.y * b.x);
  }
  return picture > 0 ? static_cast<float>(std::sqrt(skin_mm2 / picture)) : 1;
}

}  // namespace

void paint_skin(const std::shared_ptr<const Atlas>& atlas, const FileReference& texture, Part& skin) {
  Picture picture;
  if (const std::string fault = read_picture(texture.path, picture); !fault.empty())
    throw InputError({Diagnostic{
        texture.place, fmt::format("'{}' {}", texture.path.filename().string(), fault), "", false}});
  const std::vector<glm::vec3> colours = average_around(*atlas, picture, skin.rest.positions.size());
  std::vector<Shade> wanted;
  for (std::size_t v = 0; v < colours.size(); ++v)
    wanted.push_back({colours[v], skin.palette[skin.shade.empty() ? 0 : skin.shade[v]].gloss});
  for (int steps = 128; !share_shades(wanted, steps, skin); steps /= 2) {
  }
  skin.picture = std::make_shared<PartPicture>(
      PartPicture{texture.path, fmt::format("skin_{}.png", hash_hex(read_file(texture.path))), atlas,
                  compute_side_mm(*atlas, skin.rest)});
}

}  // namespace mien

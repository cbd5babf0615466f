#include "head/skin_texture.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>

#include "core/error.hpp"
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

}  // namespace

void paint_skin(const Atlas& atlas, const FileReference& texture, Part& skin) {
  Picture picture;
  if (const std::string fault = read_picture(texture.path, picture); !fault.empty())
    throw InputError({Diagnostic{
        texture.place, fmt::format("'{}' {}", texture.path.filename().string(), fault), "", false}});
  std::vector<Shade> wanted;
  for (std::size_t v = 0; v < skin.rest.positions.size(); ++v)
    wanted.push_back({sample_picture(picture, atlas.places[v]),
                      skin.palette[skin.shade.empty() ? 0 : skin.shade[v]].gloss});
  for (int steps = 128; !share_shades(wanted, steps, skin); steps /= 2) {
  }
}

}  // namespace mien

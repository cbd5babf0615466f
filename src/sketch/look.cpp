#include "sketch/look.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/text.hpp"
#include "scene/povray.hpp"

namespace mien {

namespace {

bool lets_through(const SketchPigment& pigment) {
  const auto is_clear = [](const SketchColour& colour) { return colour.filter > 0 || colour.transmit > 0; };
  if (pigment.pattern == SketchPattern::plain) return is_clear(pigment.colour);
  return std::ranges::any_of(pigment.stops, [&](const SketchStop& stop) {
    return stop.pigment ? lets_through(*stop.pigment) : is_clear(stop.colour);
  });
}

bool lets_through(const SketchTexture& texture) {
  return texture.others.empty()
             ? lets_through(texture.pigment)
             : std::ranges::any_of(texture.others, [](const auto& other) { return lets_through(other); });
}

SketchPart build_part(const Part& part, SdlNames& names) {
  if (!names.macros.contains(part.material + "_texture"))
    throw RunError(fmt::format("part '{}': unknown material '{}'", part.name, part.material));
  std::string text = fmt::format("#declare Wear = {};\n", format_number(part.wear, 3));
  for (const Shade& shade : part.palette) text += format_povray_texture(part, shade) + "\n";
  if (names.macros.contains(part.material + "_object")) text += part.material + "_object()\n";
  SketchPart look;
  for (const SdlItem& item : read_sdl(text, part.material, names).items) {
    if (item.word == "texture" && item.block) look.textures.push_back(build_sketch_texture(*item.block));
    if (item.word == "no_shadow") look.has_shadow = false;
    if (item.word == "no_image") look.is_seen = false;
  }
  if (look.textures.size() != part.palette.size())
    throw RunError(fmt::format("part '{}': material '{}' is not one texture", part.name, part.material));
  look.is_clear =
      std::ranges::any_of(look.textures, [](const auto& texture) { return lets_through(texture); });
  return look;
}

}  // namespace

SketchLook build_sketch_look(const Model& model, const SdlNames& names) {
  SketchLook look;
  SdlNames mine = names;
  for (const Part& part : model.parts) look.parts.push_back(build_part(part, mine));
  return look;
}

}  // namespace mien

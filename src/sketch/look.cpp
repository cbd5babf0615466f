#include "sketch/look.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/error.hpp"
#include "core/pool.hpp"
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

bool is_veil(const SketchTexture& texture) {
  return texture.others.empty() && texture.pigment.pattern == SketchPattern::plain &&
         lets_through(texture.pigment);
}

// Colours of a palette that a thread reads at a time; the skin has thousands.
constexpr std::size_t kShare = 256;

// Some colours of a part.
struct LookShare {
  const Part* part = nullptr;
  std::size_t first = 0, end = 0;
  SketchPart look;
};

std::vector<LookShare> share_colours(const Model& model) {
  std::vector<LookShare> shares;
  for (const Part& part : model.parts)
    for (std::size_t first = 0; first == 0 || first < part.palette.size(); first += kShare)
      shares.push_back({&part, first, std::min(part.palette.size(), first + kShare), {}});
  return shares;
}

// `names` have what a text declares before; one material declares nothing that another reads.
void read_look(LookShare& share, SdlNames& names) {
  const Part& part = *share.part;
  if (!names.macros.contains(part.material + "_texture"))
    throw RunError(fmt::format("part '{}': unknown material '{}'", part.name, part.material));
  std::string text = fmt::format("#declare Wear = {};\n", format_number(part.wear, 3));
  for (std::size_t i = share.first; i < share.end; ++i)
    text += format_povray_texture(part, part.palette[i]) + "\n";
  if (names.macros.contains(part.material + "_object")) text += part.material + "_object()\n";
  SketchPart& look = share.look;
  for (const SdlItem& item : read_sdl(text, part.material, names).items) {
    if (item.word == "texture" && item.block) look.textures.push_back(build_sketch_texture(*item.block));
    if (item.word == "no_shadow") look.has_shadow = false;
    if (item.word == "no_image") look.is_seen = false;
  }
  if (look.textures.size() != share.end - share.first)
    throw RunError(fmt::format("part '{}': material '{}' is not one texture", part.name, part.material));
  look.is_clear =
      std::ranges::any_of(look.textures, [](const auto& texture) { return lets_through(texture); });
  look.is_veil = std::ranges::all_of(look.textures, is_veil);
}

}  // namespace

SketchLook build_sketch_look(const Model& model, const SdlNames& names) {
  std::vector<LookShare> shares = share_colours(model);
  const int jobs = count_workers();
  std::vector<SdlNames> own(static_cast<std::size_t>(jobs), names);
  for_each_index(shares.size(), jobs, [&](std::size_t i, int worker) {
    read_look(shares[i], own[static_cast<std::size_t>(worker)]);
  });
  SketchLook look;
  for (LookShare& share : shares) {
    if (share.first == 0) {
      look.parts.push_back(std::move(share.look));
      continue;
    }
    SketchPart& part = look.parts.back();
    std::ranges::move(share.look.textures, std::back_inserter(part.textures));
    part.is_clear = part.is_clear || share.look.is_clear;
    part.is_veil = part.is_veil && share.look.is_veil;
  }
  return look;
}

}  // namespace mien

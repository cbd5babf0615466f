#include "frames/ink_regions.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "core/smooth.hpp"
#include "head/beard.hpp"
#include "head/cage.hpp"
#include "head/hair.hpp"
#include "head/ink_colours.hpp"
#include "head/skin_masks.hpp"

namespace mien {

namespace {

// What is nearer to the front of this list stands before the others where they overlap.
// A blush pales toward its edge in steps, the reddest first: with fewer each of them is seen.
constexpr int kFlushSteps = 10;
constexpr float kOneTone = 2;  // a gloss of materials_drawn.inc
enum Region : std::uint16_t {
  kInside,
  kHole,
  kLidWall,
  kRed,
  kBearded,
  kHaired,
  kFlush,
  kPlain = kFlush + kFlushSteps,
  kRegionCount
};

// The skin's triangles while they are cut along the borders of its regions.
struct Cutting {
  std::vector<Triangle> triangles;
  std::vector<std::vector<float>> fields;  // of each region's border: above 0 inside it, for all vertices
  std::vector<CutVertex> cuts;
};

// Splits whatever crosses the border of a field; what lies nearly on it is put on it.
void cut_along(std::size_t f, Cutting& cutting) {
  constexpr float kNear =
      0.06f;  // nearer to a corner of a triangle, as a share of the edge, a cut goes through it
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> known;
  const auto value = [&](std::uint32_t v) { return cutting.fields[f][v]; };
  const auto crosses = [&](std::uint32_t a, std::uint32_t b) { return value(a) * value(b) < 0; };
  const auto cut = [&](std::uint32_t a, std::uint32_t b) {
    const std::array<std::uint32_t, 2> edge{std::min(a, b), std::max(a, b)};
    const auto [entry, is_new] =
        known.try_emplace(edge, static_cast<std::uint32_t>(cutting.fields[f].size()));
    if (is_new) {
      const float share = std::clamp(value(edge[0]) / (value(edge[0]) - value(edge[1])), kNear, 1 - kNear);
      cutting.cuts.push_back({edge[0], edge[1], share});
      for (std::vector<float>& field : cutting.fields)
        field.push_back(&field == &cutting.fields[f] ? 0 : glm::mix(field[edge[0]], field[edge[1]], share));
    }
    return entry->second;
  };
  std::vector<Triangle> triangles;
  for (Triangle t : cutting.triangles) {
    int count = 0;
    for (int i = 0; i < 3; ++i) count += crosses(t[i], t[(i + 1) % 3]) ? 1 : 0;
    if (count == 0) {
      triangles.push_back(t);
    } else if (count == 1) {  // through a corner that lies on the border
      while (!crosses(t[0], t[1])) t = {t[1], t[2], t[0]};
      const std::uint32_t m = cut(t[0], t[1]);
      triangles.push_back({t[0], m, t[2]});
      triangles.push_back({m, t[1], t[2]});
    } else {  // t[0] alone on its side
      while (!crosses(t[0], t[1]) || !crosses(t[0], t[2])) t = {t[1], t[2], t[0]};
      const std::uint32_t m = cut(t[0], t[1]), n = cut(t[0], t[2]);
      triangles.push_back({t[0], m, n});
      triangles.push_back({m, t[1], t[2]});
      triangles.push_back({m, t[2], n});
    }
  }
  cutting.triangles = std::move(triangles);
}

// Values of the surface's vertices for all of the fine skin.
std::vector<float> spread_to_fine(const FineSkin& fine, std::vector<float> values) {
  for (const auto& [a, b] : fine.parents) values.push_back(0.5f * (values[a] + values[b]));
  return values;
}

struct Flush {
  std::vector<float> field;  // 1 in its middle, 0 at its edge
  // In profile a cheek's pad would stand before the half of the blush that is nearer to the nose: what is
  // there stays, and from the middle on it lies farther back.
  std::vector<float> cheek;
  // Seen from below it would stand before the upper half: below the middle it lies farther back.
  std::vector<float> lower_cheek;
  std::vector<glm::vec3> places;  // see InkRegions
};

Flush paint_flush(const Figure& figure, const std::vector<glm::vec3>& positions) {
  constexpr float kInner = -1.6f, kMiddle = 0.0f, kOuter = 1.2f, kBeyond = 4;
  constexpr float kLow = -1.8f, kHigh = 1.2f, kWhole = 0.6f;  // above it is the eye
  // The cheek below the blush's middle, from mouth to lid, in halves of the patch:
  constexpr float kAside = 0.8f, kFar = 1.9f, kBottom = -2.4f, kUnder = -0.9f, kBackTill = -0.2f,
                  kBackNone = 1.1f;
  constexpr float kDeepNone = -3, kDeepWhole = -0.5f;                // behind it is the ear
  constexpr float kWide_mm = 13.5f, kHigh_mm = 8.5f, kDeep_mm = 24;  // half of the patch, on an eye of 16 mm
  constexpr glm::vec3 kAside_mm(15, 4.7f, 0);                        // the middle of the cheek so told
  constexpr float kNearer_mm = 6, kOver_mm = 2;  // the blush: nearer to the nose, where light is whole
  constexpr float kHeldNone = -0.35f, kHeldWhole = 0.1f;  // of the field: about its edge
  constexpr float kRise_deg = 17, kBow = 0.3f;  // its outer end lies higher, as the cheekbone does; it hangs
  const auto size = static_cast<float>(figure.head.eye.radius_mm / 16);
  const glm::vec3 middle = positions[find_point(figure.head.cage, "q12_C4")] + size * kAside_mm;
  // Round on the cheek, which turns to the side, and not on a plane before the face.
  const glm::vec3 out = glm::normalize(figure.head.skin.normals[find_point(figure.head.cage, "q12_C4")]);
  const glm::vec3 across = glm::normalize(glm::cross(glm::vec3(0, 1, 0), out)),
                  over = glm::cross(out, across);
  const float rise = glm::radians(kRise_deg);
  const glm::vec3 level = std::cos(rise) * across + std::sin(rise) * over,
                  up = std::cos(rise) * over - std::sin(rise) * across;
  const glm::vec3 red_middle = kOver_mm * up - kNearer_mm * level;
  Flush flush;
  for (const glm::vec3& p : positions) {
    const glm::vec3 arm = (glm::vec3(std::abs(p.x), p.y, p.z) - middle) / size;
    const float along = glm::dot(arm, level) / kWide_mm;
    const float red_along = along + kNearer_mm / kWide_mm;
    const glm::vec3 share(along, glm::dot(arm, up) / kHigh_mm - kBow * along * along,
                          glm::dot(arm, out) / kDeep_mm);
    const float red_up = (glm::dot(arm, up) - kOver_mm) / kHigh_mm - kBow * red_along * red_along;
    flush.field.push_back(1 - glm::length(glm::vec3(red_along, red_up, share.z)));
    const glm::vec3 place = size * (arm - red_middle);
    flush.places.emplace_back(glm::dot(place, across), glm::dot(place, over),
                              smooth_step(kHeldNone, kHeldWhole, flush.field.back()));
    flush.cheek.push_back(smooth_step(kInner, kMiddle, share.x) *
                          (1 - smooth_step(kOuter, kBeyond, share.x)) *
                          smooth_step(kDeepNone, kDeepWhole, share.z) * smooth_step(kLow, -kWhole, share.y) *
                          (1 - smooth_step(kWhole, kHigh, share.y)));
    flush.lower_cheek.push_back(
        (1 - smooth_step(kAside, kFar, std::abs(share.x))) * smooth_step(kDeepNone, kDeepWhole, share.z) *
        smooth_step(kBottom, kUnder, share.y) * (1 - smooth_step(kBackTill, kBackNone, share.y)));
  }
  return flush;
}

// Of a tint that may be thin all over: its border lies at `border` of its most.
std::vector<float> find_border(const FineSkin& fine, const std::vector<float>& covers, float border) {
  constexpr float kNothing = 0.02f;
  std::vector<float> field = covers.empty() ? std::vector<float>(fine.base_count, -1.0f) : covers;
  const float most = covers.empty() ? 0 : *std::ranges::max_element(covers);
  for (float& value : field) value = most > kNothing ? value / most - border : -1;
  return spread_to_fine(fine, std::move(field));
}

std::vector<Shade> list_shades(const Figure& figure, const Look& look, const InkColours& colours) {
  const glm::vec3 skin = glm::clamp(look.skin * 1.12f, 0.0f, 1.0f);
  const auto blush = static_cast<float>(figure.head.design.blush);
  std::vector<Shade> shades(kRegionCount, {skin, 0});
  shades[kInside] = {colours.cavity, kOneTone};  // shade in the dark would be a stain
  shades[kHole].srgb = skin * glm::vec3(0.48f, 0.28f, 0.27f);
  // In the shade's tone: where a far eye's lids turn in to the ball light would come and go, as chips at its
  // outer corner.
  shades[kLidWall] = {skin * glm::vec3(0.88f, 0.70f, 0.70f), kOneTone};
  shades[kRed].srgb =
      look.lips ? glm::clamp(*look.lips * 1.1f, 0.0f, 1.0f) : skin * glm::vec3(0.93f, 0.70f, 0.68f);
  shades[kBearded].srgb = glm::mix(find_ink_hair(compute_beard_colour(look)), skin, 0.45f);
  shades[kHaired] = {find_ink_hair(look.hair), 1};  // with the shade of hair
  const glm::vec3 flush =
      colours.blush.value_or(skin * glm::mix(glm::vec3(1), glm::vec3(1, 0.82f, 0.79f), blush));
  for (int step = 0; step < kFlushSteps; ++step) {
    const float paler = smooth_share(static_cast<float>(step) / static_cast<float>(kFlushSteps));
    shades[kFlush + step] = {glm::mix(flush, skin, paler), paler - 1};
  }
  return shades;
}

}  // namespace

InkRegions cut_regions(const Figure& figure, const HeadSpec& spec, const InkColours& colours,
                       const std::vector<glm::vec3>& positions) {
  constexpr float kMouthBorder = 0.03f, kNostrilBorder = 0.6f, kLipBorder = 0.5f;
  constexpr float kWallBorder = 0.7f;
  constexpr float kTintBorder = 0.3f, kUnderMass = 0.96f;  // what shows beside a mass is a crumb
  constexpr float kMouthRim = 0.3f, kNostrilRim = 0.4f;    // of their masks, above which there is an opening
  const FineSkin& fine = figure.folds.skin;
  const SkinMasks masks = paint_skin_masks(figure.head);
  const auto find_field = [&](SkinMask mask, float border) {
    std::vector<float> field = spread_to_fine(fine, masks[mask]);
    for (float& value : field) value -= border;
    return field;
  };
  Cutting cutting{fine.triangles, std::vector<std::vector<float>>(kPlain), {}};
  cutting.fields[kInside] = find_field(kMouth, kMouthBorder);
  cutting.fields[kHole] = find_field(kNostril, kNostrilBorder);
  cutting.fields[kLidWall] = find_field(kRim, kWallBorder);
  cutting.fields[kRed] = find_field(kLips, kLipBorder);
  cutting.fields[kBearded] = find_border(
      fine, spec.look.beard == "none" ? std::vector<float>{} : paint_beard(figure.head, spec.look.beard),
      kTintBorder);
  const bool has_mass =
      std::ranges::any_of(figure.model.parts, [](const Part& part) { return part.name == "hair_mass"; });
  cutting.fields[kHaired] =
      find_border(fine, paint_scalp(figure.head, spec.hair), has_mass ? kUnderMass : kTintBorder);
  constexpr float kFlushWhole = 0.75f;  // of the way from its edge to its middle it is as red as it gets
  // A cheek of the skin's own colour is not cut.
  const bool is_flushed = figure.head.design.blush > 0 || colours.blush;
  const Flush flush = is_flushed ? paint_flush(figure, positions)
                                 : Flush{std::vector<float>(positions.size(), -1.0f),
                                         std::vector<float>(positions.size(), 0.0f),
                                         std::vector<float>(positions.size(), 0.0f),
                                         std::vector<glm::vec3>(positions.size(), glm::vec3(0))};
  for (int step = 0; step < kFlushSteps; ++step) {
    std::vector<float>& field = cutting.fields[static_cast<std::size_t>(kFlush + step)];
    field = flush.field;
    for (float& value : field)
      value -= kFlushWhole * static_cast<float>(kFlushSteps - 1 - step) / static_cast<float>(kFlushSteps - 1);
  }

  InkRegions regions;
  regions.cheek = flush.cheek;
  regions.lower_cheek = flush.lower_cheek;
  regions.flush_places = flush.places;
  regions.flush = colours.blush ? 1 : std::clamp(static_cast<float>(figure.head.design.blush), 0.0f, 1.0f);
  for (std::size_t v = 0; v < fine.vertex_count(); ++v)
    regions.is_opening.push_back(cutting.fields[kInside][v] + kMouthBorder >= kMouthRim ||
                                 cutting.fields[kHole][v] + kNostrilBorder >= kNostrilRim);
  for (std::size_t f = 0; f < cutting.fields.size(); ++f) cut_along(f, cutting);
  for (const Triangle& t : cutting.triangles) {
    std::uint16_t region = 0;
    const auto is_in = [&](std::uint16_t r) {
      const std::vector<float>& field = cutting.fields[r];
      return field[t[0]] + field[t[1]] + field[t[2]] > 0;
    };
    while (region < kPlain && !is_in(region)) ++region;
    regions.shade.push_back(region);
  }
  regions.cuts = std::move(cutting.cuts);
  regions.triangles = std::move(cutting.triangles);
  regions.palette = list_shades(figure, spec.look, colours);
  return regions;
}

}  // namespace mien

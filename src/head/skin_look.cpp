// Where blood shows through skin and how melanin hides it: Jimenez et al. 2010, "A practical appearance model
// for dynamic facial color": the face is yellow-ish on the forehead, red on cheeks, nose and ears, blue-ish
// at the chin.
#include "head/skin_look.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/smooth.hpp"
#include "head/adult_places.hpp"
#include "head/occlusion.hpp"
#include "head/skin_masks.hpp"
#include "head/surface.hpp"

namespace mien {

namespace {

// What light keeps of its red, green and blue in a full mask, before it leaves the skin: of a light one,
// where blood shows, and of a dark one, where melanin hides it.
struct Tint {
  glm::vec3 on_light, on_dark;
};
constexpr Tint make_tint(const glm::vec3& any) { return {any, any}; }
constexpr std::array<Tint, kSkinMaskCount> kTints = {{
    make_tint(glm::vec3(1)),                                           // lips: see compute_lip_colour
    make_tint(glm::vec3(1)),                                           // inside of the lips: there too
    make_tint(glm::vec3(1)),                                           // corners of the lips: there too
    make_tint(glm::vec3(1)),                                           // mouth: a colour of its own
    make_tint(glm::vec3(0.045f, 0.035f, 0.04f)),                       // throat
    make_tint(glm::vec3(0.07f, 0.03f, 0.025f)),                        // nostril
    {glm::vec3(0.96f, 0.70f, 0.66f), glm::vec3(1.05f, 0.84f, 0.80f)},  // rim of the lids
    {glm::vec3(0.96f, 0.89f, 0.88f), glm::vec3(0.86f, 0.82f, 0.84f)},  // lids
    make_tint(glm::vec3(0.42f, 0.34f, 0.32f)),                         // lashes' roots
    {glm::vec3(0.89f, 0.82f, 0.87f), glm::vec3(0.84f, 0.81f, 0.82f)},  // socket
    {glm::vec3(1.03f, 0.71f, 0.65f), glm::vec3(0.98f, 0.85f, 0.82f)},  // blood
    {glm::vec3(1.02f, 0.99f, 0.92f), glm::vec3(0.97f, 0.96f, 0.95f)},  // forehead
    make_tint(glm::vec3(0.95f, 0.96f, 0.98f)),                         // beard
    make_tint(glm::vec3(0.80f, 0.78f, 0.77f)),                         // brow
    make_tint(glm::vec3(1)),                                           // shine
}};

// Lips: what of the light their wet inside keeps (of dark lips it is the pink part), and how far they go back
// to the skin's colour in the corners.
constexpr Tint kInnerLip{glm::vec3(0.66f, 0.52f, 0.52f), glm::vec3(1.02f, 0.78f, 0.78f)};
constexpr float kCornerFade = 0.55f;

constexpr glm::vec3 kMouthColour{0.30f, 0.085f, 0.075f};  // linear: deep red, whatever the skin
// A photographer opens up for dark skin and stops down for light skin, whose forehead would else burn out.
constexpr float kExposure = 1.30f, kShoulder = 0.46f;
constexpr float kShadesPerChannel = 160;  // steps of the palette; fewer show as patches on dark skin
constexpr float kLightSkin = 0.45f;       // luminance from which blood shows through in full
constexpr float kGlossSteps = 16, kBloodSteps = 4;
// Light that does get into a hollow of flesh has met flesh before: it comes out redder. The share of the open
// sky to the power of these; dark skin takes the red as well.
constexpr glm::vec3 kHollowLight{0.32f, 0.46f, 0.52f}, kHollowDark{0.42f, 0.46f, 0.48f};
constexpr float kOpenEnough = 0.5f;  // share of the sky above which a place is as glossy as it is wet

glm::vec3 to_linear(const glm::vec3& srgb) { return glm::pow(srgb, glm::vec3(2.2f)); }
glm::vec3 to_srgb(const glm::vec3& linear) {
  return glm::pow(glm::clamp(linear, 0.0f, 1.0f), glm::vec3(1 / 2.2f));
}
float compute_luminance(const glm::vec3& linear) {
  return glm::dot(linear, glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

// Noise from -1 to 1 with lumps of about `lump_mm`: hashed lattice values, smoothly blended.
float sample_noise(const glm::vec3& p, float lump_mm) {
  const glm::vec3 q = p / lump_mm, cell = glm::floor(q);
  const glm::vec3 f = q - cell, t = smooth_share(f);
  const auto value = [&](int i, int j, int k) {
    auto h = static_cast<std::uint32_t>(static_cast<int>(cell.x) + i) * 73856093u ^
             static_cast<std::uint32_t>(static_cast<int>(cell.y) + j) * 19349663u ^
             static_cast<std::uint32_t>(static_cast<int>(cell.z) + k) * 83492791u;
    h = (h ^ (h >> 15)) * 2246822519u;
    h = (h ^ (h >> 13)) * 3266489917u;
    return static_cast<float>((h ^ (h >> 16)) & 0xffffu) / 32767.5f - 1.0f;
  };
  const auto along_x = [&](int j, int k) { return value(0, j, k) * (1 - t.x) + value(1, j, k) * t.x; };
  const auto along_y = [&](int k) { return along_x(0, k) * (1 - t.y) + along_x(1, k) * t.y; };
  return along_y(0) * (1 - t.z) + along_y(1) * t.z;
}

// The skin's own colour, linear, as a photographer exposes it.
glm::vec3 compute_exposed_skin(const Look& look) {
  const glm::vec3 given = to_linear(look.skin);
  return given * (kExposure - kShoulder * compute_luminance(given));
}

// Lips keep less green and blue than the skin around them; the darker the skin, the less they differ.
glm::vec3 compute_lip_colour(const glm::vec3& skin, const Look& look) {
  const auto share = static_cast<float>(look.lips ? look.lips_share : 0);
  if (share == 1) return to_linear(*look.lips);
  const float light = std::clamp(compute_luminance(skin) / kLightSkin, 0.0f, 1.0f);
  const glm::vec3 own =
      skin * glm::mix(glm::vec3(0.92f, 0.66f, 0.70f), glm::vec3(0.80f, 0.49f, 0.52f), light);
  return share == 0 ? own : glm::mix(own, to_linear(*look.lips), share);
}

// What age does to a skin's colour, at a place of the adult and in a full mask: it is uneven in patches as
// wide as a thumb, brown and pale, the cheeks' blood shows in a net of small veins, and the sockets darken.
constexpr float kOldPatch_mm = 13, kOldVein_mm = 2.2f, kOldUneven = 0.085f, kOldVeins = 0.55f,
                kOldSocket = 0.5f, kOldLips = 0.4f;
constexpr glm::vec3 kOldBrown{0.75f, 1.0f, 1.25f};  // how much more the uneven takes of green and blue

float compute_share_of_old(const NeutralHead& head) {
  const auto found = head.ages.find("old");
  return found == head.ages.end() ? 0 : static_cast<float>(found->second);
}

glm::vec3 compute_old_tint(const glm::vec3& place, float old) {
  const float uneven = 0.65f * sample_noise(place + 20.0f, kOldPatch_mm) + 0.35f * sample_noise(place, 5);
  return 1.0f - old * kOldUneven * (0.4f + 1.6f * uneven) * kOldBrown;
}

// A place of the skin as if it were peeled off the head: round the head on u, up on v, both in millimetres.
// Like a globe's: the crown and the throat are the poles; what stands out in front (the nose) pushes u on, so
// that its sides are not smeared. The two halves meet in a fold, not a seam; the slant on v keeps them from
// looking like an ink blot.
glm::vec2 unroll(const glm::vec3& p) {
  constexpr float kAxis_z_mm = -15, kRound_mm = 85;  // the head as a cylinder with round ends
  constexpr float kSlant = 0.25f, kPush = 0.4f;      // more of either smears the hollow under the brow
  const glm::vec2 flat(std::abs(p.x), p.z - kAxis_z_mm);
  const float radius = glm::length(flat), round = std::min(radius, kRound_mm);
  const float angle = std::atan2(flat.x, flat.y), pole = std::clamp(p.y / 40, -1.0f, 1.0f);
  return {round * angle - kPush * (radius - round), p.y + pole * (kRound_mm - round) + kSlant * p.x};
}

// Before the part's own: gloss of dry skin, and what sheen (mask) and socket add. Dark skin gives back little
// else, so that its sheen is what shows its form.
float compute_gloss(const SkinMasks& masks, std::size_t i, float light) {
  float gloss = 0.24f + 0.24f * masks[kShine][i] - 0.15f * masks[kSocket][i];
  gloss *= glm::mix(1.45f, 1.0f, light);
  const float lip = glm::mix(0.42f, 0.62f, masks[kLipInner][i]);  // moist, and wet inside
  gloss = std::max({gloss, lip * masks[kLips][i], masks[kMouth][i], 0.8f * masks[kRim][i]});
  return std::min(gloss, 1.0f) * (1 - masks[kNostril][i]);
}

}  // namespace

float compute_lightness(const glm::vec3& skin_srgb) {
  return std::clamp(compute_luminance(to_linear(skin_srgb)) / kLightSkin, 0.0f, 1.0f);
}

glm::vec3 compute_inner_lip_srgb(const Look& look) {
  constexpr float kShaded = 0.62f;  // little light gets there, and none of it straight from a lamp
  const glm::vec3 inner = glm::mix(kInnerLip.on_dark, kInnerLip.on_light, compute_lightness(look.skin));
  return to_srgb(kShaded * compute_lip_colour(compute_exposed_skin(look), look) * inner);
}

Part build_skin_part(const NeutralHead& head, const Look& look) {
  SkinMasks masks = paint_skin_masks(head);
  const std::vector<float> openness = measure_openness(head.skin, head.surface->mirror);

  const glm::vec3 skin = compute_exposed_skin(look);
  const float old = compute_share_of_old(head);
  glm::vec3 lips = compute_lip_colour(skin, look);
  if (!look.lips) lips = glm::mix(lips, skin * glm::vec3(0.86f, 0.72f, 0.70f), kOldLips * old);
  const float light = compute_lightness(look.skin);
  std::array<glm::vec3, kSkinMaskCount> tints{};
  for (std::size_t mask = 0; mask < kSkinMaskCount; ++mask)
    tints[mask] = glm::mix(kTints[mask].on_dark, kTints[mask].on_light, light);
  const glm::vec3 inner_lip = glm::mix(kInnerLip.on_dark, kInnerLip.on_light, light);
  const glm::vec3 hollow = glm::mix(kHollowDark, kHollowLight, light);
  Part part{.name = "skin", .material = "skin", .rest = head.skin, .palette = {}, .shade = {}, .grain = {}};
  std::map<std::array<int, 5>, std::uint16_t> known;
  part.wear = old;
  const std::vector<glm::vec3> places = compute_places_on_adult(head);
  for (std::size_t i = 0; i < head.skin.positions.size(); ++i) {
    glm::vec3 place = places[i];
    part.grain.push_back(unroll(place));
    place.x = std::abs(place.x);
    const float patches = 0.6f * sample_noise(place, 9) + 0.4f * sample_noise(place, 4);
    const float grain = sample_noise(place + 50.0f, 2.5f), sallow = sample_noise(place + 90.0f, 22);
    masks[kBlood][i] = std::clamp(masks[kBlood][i] + 0.10f * patches + 0.05f * sallow, 0.0f, 1.0f);

    glm::vec3 colour = skin;
    if (old > 0) {
      const float veins = std::max(0.0f, 1 - 4 * std::abs(sample_noise(place + 70.0f, kOldVein_mm)));
      masks[kBlood][i] *= 1 + old * kOldVeins * (veins - 0.2f);
      masks[kSocket][i] = std::min(1.0f, masks[kSocket][i] * (1 + kOldSocket * old));
      colour *= compute_old_tint(place, old);
    }
    for (std::size_t mask = kNostril; mask < kSkinMaskCount; ++mask)
      colour *= glm::mix(glm::vec3(1), tints[mask], masks[mask][i]);
    const glm::vec3 lip = glm::mix(lips, colour, kCornerFade * masks[kLipCorner][i]) *
                          glm::mix(glm::vec3(1), inner_lip, masks[kLipInner][i]) * (1 + 0.07f * patches);
    colour = glm::mix(colour, lip, masks[kLips][i]);
    colour *= 1 + 0.025f * grain;
    colour *= glm::pow(glm::vec3(openness[i]), hollow);
    colour = glm::mix(colour, kMouthColour * glm::mix(glm::vec3(1), tints[kThroat], masks[kThroat][i]),
                      masks[kMouth][i]);

    // No lamp is mirrored in a slit.
    float gloss = compute_gloss(masks, i, light) * smooth_step(0.0f, kOpenEnough, openness[i]);

    const glm::vec3 srgb = glm::round(to_srgb(colour) * kShadesPerChannel) / kShadesPerChannel;
    gloss = std::round(gloss * kGlossSteps) / kGlossSteps;
    const float blood = std::round(masks[kLips][i] * (1 - masks[kMouth][i]) * kBloodSteps) / kBloodSteps;
    const std::array<int, 5> key{static_cast<int>(srgb.x * 1000), static_cast<int>(srgb.y * 1000),
                                 static_cast<int>(srgb.z * 1000), static_cast<int>(gloss * 1000),
                                 static_cast<int>(blood * 1000)};
    const auto [entry, is_new] = known.try_emplace(key, static_cast<std::uint16_t>(part.palette.size()));
    if (is_new) part.palette.push_back(Shade{srgb, gloss, blood});
    part.shade.push_back(entry->second);
  }
  return part;
}

Part build_plain_skin_part(const NeutralHead& head, const Look& look) {
  Part part{.name = "skin", .material = "skin", .rest = head.skin, .palette = {}, .shade = {}, .grain = {}};
  part.palette.push_back(Shade{look.skin, 0});
  part.shade.assign(head.skin.positions.size(), 0);
  return part;
}

}  // namespace mien

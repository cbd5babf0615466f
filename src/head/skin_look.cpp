// Where blood shows through skin and how melanin hides it: Jimenez et al. 2010, "A practical appearance model
// for dynamic facial color": the face is yellow-ish on the forehead, red on cheeks, nose and ears, blue-ish
// at the chin.
#include "head/skin_look.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/error.hpp"
#include "head/occlusion.hpp"
#include "head/surface.hpp"

namespace mien {

namespace {

// The places that have a colour of their own, as masks from 0 to 1.
enum Mask {
  kLips,
  kMouth,
  kThroat,
  kNostril,
  kRim,
  kLid,
  kSocket,
  kBlood,
  kForehead,
  kBeard,
  kBrow,
  kShine,
  kMaskCount
};

// A mask's value on points FIRST..LAST of a ring or column: "M2", 0, 12.
struct RingValue {
  Mask mask;
  const char* ring;
  int first, last;
  double value;
};

constexpr RingValue kRingValues[] = {
    {kLips, "M0", 0, 12, 1},     {kLips, "M1", 0, 12, 1},      {kLips, "M2", 0, 12, 1},
    {kLips, "M3", 0, 12, 0.55},  {kMouth, "MB2", 0, 12, 1},    {kThroat, "MB2", 0, 12, 1},
    {kMouth, "MB1", 0, 12, 1},   {kMouth, "M0", 0, 12, 0.75},  {kNostril, "nd", 0, 7, 1},
    {kNostril, "ni", 0, 7, 0.9}, {kNostril, "nr", 0, 7, 0.25}, {kRim, "EB", 0, 15, 1},
    {kRim, "E0", 0, 15, 1},      {kRim, "E1", 0, 15, 0.8},     {kRim, "E2", 9, 15, 0.15},
    {kRim, "E2", 0, 0, 0.5},     {kLid, "E1", 0, 15, 1},       {kLid, "E2", 0, 15, 1},
    {kLid, "E3", 0, 8, 0.8},     {kLid, "E3", 9, 15, 0.5},     {kBlood, "er3", 0, 15, 0.4},
    {kBlood, "er4", 0, 15, 0.8}, {kBlood, "er5", 0, 15, 1},    {kBlood, "er6", 0, 15, 1},
    {kBlood, "er7", 0, 15, 0.8}, {kBlood, "er8", 0, 15, 0.7},  {kBlood, "er9", 0, 15, 0.7},
    {kBlood, "er10", 0, 15, 1},  {kBlood, "er11", 0, 15, 1},
};

// A mask's soft spot about a point of the skin: exp(-(distance / radius)^2). Radii are an adult's.
struct Spot {
  Mask mask;
  const char* point;
  double radius_mm;
  double value;
};

constexpr Spot kSpots[] = {
    {kBlood, "q12_C2", 17, 0.55}, {kBlood, "q11_C3", 16, 0.35}, {kBlood, "p_tip", 11, 0.75},
    {kBlood, "c3_tip", 8, 0.5},   {kBlood, "k_it", 6, 0.4},     {kBlood, "M6_12", 12, 0.3},
    {kBlood, "p_s", 8, 0.15},     {kForehead, "p_F2", 34, 1},   {kForehead, "f4_F2", 30, 0.8},
    {kSocket, "E3_12", 8, 0.55},  {kSocket, "E3_14", 7, 0.6},   {kSocket, "E3_0", 6, 0.6},
    {kSocket, "E4_1", 7, 0.3},    {kSocket, "E3_9", 7, 0.3},    {kBeard, "M6_12", 22, 0.6},
    {kBeard, "q12_C8", 22, 0.8},  {kBeard, "q11_D1", 22, 0.8},  {kBeard, "m11_D1", 22, 0.8},
    {kBeard, "MA_1", 9, 0.5},     {kBeard, "M6_9", 18, 0.8},    {kBrow, "E5_2", 4, 0.4},
    {kBrow, "E5_3", 4.5, 0.7},    {kBrow, "E5_4", 4.5, 0.7},    {kBrow, "E5_5", 4, 0.5},
    {kShine, "p_tip", 8, 1},      {kShine, "p_F1", 22, 0.6},    {kShine, "p_b1", 8, 0.7},
    {kShine, "q12_C1", 14, 0.4},  {kShine, "M6_12", 9, 0.4},
};

// What light keeps of its red, green and blue in a full mask, before it leaves the skin.
constexpr std::array<glm::vec3, kMaskCount> kTints = {
    glm::vec3(1),                     // lips: see find_lip_colour
    glm::vec3(1),                     // mouth: a colour of its own
    glm::vec3(0.30f, 0.20f, 0.20f),   // throat
    glm::vec3(0.07f, 0.03f, 0.025f),  // nostril
    glm::vec3(0.98f, 0.66f, 0.62f),   // rim of the lids
    glm::vec3(0.95f, 0.86f, 0.84f),   // lids
    glm::vec3(0.88f, 0.82f, 0.86f),   // socket
    glm::vec3(1.02f, 0.76f, 0.70f),   // blood
    glm::vec3(1.02f, 1.00f, 0.91f),   // forehead
    glm::vec3(0.95f, 0.96f, 0.98f),   // beard
    glm::vec3(0.80f, 0.78f, 0.77f),   // brow
    glm::vec3(1),                     // shine
};

constexpr glm::vec3 kMouthColour{0.20f, 0.045f, 0.04f};  // linear: deep red, whatever the skin
// A photographer opens up for dark skin and stops down for light skin, whose forehead would else burn out.
constexpr float kExposure = 1.30f, kShoulder = 0.46f;
constexpr float kShadesPerChannel = 160;  // steps of the palette; fewer show as patches on dark skin
constexpr float kGlossSteps = 16;

using Masks = std::array<std::vector<float>, kMaskCount>;

glm::vec3 to_linear(const glm::vec3& srgb) { return glm::pow(srgb, glm::vec3(2.2f)); }
glm::vec3 to_srgb(const glm::vec3& linear) {
  return glm::pow(glm::clamp(linear, 0.0f, 1.0f), glm::vec3(1 / 2.2f));
}
float find_luminance(const glm::vec3& linear) {
  return glm::dot(linear, glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

std::uint32_t find_point(const Cage& cage, const std::string& name) {
  const auto found = cage.index.find(name);
  if (found == cage.index.end()) throw RunError(fmt::format("internal: the cage has no point '{}'", name));
  return found->second;
}

void add_rings(const NeutralHead& head, Masks& masks) {
  std::array<std::vector<double>, kMaskCount> values;
  for (std::vector<double>& v : values) v.assign(head.cage.points.size(), 0.0);
  for (const RingValue& rule : kRingValues)
    for (int i = rule.first; i <= rule.last; ++i) {
      const std::uint32_t point = find_point(head.cage, fmt::format("{}_{}", rule.ring, i));
      values[rule.mask][point] = values[rule.mask][head.cage.mirror[point]] = rule.value;
    }
  for (std::size_t mask = 0; mask < kMaskCount; ++mask)
    masks[mask] = spread_over_surface(*head.surface, values[mask]);
}

// Spots lie on the left half; |x| puts their mirror images on the right one.
void add_spots(const NeutralHead& head, Masks& masks) {
  const double size = head.eye.centre.x / Eye{}.centre.x;  // of this face against the adult's
  for (const Spot& spot : kSpots) {
    const glm::vec3 centre = head.skin.positions[find_point(head.cage, spot.point)];
    const auto radius = static_cast<float>(spot.radius_mm * size);
    for (std::size_t i = 0; i < head.skin.positions.size(); ++i) {
      glm::vec3 p = head.skin.positions[i];
      p.x = std::abs(p.x);
      const glm::vec3 away = (p - centre) / radius;
      float& value = masks[spot.mask][i];
      // Spots of one mask overlap like veils, never past 1.
      value = 1 - (1 - value) * (1 - static_cast<float>(spot.value) * std::exp(-glm::dot(away, away)));
    }
  }
}

// A lip has an edge, a spot has none.
void sharpen(std::vector<float>& mask, float low, float high) {
  for (float& value : mask) {
    const float t = std::clamp((value - low) / (high - low), 0.0f, 1.0f);
    value = t * t * (3 - 2 * t);
  }
}

// Noise from -1 to 1 with lumps of about `lump_mm`: hashed lattice values, smoothly blended.
float sample_noise(const glm::vec3& p, float lump_mm) {
  const glm::vec3 q = p / lump_mm, cell = glm::floor(q);
  const glm::vec3 f = q - cell, t = f * f * (3.0f - 2.0f * f);
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

// Lips keep less green and blue than the skin around them; the darker the skin, the less they differ.
glm::vec3 find_lip_colour(const glm::vec3& skin, const Look& look) {
  if (look.lips) return to_linear(*look.lips);
  const float light = std::clamp(find_luminance(skin) / 0.45f, 0.0f, 1.0f);
  return skin * glm::mix(glm::vec3(0.92f, 0.62f, 0.66f), glm::vec3(0.76f, 0.44f, 0.47f), light);
}

// A place of the skin as if it were peeled off the head: round the head on u, up on v, both in millimetres.
// Like a globe's: the crown and the throat are the poles; what stands out in front (the nose) pushes u on, so
// that its sides are not smeared. The two halves meet in a fold, not a seam; the slant on v keeps them from
// looking like an ink blot.
glm::vec2 unroll(const glm::vec3& p) {
  constexpr float kAxis_z_mm = -15, kRound_mm = 85;  // the head as a cylinder with round ends
  constexpr float kSlant = 0.5f;
  const glm::vec2 flat(std::abs(p.x), p.z - kAxis_z_mm);
  const float radius = glm::length(flat), round = std::min(radius, kRound_mm);
  const float angle = std::atan2(flat.x, flat.y), pole = std::clamp(p.y / 40, -1.0f, 1.0f);
  return {round * angle - (radius - round), p.y + pole * (kRound_mm - round) + kSlant * p.x};
}

}  // namespace

Part build_skin_part(const NeutralHead& head, const Look& look) {
  Masks masks;
  add_rings(head, masks);
  add_spots(head, masks);
  sharpen(masks[kLips], 0.30f, 0.80f);
  sharpen(masks[kMouth], 0.15f, 0.85f);
  const std::vector<float> openness = measure_openness(head.skin, head.surface->mirror);

  const glm::vec3 given = to_linear(look.skin),
                  skin = given * (kExposure - kShoulder * find_luminance(given));
  const glm::vec3 lips = find_lip_colour(skin, look);
  Part part{.name = "skin", .material = "skin", .rest = head.skin, .palette = {}, .shade = {}, .grain = {}};
  std::map<std::array<int, 4>, std::uint16_t> known;
  for (std::size_t i = 0; i < head.skin.positions.size(); ++i) {
    glm::vec3 place = head.skin.positions[i];
    part.grain.push_back(unroll(place));
    place.x = std::abs(place.x);
    const float patches = 0.6f * sample_noise(place, 9) + 0.4f * sample_noise(place, 4);
    const float grain = sample_noise(place + 50.0f, 2.5f);
    masks[kBlood][i] = std::max(0.0f, masks[kBlood][i] + 0.10f * patches);

    glm::vec3 colour = skin;
    for (std::size_t mask = kNostril; mask < kMaskCount; ++mask)
      colour *= glm::mix(glm::vec3(1), kTints[mask], masks[mask][i]);
    colour = glm::mix(colour, lips, masks[kLips][i]);
    colour *= 1 + 0.025f * grain;
    // Light that does get into a hollow of flesh has met flesh before: it comes out redder.
    colour *= glm::pow(glm::vec3(openness[i]), glm::vec3(0.36f, 0.45f, 0.48f));
    colour = glm::mix(colour, kMouthColour * glm::mix(glm::vec3(1), kTints[kThroat], masks[kThroat][i]),
                      masks[kMouth][i]);

    float gloss = 0.25f + 0.20f * masks[kShine][i] - 0.15f * masks[kSocket][i];
    gloss = std::max({gloss, 0.62f * masks[kLips][i], masks[kMouth][i], 0.8f * masks[kRim][i]});
    gloss *= 1 - masks[kNostril][i];

    const glm::vec3 srgb = glm::round(to_srgb(colour) * kShadesPerChannel) / kShadesPerChannel;
    gloss = std::round(gloss * kGlossSteps) / kGlossSteps;
    const std::array<int, 4> key{static_cast<int>(srgb.x * 1000), static_cast<int>(srgb.y * 1000),
                                 static_cast<int>(srgb.z * 1000), static_cast<int>(gloss * 1000)};
    const auto [entry, is_new] = known.try_emplace(key, static_cast<std::uint16_t>(part.palette.size()));
    if (is_new) part.palette.push_back(Shade{srgb, gloss});
    part.shade.push_back(entry->second);
  }
  return part;
}

}  // namespace mien

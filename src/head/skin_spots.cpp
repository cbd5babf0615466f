// Where spots lie: freckles where the sun falls on the face of the young, across nose and cheeks, fewer on
// the forehead (ephelides); age spots at the temples, on the forehead and the cheekbones (solar lentigines).
#include "head/skin_spots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/pool.hpp"
#include "head/adult_places.hpp"
#include "head/binding.hpp"
#include "head/cage.hpp"
#include "head/skin_look.hpp"
#include "head/skin_masks.hpp"
#include "head/surface.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kSpokes = 9;                              // fewer show as polygons in a close-up
constexpr std::array<double, 2> kRingRadii{0.55, 1.0};  // of a spot's: it bends with the skin there
constexpr double kStretchMost = 0.14;                   // longer ones look like grains of rice
constexpr int kStrengths = 8;                           // from faint to full

enum Channel : std::uint32_t { kTriangle, kAlong, kAcross, kSize, kStrength, kStretch, kTurn, kOutline };

// Spots are thrown where this is dense: exp(-(distance / radius)^2) about points of the adult, both sides.
struct Area {
  const char* point;
  double radius_mm, density;
};

struct SpotKind {
  std::uint32_t series;  // of scatter()
  std::size_t count;     // at 1, before those that fall on others are left out
  std::array<double, 2> radius_mm;
  double small;                 // exponent: 1 all sizes alike, more: mostly small ones
  double ragged;                // of the outline, as a share of the radius
  glm::vec3 on_light, on_dark;  // what a full spot lets through of the light, linear
  std::vector<Area> areas;
  double apart = 1.1;    // how near their middles come, times both radii
  bool is_even = false;  // all as strong as the skin allows, and none drawn out
};

const std::array<SpotKind, 2>& list_kinds() {
  static const std::array<SpotKind, 2> kinds{SpotKind{.series = 101,
                                                      .count = 900,
                                                      .radius_mm = {0.50, 1.45},
                                                      .small = 2.4,
                                                      .ragged = 0.16,
                                                      .on_light = {0.62f, 0.38f, 0.27f},
                                                      .on_dark = {0.50f, 0.44f, 0.40f},
                                                      .areas = {{"q12_C2", 15, 0.9},
                                                                {"q11_C3", 15, 0.5},
                                                                {"p_b1", 8, 0.7},
                                                                {"p_b2", 9, 1},
                                                                {"c2_b2", 8, 0.9},
                                                                {"p_tip", 8, 0.7},
                                                                {"p_F2", 30, 0.13},
                                                                {"f4_F2", 26, 0.10},
                                                                {"q12_C4", 18, 0.22},
                                                                {"M6_12", 16, 0.10}}},
                                             SpotKind{.series = 202,
                                                      .count = 44,
                                                      .radius_mm = {1.4, 4.0},
                                                      .small = 1.8,
                                                      .ragged = 0.26,
                                                      .on_light = {0.72f, 0.55f, 0.42f},
                                                      .on_dark = {0.55f, 0.50f, 0.46f},
                                                      .areas = {{"f4_F2", 24, 1},
                                                                {"p_F3", 30, 0.5},
                                                                {"q11_C3", 18, 0.6},
                                                                {"q11_C5", 22, 0.7},
                                                                {"q12_C2", 14, 0.3}}}};
  return kinds;
}

// Freckles as ink draws them: few, round and calm, across the nose and on both cheeks.
const SpotKind& find_ink_kind() {
  static const SpotKind kind{
      .series = 303,
      .count = 90,
      .radius_mm = {1.3, 1.7},
      .small = 1,
      .ragged = 0,
      .on_light = {0.74f, 0.50f, 0.40f},
      .on_dark = {0.55f, 0.48f, 0.44f},
      .areas = {{"q12_C2", 13, 1}, {"q11_C3", 12, 0.7}, {"p_b1", 7, 0.6}, {"c2_b2", 8, 0.8}},
      .apart = 2.1,
      .is_even = true};
  return kind;
}

// The adult's skin, and for each triangle how many spots fall on it and before it.
struct Ground {
  Mesh skin;
  std::vector<double> sum;
};

// No spots on lips, lids and what is wet.
std::vector<double> compute_bare_skin(const NeutralHead& head) {
  const SkinMasks masks = paint_skin_masks(head);
  std::vector<double> bare(head.surface->vertex_count(), 1);
  for (const SkinMask mask : {kLips, kMouth, kNostril, kRim, kLash, kLid})
    for (std::size_t i = 0; i < bare.size(); ++i) bare[i] *= 1 - static_cast<double>(masks[mask][i]);
  return bare;
}

double compute_density(const NeutralHead& head, const Mesh& adult, const SpotKind& kind, glm::vec3 place) {
  place.x = std::abs(place.x);
  double none = 1;  // areas overlap like veils
  for (const Area& area : kind.areas) {
    const glm::dvec3 away = glm::dvec3(place - adult.positions[find_point(head.cage, area.point)]);
    none *= 1 - area.density * std::exp(-glm::dot(away, away) / (area.radius_mm * area.radius_mm));
  }
  return 1 - none;
}

std::vector<double> sum_densities(const NeutralHead& head, const Mesh& adult, const std::vector<double>& bare,
                                  const SpotKind& kind) {
  std::vector<double> at(adult.positions.size());
  for (std::size_t i = 0; i < at.size(); ++i)
    at[i] = bare[i] > 0.5 ? bare[i] * compute_density(head, adult, kind, adult.positions[i]) : 0;
  std::vector<double> sums;
  double sum = 0;
  for (const auto& [a, b, c] : adult.triangles) {
    const glm::dvec3 p(adult.positions[a]);
    const double area =
        glm::length(glm::cross(glm::dvec3(adult.positions[b]) - p, glm::dvec3(adult.positions[c]) - p));
    sums.push_back(sum += area * std::min({at[a], at[b], at[c]}));
  }
  return sums;
}

struct Spot {
  std::uint32_t index = 0;
  glm::vec3 middle{0}, normal{0, 0, 1};
  double radius_mm = 1, strength = 1;
};

// The spots of a kind in a fixed order, those that would touch an earlier one left out.
std::vector<Spot> throw_spots(const Mesh& adult, const std::vector<double>& sums, const SpotKind& kind) {
  std::vector<Spot> spots;
  if (sums.empty() || sums.back() <= 0) return spots;
  for (std::uint32_t i = 0; i < kind.count; ++i) {
    const double at = scatter(kind.series, i, kTriangle) * sums.back();
    const auto triangle =
        static_cast<std::size_t>(std::upper_bound(sums.begin(), sums.end(), at) - sums.begin());
    if (triangle >= sums.size()) continue;
    const auto& [a, b, c] = adult.triangles[triangle];
    const double root = std::sqrt(scatter(kind.series, i, kAlong)), across = scatter(kind.series, i, kAcross);
    const auto u = static_cast<float>(1 - root), v = static_cast<float>(root * (1 - across)), w = 1 - u - v;
    Spot spot;
    spot.index = i;
    spot.middle = u * adult.positions[a] + v * adult.positions[b] + w * adult.positions[c];
    spot.normal = glm::normalize(u * adult.normals[a] + v * adult.normals[b] + w * adult.normals[c]);
    spot.radius_mm =
        glm::mix(kind.radius_mm[0], kind.radius_mm[1], std::pow(scatter(kind.series, i, kSize), kind.small));
    spot.strength = 0.28 + 0.72 * std::pow(scatter(kind.series, i, kStrength), 1.6);
    const bool is_free = std::none_of(spots.begin(), spots.end(), [&](const Spot& other) {
      return glm::distance(other.middle, spot.middle) <
             static_cast<float>(kind.apart * (other.radius_mm + spot.radius_mm));
    });
    if (is_free) spots.push_back(spot);
  }
  return spots;
}

// The places of the skin under a spot's vertices: its middle, then ring by ring.
std::vector<SkinPlace> find_spot_places(const Mesh& adult, const SpotKind& kind, const Spot& spot) {
  const auto reach = static_cast<float>(1.6 * spot.radius_mm + 1.5);
  const SkinPatch patch = build_skin_patch(adult, {spot.middle - reach, spot.middle + reach});
  const glm::vec3 aside = std::abs(spot.normal.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 right = glm::normalize(glm::cross(aside, spot.normal)), up = glm::cross(spot.normal, right);
  const double turn = 2 * kPi * scatter(kind.series, spot.index, kTurn),
               stretch = 1 + (kind.is_even ? 0 : kStretchMost) * scatter(kind.series, spot.index, kStretch);
  std::vector<SkinPlace> places{find_nearest_place(patch, spot.middle)};
  for (const double ring : kRingRadii)
    for (int k = 0; k < kSpokes; ++k) {
      const double angle = 2 * kPi * k / kSpokes;
      const double out = scatter(kind.series, spot.index, kOutline + static_cast<std::uint32_t>(k)) - 0.5;
      const double radius = spot.radius_mm * ring * (1 + 2 * kind.ragged * out);
      const double x = radius * stretch * std::cos(angle), y = radius / stretch * std::sin(angle);
      const auto along = static_cast<float>(x * std::cos(turn) - y * std::sin(turn)),
                 across = static_cast<float>(x * std::sin(turn) + y * std::cos(turn));
      places.push_back(find_nearest_place(patch, spot.middle + along * right + across * up));
    }
  return places;
}

void append_spot_faces(Mesh& mesh, std::uint32_t first) {
  const auto at = [&](int ring, int k) {
    return first + 1 + static_cast<std::uint32_t>(ring * kSpokes + k % kSpokes);
  };
  for (int k = 0; k < kSpokes; ++k) {
    mesh.triangles.push_back({first, at(0, k), at(0, k + 1)});
    for (int r = 1; r < static_cast<int>(kRingRadii.size()); ++r) {
      mesh.triangles.push_back({at(r - 1, k), at(r, k), at(r, k + 1)});
      mesh.triangles.push_back({at(r - 1, k), at(r, k + 1), at(r - 1, k + 1)});
    }
  }
}

// For each strength what the middle lets through.
void append_spot_palette(const SpotKind& kind, float light, std::vector<Shade>& palette) {
  for (int strength = 1; strength <= kStrengths; ++strength) {
    const glm::vec3 full = glm::mix(kind.on_dark, kind.on_light, light);
    const glm::vec3 through =
        glm::mix(glm::vec3(1), full, static_cast<float>(strength) / static_cast<float>(kStrengths));
    palette.push_back({glm::pow(through, glm::vec3(1 / 2.2f)), 0});
  }
}

// Where the vertices of a spot lie on its grain: the middle, then ring by ring.
void append_spot_grain(std::vector<glm::vec2>& grain) {
  grain.emplace_back(0);
  for (const double ring : kRingRadii)
    for (int k = 0; k < kSpokes; ++k) {
      const double angle = 2 * kPi * k / kSpokes;
      grain.emplace_back(ring * std::cos(angle), ring * std::sin(angle));
    }
}

struct Dial {
  const SpotKind* kind = nullptr;
  double value = 0;
};

std::vector<Dial> list_dials(const Look& look, bool is_ink) {
  if (is_ink) return {{&find_ink_kind(), look.freckles}};
  return {{&list_kinds()[0], look.freckles}, {&list_kinds()[1], look.age_spots}};
}

SpotPlaces::Kind place_kind(const Mesh& adult, const std::vector<double>& sums, const Dial& dial) {
  const std::vector<Spot> spots = throw_spots(adult, sums, *dial.kind);
  SpotPlaces::Kind placed;
  placed.spots.resize(static_cast<std::size_t>(std::lround(dial.value * static_cast<double>(spots.size()))));
  for_each_index(placed.spots.size(), count_workers(), [&](std::size_t i, int) {
    placed.spots[i] = {spots[i].strength, find_spot_places(adult, *dial.kind, spots[i])};
  });
  return placed;
}

bool has_spots(const Look& look, bool is_ink) {
  return look.freckles != 0 || (look.age_spots != 0 && !is_ink);
}

void append_spots(const NeutralHead& head, const SpotPlaces::Kind& placed, const Dial& dial, float light,
                  HeadPart& part) {
  constexpr double kFaint = 0.55;  // of their full strength, where the dial is near 0
  const SpotKind& kind = *dial.kind;
  Mesh& mesh = part.part.rest;
  const auto first_shade = static_cast<long>(part.part.palette.size());
  append_spot_palette(kind, light, part.part.palette);
  for (const auto& [own_strength, places] : placed.spots) {
    const double strength = kind.is_even ? 1 : own_strength * glm::mix(kFaint, 1.0, dial.value);
    const auto level = std::clamp<long>(std::lround(strength * kStrengths), 1, kStrengths);
    const auto shade = static_cast<std::uint16_t>(first_shade + level - 1);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::size_t v = 0; v < places.size(); ++v) {
      const Triangle& corners = head.skin.triangles[places[v].triangle];
      const glm::vec3& w = places[v].barycentric;
      const auto blend = [&](const std::vector<glm::vec3>& of) {
        return w.x * of[corners[0]] + w.y * of[corners[1]] + w.z * of[corners[2]];
      };
      const glm::vec3 normal = glm::normalize(blend(head.skin.normals));
      mesh.positions.push_back(blend(head.skin.positions) + kSpotLift_mm * normal);
      mesh.normals.push_back(normal);
      part.bindings.push_back({places[v].triangle, w, static_cast<std::uint32_t>(first + v), 1});
      part.part.shade.push_back(shade);
    }
    append_spot_grain(part.part.grain);
    append_spot_faces(mesh, first);
  }
}

}  // namespace

SpotPlaces list_spot_places(const NeutralHead& head, const Look& look, bool is_ink) {
  SpotPlaces places;
  if (!has_spots(look, is_ink)) return places;
  Mesh adult;
  adult.positions = compute_places_on_adult(head);
  adult.triangles = head.skin.triangles;
  update_normals(adult);
  const std::vector<double> bare = compute_bare_skin(head);
  for (const Dial& dial : list_dials(look, is_ink))
    places.kinds.push_back(place_kind(adult, sum_densities(head, adult, bare, *dial.kind), dial));
  return places;
}

std::string name_spot_places(const Look& look, bool is_ink) {
  if (!has_spots(look, is_ink)) return "no spots";
  std::string name = is_ink ? "ink spots" : "spots";
  for (const Dial& dial : list_dials(look, is_ink)) name += fmt::format(" {}", dial.value);
  return name;
}

std::vector<HeadPart> build_skin_spots(const SpotPlaces& places, const NeutralHead& head, const Look& look,
                                       bool is_ink) {
  if (!has_spots(look, is_ink)) return {};
  HeadPart part;
  part.part.name = "spots";
  part.part.material = is_ink ? "ink_spot" : "spot";
  part.part.is_printed = false;
  part.mount = Mount::strands;
  const float light = compute_lightness(look.skin);
  const std::vector<Dial> dials = list_dials(look, is_ink);
  for (std::size_t i = 0; i < dials.size(); ++i) append_spots(head, places.kinds[i], dials[i], light, part);
  if (part.part.rest.triangles.empty()) return {};
  std::vector<HeadPart> parts;
  parts.push_back(std::move(part));
  return parts;
}

std::vector<HeadPart> build_skin_spots(const NeutralHead& head, const Look& look, bool is_ink) {
  return build_skin_spots(list_spot_places(head, look, is_ink), head, look, is_ink);
}

}  // namespace mien

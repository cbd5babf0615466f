// Brows and lashes, hair by hair. Each hair is a small rigid tube bound to the skin at its root.
// How brow hairs lie: up and fanned at the inner end, swept outward in the body with the lower hairs rising
// and the upper ones falling to a common ridge, flat along the tail (Goldfinger, "Human Anatomy for Artists",
// 1991).
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/conventions.hpp"
#include "head/binding.hpp"
#include "head/head.hpp"
#include "head/lids.hpp"
#include "head/part_numbers.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

constexpr int kSides = 3;               // of a hair: it is thinner than a pixel
constexpr double kAdultBrow_mm = 46.0;  // c2_g to E5_6 along the adult's stations: brows scale with it

enum Channel : std::uint32_t { kAlong, kAcross, kKeep, kLength, kTurn, kShade };  // of scatter()

void bind_new_vertices(HeadPart& part, const SkinPlace& root) {
  const auto first = part.bindings.empty() ? 0 : part.bindings.back().first + part.bindings.back().count;
  const auto count = static_cast<std::uint32_t>(part.part.rest.positions.size()) - first;
  part.bindings.push_back({root.triangle, root.barycentric, first, count});
}

HeadPart make_hair_part(const std::string& name, const std::string& material) {
  HeadPart part;
  part.part.name = name;
  part.part.material = material;
  part.mount = Mount::strands;
  return part;
}

// Shades of one colour from dark to light, a little warmer as they lighten.
constexpr int kHairShades = 6;

std::vector<Shade> make_hair_palette(const glm::vec3& colour, float spread, float gloss) {
  std::vector<Shade> palette;
  for (int i = 0; i < kHairShades; ++i) {
    const float way = 2.0f * static_cast<float>(i) / (kHairShades - 1) - 1;
    const glm::vec3 shade = colour * (1 + spread * way) + glm::vec3(0.03f, 0.01f, -0.01f) * spread * way;
    palette.push_back({glm::clamp(shade, 0.0f, 1.0f), gloss});
  }
  return palette;
}

// ---- brows

struct BrowLine {
  std::vector<glm::vec3> points;  // c2_g, E5_2 .. E5_7
  double scale = 1;
  const BrowNumbers& numbers;
};

double sample_brow(const BrowLine& line, const std::vector<double>& values, double t) {
  return sample_stations(line.numbers.station, values, t);
}

// The middle of the brow at station t, off the skin by a little; and the way outward along it.
glm::vec3 find_brow_middle(const BrowLine& line, double t) {
  const glm::vec3 along = sample_curve(line.points, t + 0.02) - sample_curve(line.points, t - 0.02);
  const glm::vec3 up = glm::normalize(glm::vec3(-along.y, along.x, 0));
  return sample_curve(line.points, t) +
         up * static_cast<float>(line.scale * sample_brow(line, line.numbers.above_mm, t));
}

BrowLine build_brow_line(const NeutralHead& head, const BrowNumbers& numbers) {
  BrowLine line{find_named_ring(head, "E5_", 2, 7), 1, numbers};
  line.points.insert(line.points.begin(), find_named_point(head, "c2_g"));
  double length_mm = 0;
  for (std::size_t i = 0; i + 2 < line.points.size(); ++i)
    length_mm += glm::distance(line.points[i], line.points[i + 1]);
  line.scale = length_mm / kAdultBrow_mm;
  return line;
}

struct BrowHair {
  glm::vec3 root{0};
  double angle_deg = 0;  // from outward to up, at the root
  double length_mm = 0;
  double t = 0;
};

// Where hair `index` would stand; `across` from -1 (lower edge) to 1 (upper edge).
BrowHair place_brow_hair(const BrowLine& line, std::uint32_t index, double t, double across) {
  const BrowNumbers& brow = line.numbers;
  const double half_mm = line.scale * sample_brow(line, brow.half_mm, t);
  const glm::vec3 along = glm::normalize(find_brow_middle(line, t + 0.05) - find_brow_middle(line, t - 0.05));
  const glm::vec3 up = glm::normalize(glm::vec3(-along.y, along.x, 0));
  const double mix = 0.5 + 0.5 * across;
  BrowHair hair;
  hair.t = t;
  hair.root = find_brow_middle(line, t) + up * static_cast<float>(across * half_mm);
  hair.angle_deg = (1 - mix) * sample_brow(line, brow.lower_angle_deg, t) +
                   mix * sample_brow(line, brow.upper_angle_deg, t) + 16 * (scatter(21, index, kTurn) - 0.5);
  hair.length_mm =
      line.scale * sample_brow(line, brow.length_mm, t) * (0.72 + 0.45 * scatter(21, index, kLength));
  // A steep hair ends near the brow's edge: it is cut where it would stand out of it.
  const double rise = std::sin(hair.angle_deg * kRadiansPerDegree) * 0.8;
  const double room = rise > 0 ? (1.25 - across) * half_mm / std::max(rise, 0.05)
                               : (1.25 + across) * half_mm / std::max(-rise, 0.05);
  hair.length_mm = std::clamp(hair.length_mm, 0.0, std::max(room, 2.6 * line.scale));
  return hair;
}

// The hair creeps along the skin in equal steps and bends outward on its way.
void append_brow_hair(HeadPart& part, const BrowLine& line, const SkinPatch& patch, const BrowHair& hair) {
  constexpr int kRings = 4;
  constexpr double kBend_deg = 22;  // from root to tip: less and the hairs look like a comb
  const SkinPlace root = find_nearest_place(patch, hair.root);
  std::vector<glm::vec3> centres;
  std::vector<float> radii;
  SkinPlace place = root;
  glm::vec3 across(0);
  for (int ring = 0; ring < kRings; ++ring) {
    const double way = static_cast<double>(ring) / (kRings - 1);
    centres.push_back(place.point +
                      place.normal * static_cast<float>(line.scale * line.numbers.lift_mm[ring]));
    radii.push_back(static_cast<float>(line.scale * line.numbers.radius_mm * (1 - 0.45 * way)));
    const glm::vec3 along =
        glm::normalize(find_brow_middle(line, hair.t + 0.05) - find_brow_middle(line, hair.t - 0.05));
    const glm::vec3 outward = glm::normalize(along - place.normal * glm::dot(along, place.normal));
    const glm::vec3 up = glm::cross(place.normal, outward);
    const double angle = (hair.angle_deg - (hair.angle_deg > 0 ? kBend_deg * way : 0)) * kRadiansPerDegree;
    const glm::vec3 ahead =
        static_cast<float>(std::cos(angle)) * outward + static_cast<float>(std::sin(angle)) * up;
    if (ring == 0) across = glm::cross(place.normal, ahead);
    const auto step = static_cast<float>(hair.length_mm / (kRings - 1));
    place = find_nearest_place(patch, place.point + step * ahead);
  }
  append_hair(part.part.rest, centres, radii, kSides, across);
  bind_new_vertices(part, root);
}

HeadPart build_brow(const NeutralHead& head, const BrowNumbers& numbers, const glm::vec3& colour) {
  const BrowLine line = build_brow_line(head, numbers);
  Box box = find_bounds(line.points);
  const auto reach = static_cast<float>(12 * line.scale);  // mm: the brow's width and the longest hair
  box.low -= reach;
  box.high += reach;
  box.low.x = std::max(box.low.x, 0.01f);  // the left half only
  const SkinPatch patch = build_skin_patch(head.skin, box);

  HeadPart part = make_hair_part("brow_left", "hair");
  part.part.palette = make_hair_palette(colour, 0.38f, 0.2f);
  const double first = numbers.station.front(), last = numbers.station.back();
  int grown = 0;
  for (std::uint32_t index = 0;
       grown < numbers.hairs && index < 20u * static_cast<std::uint32_t>(numbers.hairs); ++index) {
    // The golden ratio's multiples spread evenly along the brow, whatever share of them is kept.
    const double even = std::fmod(0.5 + 0.6180339887498949 * index, 1.0);
    const double t = first + (last - first) * even;
    const double across = 2 * scatter(21, index, kAcross) - 1;
    const double edge = 1 - 0.75 * std::pow(std::abs(across), 3);  // both edges thin out
    const double width =
        sample_brow(line, numbers.half_mm, t) / 3.3;  // the same hairs to the square millimetre
    if (scatter(21, index, kKeep) > sample_brow(line, numbers.density, t) * edge * width) continue;
    append_brow_hair(part, line, patch, place_brow_hair(line, index, t, across));
    ++grown;
    const auto shade = static_cast<std::uint16_t>(scatter(21, index, kShade) * kHairShades);
    part.part.shade.resize(part.part.rest.positions.size(), shade);
  }
  update_normals(part.part.rest);
  return part;
}

// ---- lashes

// Lash `index` of a row; `t` on the lid's margin. Groups of three lean together at their tips.
void append_lash(HeadPart& part, const Lids& lids, const LashNumbers& lashes, const LashRowNumbers& row,
                 std::uint32_t series, std::uint32_t index) {
  const double way = (index + 0.5 + 0.7 * (scatter(series, index, kAlong) - 0.5)) / row.count;
  const double t = row.from + (row.to - row.from) * way;
  const std::uint32_t group = index / 3;
  const double group_way = std::min(1.0, (3.0 * group + 1.5) / row.count);

  const SkinPlace root = find_nearest_place(lids.patch, find_on_margin(lids, t, lashes.root));
  const glm::vec3 out = glm::normalize(root.point - lids.centre);
  const glm::vec3 beyond = sample_curve(lids.beyond, t, true) - sample_curve(lids.outer, t, true);
  const glm::vec3 up = glm::normalize(beyond - out * glm::dot(beyond, out));
  glm::vec3 aside = glm::cross(up, out);  // outward on the upper lid of the left eye
  if (aside.x < 0) aside = -aside;

  // Both rows run from the inner corner outward: longest past the middle, short at both ends.
  const double arch = std::pow(std::sin(std::numbers::pi * std::pow(way, 1.25)), 0.6);
  const double length_mm = lids.scale * (row.shortest_mm + (row.longest_mm - row.shortest_mm) * arch) *
                           (0.82 + 0.36 * scatter(series, index, kLength));
  const double lean = row.fan * (way - 0.42) + 0.20 * (scatter(series, group, kTurn) - 0.5);
  const double clump = lashes.clump * (group_way - way) * row.count / 3;  // toward the group's middle
  constexpr int kRings = 4;
  std::vector<glm::vec3> centres;
  std::vector<float> radii;
  for (int ring = 0; ring <= kRings; ++ring) {
    const double s = static_cast<double>(ring) / kRings;
    const double ahead = row.out[0] * s + row.out[1] * s * s, rise = row.up[0] * s + row.up[1] * s * s;
    const double side = (lean + 0.18 * clump) * s * (0.6 + 0.4 * s);
    centres.push_back(root.point + static_cast<float>(length_mm) *
                                       (static_cast<float>(ahead) * out + static_cast<float>(rise) * up +
                                        static_cast<float>(side) * aside));
    radii.push_back(static_cast<float>(lids.scale * row.radius_mm * (1 - 0.75 * s)));
  }
  append_hair(part.part.rest, centres, radii, kSides, aside);
  bind_new_vertices(part, root);
  const auto shade = static_cast<std::uint16_t>(scatter(series, index, kShade) * kHairShades);
  part.part.shade.resize(part.part.rest.positions.size(), shade);
}

HeadPart build_lashes(const NeutralHead& head, const PartNumbers& numbers, const glm::vec3& brow) {
  const Lids lids = build_lids(head, numbers.eye.ball_mm);
  HeadPart part = make_hair_part("lash_left", "hair");
  part.part.is_printed = false;
  part.part.palette = make_hair_palette(brow * 0.28f, 0.3f, 0.05f);  // lashes are darker than any brow
  const LashRowNumbers &upper = numbers.lashes.upper, &lower = numbers.lashes.lower;
  for (int i = 0; i < upper.count; ++i)
    append_lash(part, lids, numbers.lashes, upper, 31, static_cast<std::uint32_t>(i));
  for (int i = 0; i < lower.count; ++i)
    append_lash(part, lids, numbers.lashes, lower, 32, static_cast<std::uint32_t>(i));
  update_normals(part.part.rest);
  return part;
}

}  // namespace

std::vector<HeadPart> build_hairs(const NeutralHead& head, const Look& look) {
  const PartNumbers numbers = load_part_numbers();
  std::vector<HeadPart> parts;
  parts.push_back(build_brow(head, numbers.brow, look.brow));
  parts.push_back(build_lashes(head, numbers, look.brow));
  const std::vector<HeadPart> right = mirror_parts(parts, head.skin);
  parts.insert(parts.end(), right.begin(), right.end());
  return parts;
}

}  // namespace mien

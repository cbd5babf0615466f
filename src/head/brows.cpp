// How brow hairs lie: up and fanned at the inner end, swept outward in the body with the lower hairs rising
// and the upper ones falling to a common ridge, flat along the tail (Goldfinger, "Human Anatomy for Artists",
// 1991).
#include <algorithm>
#include <cmath>

#include "core/conventions.hpp"
#include "core/smooth.hpp"
#include "head/lids.hpp"
#include "head/strands.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

enum Channel : std::uint32_t { kAcross, kKeep, kLength, kTurn, kShade };  // of scatter()

struct BrowLine {
  std::vector<glm::vec3> points;  // c2_g, E5_2 .. E5_7
  double scale = 1;               // of this brow against the adult's
  const BrowNumbers& numbers;
};

BrowLine build_brow_line(const NeutralHead& head, const BrowNumbers& numbers) {
  BrowLine line{find_named_ring(head, "E5_", 2, 7), 1, numbers};
  line.points.insert(line.points.begin(), find_named_point(head, "c2_g"));
  double length_mm = 0;
  for (std::size_t i = 0; i + 2 < line.points.size(); ++i)
    length_mm += glm::distance(line.points[i], line.points[i + 1]);
  line.scale = length_mm / numbers.line_mm;
  return line;
}

double sample_brow(const BrowLine& line, const std::vector<double>& values, double t) {
  return sample_stations(line.numbers.station, values, t);
}

// The middle of the brow at station t, near the skin.
glm::vec3 compute_brow_middle(const BrowLine& line, double t) {
  const glm::vec3 along = sample_curve(line.points, t + 0.02) - sample_curve(line.points, t - 0.02);
  const glm::vec3 up = glm::normalize(glm::vec3(-along.y, along.x, 0));
  const double above_mm = line.scale * sample_brow(line, line.numbers.above_mm, t);
  return sample_curve(line.points, t) + up * static_cast<float>(above_mm);
}

// The way outward along the brow.
glm::vec3 compute_brow_way(const BrowLine& line, double t) {
  return glm::normalize(compute_brow_middle(line, t + 0.05) - compute_brow_middle(line, t - 0.05));
}

struct BrowHair {
  glm::vec3 root{0};
  glm::vec3 along{1, 0, 0};  // the way outward along the brow
  double angle_deg = 0;      // from there to up, at the root
  double length_mm = 0;
};

// Hair `index` of `series`; `across` from -1 (lower edge) to 1 (upper edge).
BrowHair place_brow_hair(const BrowLine& line, std::uint32_t series, std::uint32_t index, double t,
                         double across) {
  const BrowNumbers& brow = line.numbers;
  const double half_mm = line.scale * sample_brow(line, brow.half_mm, t);
  BrowHair hair;
  hair.along = compute_brow_way(line, t);
  const glm::vec3 up = glm::normalize(glm::vec3(-hair.along.y, hair.along.x, 0));
  const double mix = 0.5 + 0.5 * across;
  hair.root = compute_brow_middle(line, t) + up * static_cast<float>(across * half_mm);
  hair.angle_deg = (1 - mix) * sample_brow(line, brow.lower_angle_deg, t) +
                   mix * sample_brow(line, brow.upper_angle_deg, t);
  hair.angle_deg += (16 + 0.2 * std::abs(hair.angle_deg)) * (scatter(series, index, kTurn) - 0.5);
  hair.length_mm =
      line.scale * sample_brow(line, brow.length_mm, t) * (0.72 + 0.45 * scatter(series, index, kLength));
  // A steep hair ends near the brow's edge: it is cut where it would stand out of it.
  const double rise = std::sin(hair.angle_deg * kRadiansPerDegree) * 0.8;
  const double room =
      (1.25 - std::copysign(across, rise * across)) * half_mm / std::max(std::abs(rise), 0.05);
  hair.length_mm = std::min(hair.length_mm, std::max(room, 2.6 * line.scale));
  return hair;
}

// The hair creeps along the skin in equal steps, one ring a step, and bends outward on its way.
void append_brow_hair(HeadPart& part, const BrowLine& line, const SkinPatch& patch, const BrowHair& hair,
                      const BrowCoat& coat, std::uint16_t shade) {
  constexpr double kBend_deg = 22;  // from root to tip: less and the hairs look like a comb
  std::vector<glm::vec3> centres;
  std::vector<float> radii;
  std::vector<SkinPlace> places;
  SkinPlace place = find_nearest_place(patch, hair.root);
  glm::vec3 across(0);
  const auto rings = coat.lift_mm.size();
  for (std::size_t ring = 0; ring < rings; ++ring) {
    const double way = static_cast<double>(ring) / static_cast<double>(rings - 1);
    places.push_back(place);
    centres.push_back(place.point + place.normal * static_cast<float>(line.scale * coat.lift_mm[ring]));
    radii.push_back(static_cast<float>(line.scale * coat.radius_mm * (1 - 0.45 * way)));
    const glm::vec3 outward = glm::normalize(hair.along - place.normal * glm::dot(hair.along, place.normal));
    const glm::vec3 up = glm::cross(place.normal, outward);
    const double angle = (hair.angle_deg - (hair.angle_deg > 0 ? kBend_deg * way : 0)) * kRadiansPerDegree;
    const glm::vec3 ahead =
        static_cast<float>(std::cos(angle)) * outward + static_cast<float>(std::sin(angle)) * up;
    if (ring == 0) across = glm::cross(place.normal, ahead);
    const auto step = static_cast<float>(hair.length_mm / static_cast<double>(rings - 1));
    place = find_nearest_place(patch, place.point + step * ahead);
  }
  append_hair(part.part.rest, centres, radii, kHairSides, across);
  finish_hair(part, places, shade);
}

// One coat of hairs, spread by rejection: thin where `density` says so and toward both edges, the more so
// with a `thinning` above 1.
void append_coat(HeadPart& part, const BrowLine& line, const SkinPatch& patch, const BrowCoat& coat,
                 std::uint32_t series, int first_shade, double thinning) {
  const BrowNumbers& brow = line.numbers;
  const double first = brow.station.front(), last = brow.station.back();
  const double widest_mm = *std::max_element(brow.half_mm.begin(), brow.half_mm.end());
  const auto tries = 20 * static_cast<std::uint32_t>(coat.hairs);  // more than any density above 0.1 needs
  int grown = 0;
  for (std::uint32_t index = 0; grown < coat.hairs && index < tries; ++index) {
    // The golden ratio's multiples spread evenly along the brow, whatever share of them is kept.
    const double t = first + (last - first) * std::fmod(0.5 + 0.6180339887498949 * index, 1.0);
    const double across = 2 * scatter(series, index, kAcross) - 1;
    const double edge = 1 - 0.75 * std::pow(std::abs(across), 3);
    const double room = sample_brow(line, brow.half_mm, t) / widest_mm;  // as many to the square millimetre
    const double density = std::pow(sample_brow(line, brow.density, t) * edge, thinning);
    if (scatter(series, index, kKeep) > density * room) continue;
    const auto shade = first_shade + static_cast<int>(scatter(series, index, kShade) * kHairShades);
    append_brow_hair(part, line, patch, place_brow_hair(line, series, index, t, across), coat,
                     static_cast<std::uint16_t>(shade));
    ++grown;
  }
}

SkinPatch compute_brow_patch(const NeutralHead& head, const BrowLine& line) {
  Box box = compute_bounds(line.points);
  const auto reach = static_cast<float>(12 * line.scale);  // mm: the brow's width and the longest hair
  box.low -= reach;
  box.high += reach;
  box.low.x = std::max(box.low.x, 0.01f);  // the left half only
  return build_skin_patch(head.skin, box);
}

}  // namespace

std::vector<float> paint_brows(const NeutralHead& head, const BrowNumbers& average) {
  constexpr double kStep = 0.1;  // of a station: 1 mm
  constexpr float kFar_mm = 9;   // of the adult: farther from the middle there is none
  constexpr double kSoft =
      0.45;  // of the half width, inside and outside of the edge: less shows the skin's triangles
  BrowNumbers numbers = average;
  for (double& half_mm : numbers.half_mm) half_mm *= head.brow_thickness;
  const BrowLine line = build_brow_line(head, numbers);
  std::vector<glm::vec3> middles;
  for (double t = numbers.station.front(); t <= numbers.station.back(); t += kStep)
    middles.push_back(compute_brow_middle(line, t));
  std::vector<float> covers(head.skin.positions.size(), 0.0f);
  for (std::size_t v = 0; v < covers.size(); ++v) {
    glm::vec3 p = head.skin.positions[v];
    p.x = std::abs(p.x);
    float nearest = kFar_mm * static_cast<float>(line.scale);
    std::size_t at = middles.size();
    for (std::size_t i = 0; i < middles.size(); ++i)
      if (const float far = glm::distance(p, middles[i]); far < nearest) {
        nearest = far;
        at = i;
      }
    if (at == middles.size()) continue;
    const double t = numbers.station.front() + kStep * static_cast<double>(at);
    const double half = line.scale * sample_brow(line, numbers.half_mm, t);
    const double edge =
        1 - smooth_step(1 - kSoft, 1 + kSoft, static_cast<double>(nearest) / (half + 0.6 * line.scale));
    covers[v] = static_cast<float>(edge * sample_brow(line, numbers.density, t));
  }
  return covers;
}

HeadPart build_brow(const NeutralHead& head, const BrowNumbers& average, const Look& look, double youth) {
  BrowNumbers numbers = average;
  for (double& half_mm : numbers.half_mm) half_mm *= head.brow_thickness;
  const BrowLine line = build_brow_line(head, numbers);
  const SkinPatch patch = compute_brow_patch(head, line);
  HeadPart part = make_hair_part("brow_left");
  part.part.material = "brow";
  const glm::vec3 colour = glm::mix(look.brow, look.skin, static_cast<float>(numbers.infant_blend * youth));
  part.part.palette = make_hair_palette(colour, 0.38f, 0.2f);
  const glm::vec3 soft = glm::mix(colour, look.skin * 0.8f, static_cast<float>(numbers.under_blend));
  for (const Shade& shade : make_hair_palette(soft, 0.12f, 0.0f)) part.part.palette.push_back(shade);
  append_coat(part, line, patch, numbers.under, 22, kHairShades, 2);
  append_coat(part, line, patch, numbers.over, 21, 0, 1);
  update_normals(part.part.rest);
  return part;
}

}  // namespace mien

// Lashes grow from the outer edge of the lid's margin, forward and then up (or down), in small groups.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "head/lids.hpp"
#include "head/strands.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

enum Channel : std::uint32_t {
  kAlong,
  kLength,
  kTurn,
  kShade,
  kGroup,
  kSway,
  kLift,
  kGather
};  // of scatter()

// The frame a lash grows in.
struct LashRoot {
  SkinPlace place;
  glm::vec3 out{0}, up{0}, aside{0};  // off the ball; away from the slit; outward along the margin
};

LashRoot compute_lash_root(const Lids& lids, double t, double mix) {
  LashRoot root;
  root.place = find_nearest_place(lids.patch, compute_on_margin(lids, t, mix));
  root.out = glm::normalize(root.place.point - lids.centre);
  const glm::vec3 beyond = sample_curve(lids.beyond, t, true) - sample_curve(lids.outer, t, true);
  root.up = glm::normalize(beyond - root.out * glm::dot(beyond, root.out));
  root.aside = glm::cross(root.up, root.out);
  if (root.aside.x < 0) root.aside = -root.aside;
  return root;
}

// Lash `index` of a row that runs from the inner corner outward. No two are alike: some are new and short,
// each stands a little its own way, and most, but not all, lean to the middle of their group.
void append_lash(HeadPart& part, const Lids& lids, const LashNumbers& lashes, const LashRowNumbers& row,
                 double growth, std::uint32_t series, std::uint32_t index, int first_shade) {
  const auto differ = [&](std::uint32_t which, Channel channel) {  // -0.5 to 0.5
    return scatter(series, which, channel) - 0.5;
  };
  const double way = (index + 0.5 + 0.7 * differ(index, kAlong)) / row.count;
  // Groups of two to four: a lash between two of them goes to either.
  const std::uint32_t group = (index + (scatter(series, index, kGather) < 0.5 ? 1 : 0)) / 3;
  const double group_way = std::min(1.0, (3.0 * group + 1.0 + 1.2 * differ(group, kGroup)) / row.count);
  const LashRoot root = compute_lash_root(lids, row.from + (row.to - row.from) * way, lashes.root);

  // Longest past the middle, short at both ends. The root of an even number: more are long than short.
  const double arch = std::pow(std::sin(std::numbers::pi * std::pow(way, 1.25)), 0.6);
  const double age = std::sqrt(scatter(series, index, kLength));
  const double length_mm = growth * lids.scale *
                           (row.shortest_mm + (row.longest_mm - row.shortest_mm) * arch) *
                           (0.45 + 0.68 * age);
  const double lean = row.fan * (way - 0.42) + 0.40 * differ(group, kTurn) + 0.34 * differ(index, kSway);
  const double lift = 1 + 0.30 * differ(index, kLift);
  const double gather_mm = lashes.clump * std::min(1.0, 3 * scatter(series, index, kSway)) *
                           (group_way - way) * lashes.margin_mm * lids.scale;
  constexpr int kRings = 4;
  std::vector<glm::vec3> centres;
  std::vector<float> radii;
  for (int ring = 0; ring <= kRings; ++ring) {
    const double s = static_cast<double>(ring) / kRings;
    const double out_mm = length_mm * (row.out[0] * s + row.out[1] * s * s);
    const double up_mm = length_mm * lift * (row.up[0] * s + row.up[1] * s * s);
    const double aside_mm = length_mm * lean * s * (0.6 + 0.4 * s) + gather_mm * s * s;
    centres.push_back(root.place.point + static_cast<float>(out_mm) * root.out +
                      static_cast<float>(up_mm) * root.up + static_cast<float>(aside_mm) * root.aside);
    // Thick at the root, so that the row draws a line along the lid from afar, and a hair's breadth soon
    // after. Short ones are thin.
    radii.push_back(static_cast<float>(growth * lids.scale * row.radius_mm * (0.7 + 0.3 * age) *
                                       (1 - 0.92 * std::pow(s, 0.7))));
  }
  append_hair(part.part.rest, centres, radii, kHairSides, root.aside);
  finish_hair(part, {root.place},
              static_cast<std::uint16_t>(first_shade +
                                         static_cast<int>(scatter(series, index, kShade) * kHairShades)));
}

}  // namespace

HeadPart build_lashes(const NeutralHead& head, const PartNumbers& numbers, const Look& look, double youth) {
  const Lids lids = build_lids(head, numbers.eye.ball_mm);
  const LashNumbers& lashes = numbers.lashes;
  HeadPart part = make_hair_part("lash_left");
  part.part.material = "brow";
  part.part.is_printed = false;
  part.part.palette = make_hair_palette(look.brow * 0.72f, 0.3f, 0.05f);  // darker than any brow
  // The lower ones are so fine that skin shines through.
  const glm::vec3 soft = glm::mix(look.brow * 0.72f, look.skin, 0.45f);
  for (const Shade& shade : make_hair_palette(soft, 0.2f, 0.0f)) part.part.palette.push_back(shade);
  const double growth = 1 - (1 - lashes.infant) * youth;
  const auto grow_row = [&](const LashRowNumbers& row, std::uint32_t series, int first_shade) {
    for (int i = 0; i < row.count; ++i)
      append_lash(part, lids, lashes, row, growth, series, static_cast<std::uint32_t>(i), first_shade);
  };
  grow_row(lashes.upper, 31, 0);
  grow_row(lashes.lower, 32, kHairShades);
  update_normals(part.part.rest);
  return part;
}

}  // namespace mien

// How hair runs over a head: where its border is, which way it is combed, and the way of each lock.
#pragma once

#include "head/hair.hpp"
#include "head/hair_chart.hpp"

namespace mien {

// A border as the `way` it has at each degree of azimuth on the left half, 0..180; the right half mirrors it.
using HairBorder = std::vector<double>;

// One cut on one head.
struct HairScene {
  HairCut cut;
  HairChart chart;
  HairBorder hairline, ends;  // where roots end; where tips end
  HairBorder hangs;           // 0: hair ends where it grows .. 1: it falls over what is below
  double youth = 0;           // 1: an infant's
  // From the centre to the part, at even steps from its front end, unit.
  std::vector<glm::dvec3> part_ways = {};
  glm::dvec3 knot{0}, knot_out{0};  // of gathered hair: see compute_knot
};

HairScene build_hair_scene(const NeutralHead& head, const HairCut& cut);

double sample_border(const HairBorder& border, double azimuth_deg);

// Of a table, at a place: `share` 0..1 of the way from the whorl to the hairline.
double sample_spread(const HairSpread& spread, double azimuth_deg, double share);

// What hair lies on: the skin, or what hangs over the ears; distance from the chart's axis, mm.
double compute_ground_mm(const HairScene& scene, const HairPlace& place);

// Unit: away from the ground.
glm::dvec3 compute_ground_normal(const HairScene& scene, const HairPlace& place);

// How far inside the hairline a place is, mm of the adult along the ground; less than 0 outside. Exact near
// the hairline.
double compute_inside_mm(const HairScene& scene, const HairPlace& place);

// How thick hair is at a place, mm of the adult. A fringe lies down on the forehead toward its tips.
double compute_thickness_mm(const HairScene& scene, const HairPlace& place);

// How much of the head lies about a place, against where it is most: ways run together toward the whorl, and
// are shorter behind it.
double compute_room(const HairChart& chart, const HairPlace& place);

// Roots spread evenly over the hairy skin, `count` of them; of the left half only if `is_left`. `band`: none
// nearer to the whorl than this share of the way to the hairline.
std::vector<HairPlace> spread_roots(const HairScene& scene, int count, double band, bool is_left);

// Roots along the hairline about the face where hair falls from it, `count` of them on both sides.
std::vector<HairPlace> spread_border_roots(const HairScene& scene, int count);

// Roots along the hairline over an open forehead, from where hair is combed aside; `count` of them on both
// sides.
std::vector<HairPlace> spread_front_roots(const HairScene& scene, int count);

// Roots beside the part, evenly from its front end to its back, at most `count` of them on both sides: those
// before the hairline are left out.
std::vector<HairPlace> spread_part_roots(const HairScene& scene, int count);

// How many waves a place is behind the whorl: neighbours wave together.
double compute_wave(const HairScene& scene, const HairPlace& place);

// One lock's middle line from its root to its tip.
struct HairStrand {
  HairPlace root;
  std::vector<glm::dvec3> points;  // mm
  std::vector<glm::dvec3> outs;    // unit, away from the head
  double length_mm = 0;
  double layer = 0;         // 0 deep .. 1 on top
  std::uint32_t index = 0;  // of a family: its number
};

// Lock `index` of its series from `root`: combed over the ground until its length or the border is reached.
// Empty points: nothing grows here. Those of one `family` wave together and end near each other.
HairStrand grow_strand(const HairScene& scene, const HairPlace& root, std::uint32_t index,
                       std::uint32_t family);

// Against the way hair is combed, from a place to one beside the part: there `index` of its series begins.
HairPlace trace_to_part(const HairScene& scene, const HairPlace& place, std::uint32_t index);

// The middles about which locks fall together, each a strand of its own family; none where they do not.
std::vector<HairStrand> grow_families(const HairScene& scene);

// The middle that passes nearest to a place; null without any.
const HairStrand* find_family(const HairScene& scene, const std::vector<HairStrand>& families,
                              const HairPlace& place);

// Draws a strand toward its family's middle, more and more on its way.
void fall_in(const HairScene& scene, const HairStrand& middle, HairStrand& strand);

// The way hair is combed at a place, unit, along the ground; `gone_mm` of the adult from its root.
glm::dvec3 compute_comb_way(const HairScene& scene, const HairPlace& place, double gone_mm = 0);

// From the nearest point of the part to a point of the head: how far, and which way: `ahead` as the part runs
// to the front, `aside` to the character's left. `along_mm`: that nearest point, from the part's front end.
struct PartArm {
  double distance_mm = 0, ahead = 0, aside = 0, along_mm = 0;
};
PartArm compute_part_arm(const HairScene& scene, const glm::dvec3& at);

// A point of the part, 0 its front end .. 1, as a place.
HairPlace compute_part_place(const HairScene& scene, double share);

// Where gathered hair meets: on the skin, and the way out from it.
void compute_knot(const HairScene& scene, glm::dvec3& at, glm::dvec3& out);

}  // namespace mien

// Where hair is on a head: its borders, what it lies on, how thick it is, and where it begins.
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
  glm::dvec3 knot{0}, knot_out{0};  // of gathered hair: see hair_comb.hpp
  // Where locks that hang have their rings, all at the same places or the straight pieces of one cut through
  // its neighbours': see compute_combed_mm. Rising; empty for short hair.
  std::vector<double> ring_stations = {};
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

// Roots along the hairline about the face where hair falls from it, `count` of them on both sides; those of a
// fringe closer, and one behind the other.
std::vector<HairPlace> spread_border_roots(const HairScene& scene, int count);

// Roots along the hairline over an open forehead, from where hair is combed aside; `count` of them on both
// sides.
std::vector<HairPlace> spread_front_roots(const HairScene& scene, int count);

// Roots beside the part, evenly from its front end to its back, at most `count` of them on both sides: those
// before the hairline are left out.
std::vector<HairPlace> spread_part_roots(const HairScene& scene, int count);

// How much of a wave's height there is room for at a place, 0..1: none at the hairline of an open forehead,
// where nothing falls over it.
double compute_wave_room(const HairScene& scene, const HairPlace& place);

// How many waves a place is behind the whorl: neighbours wave together.
double compute_wave(const HairScene& scene, const HairPlace& place);

}  // namespace mien

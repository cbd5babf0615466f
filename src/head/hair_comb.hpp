// Which way hair is combed over a head: from a part, to a knot, down and back.
#pragma once

#include "head/hair_growth.hpp"

namespace mien {

inline constexpr double kSkull_mm = 100;  // of the adult: what a part's side is measured on
inline constexpr double kWeight_mm = 80;  // a lock has its own weight after so much

// What of a way lies along the ground, unit; 0 where nothing does.
glm::dvec3 flatten(const glm::dvec3& way, const glm::dvec3& normal);

// From the head's centre to the part, unit: 0 its front end .. 1.
glm::dvec3 compute_part_direction(const HairComb& comb, double share);

// The same at even steps, as HairScene::part_ways has it.
std::vector<glm::dvec3> list_part_ways(const HairComb& comb);

// From the nearest point of the part to a point of the head: how far, and which way: `ahead` as the part runs
// to the front, `aside` to the character's left. `along_mm`: that nearest point, from the part's front end.
struct PartArm {
  double distance_mm = 0, ahead = 0, aside = 0, along_mm = 0;
};
PartArm compute_part_arm(const HairScene& scene, const glm::dvec3& at);

// A point of the part, 0 its front end .. 1, as a place.
HairPlace compute_part_place(const HairScene& scene, double share);

// How far a place is from the part, mm; far away where hair is gathered.
double compute_part_distance_mm(const HairScene& scene, const HairPlace& place);

// How far combed hair has come from the part at a place, mm of the adult: over the skull, and then down.
double compute_combed_mm(const HairScene& scene, const HairPlace& place);

// `count` of such distances at most, from the part to the longest tips: closer where hair bends over the
// crown.
std::vector<double> spread_ring_stations(const HairScene& scene, int count);

// A shallow groove along the part: how thick hair is there, of what it is elsewhere.
double compute_part_depth(const HairScene& scene, const HairPlace& place);

// The way hair is combed at a place, unit, along the ground; `droop` more of it falls. 0 where no way is.
glm::dvec3 compute_comb(const HairScene& scene, const glm::dvec3& at, const glm::dvec3& normal, double droop);

// The same at a place, `gone_mm` of the adult from its root; never 0.
glm::dvec3 compute_comb_way(const HairScene& scene, const HairPlace& place, double gone_mm = 0);

// Whether hair is combed out of the face at a place, 1, or ends where its cut says, 0: beside an open
// forehead long hair falls.
double compute_open(const HairScene& scene, const HairPlace& place);

// Hair that is combed from a part does not end at an open forehead: the nearer it comes to its border, the
// more `way` goes along it, away from the part, until there is room to fall.
glm::dvec3 turn_aside(const HairScene& scene, const HairPlace& place, const glm::dvec3& at,
                      const glm::dvec3& normal, const glm::dvec3& way);

// Where gathered hair meets: on the skin, and the way out from it.
void compute_knot(const HairScene& scene, glm::dvec3& at, glm::dvec3& out);

// Whether hair is combed to both sides of a line; and in such order that one can see it.
bool has_long_part(const HairScene& scene);
bool has_part(const HairScene& scene);

}  // namespace mien

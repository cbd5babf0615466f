// The way of each lock, from its root to its tip.
#pragma once

#include "head/hair_growth.hpp"

namespace mien {

// One lock's middle line from its root to its tip.
struct HairStrand {
  HairPlace root;
  std::vector<glm::dvec3> points;  // mm
  std::vector<glm::dvec3> outs;    // unit, away from the head
  double length_mm = 0;
  double layer = 0;         // 0 deep .. 1 on top
  std::uint32_t index = 0;  // of a family: its number
};

// How far along the strand each of its points is, 0 at its root .. 1 at its tip.
std::vector<double> compute_ways(const HairStrand& strand);

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

}  // namespace mien

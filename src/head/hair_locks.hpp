// What is carved into a mass of hair: locks, strands in them, tufts along them.
#pragma once

#include "head/hair.hpp"
#include "head/hair_chart.hpp"

namespace mien {

// A place among the locks.
struct LockPlace {
  std::uint32_t lock = 0;
  double across = 0;  // -1..1 between the grooves on both sides
  double split = 0;   // the same of the finer strands
};

// `turn` 0..1 around the head.
LockPlace find_lock(const HairCut& cut, double turn);

// 1 on top of a lock, 0 in the grooves: round above, sharp below. `across` -1..1.
double round_ridge(double across);

// A lock's own share, 0..1, of how far its tip reaches past the hairline.
double find_tip_share(const LockPlace& lock);

// The mass's thickness at a place, `along` 0..1 from the whorl to the hairline.
double find_thickness_mm(const HairCut& cut, const HairPlace& place, double along);

// What is carved into the mass at a place: how high it stands, mm, and how light it is, 0..1.
struct Carving {
  double height_mm = 0, light = 0;
};

// Of the strand that ends `turn` around the head.
Carving carve(const HairCut& cut, double turn, const HairPlace& place);

}  // namespace mien

// What is printed: closed solids on a base. Made by frames/, written by scene/, which need not know each
// other.
#pragma once

#include <string>
#include <vector>

#include "core/mesh.hpp"

namespace mien {

// A closed solid of the bust, by name; the source unions them all.
struct Solid {
  std::string name;  // a lower-case identifier
  Mesh mesh;         // closed, wound outwards, mm; z up, front toward -y, the character's left at +x
};

// A figure that stands on z = 0 with its foot around the z axis, and the base it goes with.
struct BustPrint {
  std::string title;      // written as a comment only, after it was cleaned
  double height_mm = 80;  // whole print with its base
  double base_height_mm =
      8;  // of the turned base the figure is set on; the figure takes the rest of the height
  double base_radius_mm = 16;
  double foot_mm = 6;         // without a base the figure is cut flat at this height, where it is broad
  double foot_radius_mm = 5;  // of the figure's round underside
  std::vector<Solid> solids;  // skin first
};

// How deep the figure's foot goes into the base, so that the two are one solid. Less than a layer might not
// join.
inline constexpr double kFootSink_mm = 0.6;

}  // namespace mien

// A drawn cut as a body to be carved: how far out its surface lies in each direction of the head.
#pragma once

#include <string>
#include <vector>

#include "head/hair_growth.hpp"

namespace mien {

// The surface at the degrees of azimuth -180 .. 179 and kWays ways of each, distances from the chart's axis.
// Where there is no hair it lies under the skin; nowhere below the hair does it recede faster, going down,
// than by 45 degrees.
struct HairRelief {
  HairChart chart;
  std::vector<double> outer_mm;
  bool covers_ears = false;
  double top_mm = 0;  // the highest y of it

  static constexpr int kAzimuths = 360, kWays = 270;  // 1.6 mm and 1.2 mm apart
};

// Whether a cut is a mass, and not paint alone. "none" is none. Throws RunError for an unknown cut.
bool has_hair_mass(const NeutralHead& head, const std::string& cut);

// What hair must leave free: points of brows and lids, which it ends above and beside, and of the chest's
// edge, which it does not hang over.
struct HairSurroundings {
  std::vector<glm::vec3> face, chest;
};

// `fine_mm`: of the head for one of the print. The hair ends in a step of at least 1.4 of them.
HairRelief build_hair_relief(const NeutralHead& head, const std::string& cut, const HairSurroundings& around,
                             double fine_mm);

double sample_hair_relief(const HairRelief& relief, const HairPlace& place);

}  // namespace mien

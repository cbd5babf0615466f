// The hollow inside of a solid that takes many poses.
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace mien {

// How far a cavity may reach for some thicknesses of its wall, the same in every pose: rows of places, one
// above the other, in columns around each row's middle.
struct CavityPlan {
  struct Wall {
    double wall_mm = 2;
    double top_mm = 0;               // the cavity's highest place, above the last middle
    std::vector<double> reaches_mm;  // from the middle, row after row; a row of zeros holds no cavity
  };

  std::vector<glm::dvec2> directions;  // of the columns as seen from above, unit, in the foot's order
  std::vector<double> heights_mm;      // of the rows, rising, from the figure's foot
  std::vector<double> middles_mm;      // y of the rows' middles; their x is 0
  std::vector<Wall> walls;             // from the thinnest on
};

}  // namespace mien

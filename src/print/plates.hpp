// Many prints on few plates.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace mien {

// Where a print stands: the low corner of its footprint on its plate.
struct PlatePlace {
  std::size_t plate = 0;
  glm::dvec2 low{0};  // mm
};

// A place for each of `footprints` (breadth and depth, mm) on plates of `plate_mm`, `gap_mm` apart from each
// other and from the plate's border: shelves, the deepest first (next-fit decreasing height, Coffman et al.
// 1980), and equal ones in their order. Throws RunError "print 3 of 120 x 90 mm does not fit a plate of 100 x
// 100 mm".
std::vector<PlatePlace> arrange_plates(const std::vector<glm::dvec2>& footprints, const glm::dvec2& plate_mm,
                                       double gap_mm);

}  // namespace mien

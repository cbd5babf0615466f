// What is drawn over a cell's face besides guide lines: outlines, levels, boxes and arrows, as in a book that
// teaches drawing.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/povray.hpp"
#include "sheet/camera.hpp"
#include "sheet/plans.hpp"

namespace mien {

// The marks of a cell lie in the picture's plane, before all of the head. `places`: of a figure's landmarks
// and points of the cage in a pose. `size_px`: of the picture.
struct DrawnMarks {
  Overlay overlay;
  double way_mm = 0;  // of the first arrow, as it goes in space
};
DrawnMarks draw_marks(const SheetCell& cell, const FigurePlaces& places, const CameraView& view,
                      std::pair<int, int> size_px);

}  // namespace mien

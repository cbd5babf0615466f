// Eyes for one colour: sculptors cut the iris as a shallow dish, drill the pupil and leave a light standing
// in it. The same formula, with the same numbers (core/print_numbers.hpp), stands in
// templates/openscad/bust.scad.
#pragma once

#include <glm/glm.hpp>

#include "frames/bust_patch.hpp"

namespace mien {

// An eye to be carved, mm of the head.
struct CarvedEye {
  glm::vec3 centre{0};
  glm::vec3 gaze{0, 0, 1};  // unit: from the centre through the pupil
  float radius_mm = 13;
  float iris_mm = 5.7f;     // radius of the iris
  float iris_depth_mm = 2;  // of the dish at the iris
  float pupil_depth_mm = 4;
  float light = 0.17f;   // half the width of the light in the pupil, in radii of the iris
  float slit_mm = 1.5f;  // rims as near as this leave a line as deep as `line_mm`; twice as far none
  float line_mm = 2;
};

// A vertex of the eye's patch: on the ball, carved; on the rims' own distance from the centre beside them.
glm::vec3 place_on_eye(const CarvedEye& eye, const PatchPlace& at);

}  // namespace mien

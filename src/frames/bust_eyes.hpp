// Eyes for one colour: sculptors cut the iris as a shallow dish, drill the pupil and leave a light standing
// in it.
#pragma once

#include <glm/glm.hpp>

#include "core/mesh.hpp"

namespace mien {

// A ball to be carved, in mm of the drawing.
struct CarvedEye {
  glm::vec3 centre{0};
  glm::vec3 gaze{0, 0, 1};  // unit: from the centre through the pupil
  glm::vec3 up{0, 1, 0};    // unit, not along the gaze: where the light stands
  float radius_mm = 13;
  float iris_mm = 5.7f;     // radius of the iris
  float iris_depth_mm = 2;  // of the dish at the iris
  float pupil_depth_mm = 4;
};

// A closed ball about `centre`, polar about the gaze, with the iris and pupil as steps of its radius.
Mesh build_carved_eye(const CarvedEye& eye);

}  // namespace mien

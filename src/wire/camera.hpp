// From places in space to places on the paper, as POV-Ray's camera of the same view has them.
#pragma once

#include "render/picture.hpp"
#include "scene/povray.hpp"

namespace mien {

struct WireCamera {
  bool is_orthographic = false;
  glm::dvec3 at{0};                                         // where it stands, mm
  glm::dvec3 look_at{0};                                    // the picture's middle
  glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, toward{0, 0, 1};  // of length 1; the last from the head to it
  double distance_mm = 1;  // from `at` to the plane in which a millimetre has `px_per_mm`
  double px_per_mm = 1;
  PictureSize size;
};

// Of a picture of this size, in pixels of which the picture's own are whole numbers.
WireCamera build_wire_camera(const CameraView& view, const PictureSize& size);

// Pixels from the picture's upper left corner.
glm::dvec2 find_paper_place(const WireCamera& camera, const glm::dvec3& place);

// How far a place lies before the camera, mm along its axis.
double compute_depth_mm(const WireCamera& camera, const glm::dvec3& place);

// From a place to the camera, of length 1.
glm::dvec3 find_way_to(const WireCamera& camera, const glm::dvec3& place);

}  // namespace mien

// What a surface sends to the eye.
//
// Source: POV-Ray 3.7 reference manual, 3.4.6.3 (finish): diffuse, brilliance, specular, phong, metallic.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/model.hpp"
#include "sketch/look.hpp"
#include "sketch/stage.hpp"

namespace mien {

struct SketchSurface {
  glm::vec3 at{0}, normal{0};  // POV-Ray's space; toward the eye
  SketchColour colour;
  SketchFinish finish;
};

// Light of lamps and its own. `visible` is how much of each lamp the surface sees, 0..1, in the stage's
// order.
glm::vec3 light_surface(const SketchStage& stage, const SketchSurface& surface, const glm::vec3& to_eye,
                        std::span<const float> visible);

// Whether a lamp lies in front of the surface.
bool faces_lamp(const SketchLamp& lamp, const SketchSurface& surface);

// Light of 0..1 as a picture holds it (IEC 61966-2-1).
float encode_srgb(float value);

}  // namespace mien

// What stands about a sketched head: camera, lamps, what eyes mirror, and what lies behind; read from the
// text that POV-Ray would read.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "sketch/sdl.hpp"
#include "sketch/texture.hpp"

namespace mien {

struct SketchLamp {
  glm::vec3 at{0};
  glm::vec3 colour{0};
  glm::vec3 side{0}, other_side{0};         // of a cloth; of a point 0
  bool has_shadow = true;                   // one without makes no highlights either
  float fade_distance = 0, fade_power = 0;  // 0: as bright far off as near
};

// A bright cloth or flame that only eyes see, in their mirror: a box of 1 on its own axes, or a ball.
struct SketchCard {
  glm::mat4x3 card_from_place{1};
  glm::vec3 low{0}, high{0};
  bool is_ball = false;  // of radius 1 about 0
  glm::vec3 colour{0};
};

struct SketchCamera {
  glm::vec3 at{0}, forward{0, 0, 1};      // `forward` reaches to the picture's plane
  glm::vec3 right{1, 0, 0}, up{0, 1, 0};  // as long as the picture is wide and high there
  bool is_orthographic = false;
};

// All in POV-Ray's space: mien's with z turned round.
struct SketchStage {
  SketchCamera camera;
  std::vector<SketchLamp> lamps;
  std::vector<SketchCard> cards;
  SketchPigment sky;
  SdlNames names;  // the materials' macros
};

// `include` is the stage's text (build_povray_stage), `start` what a frame begins with
// (append_povray_start). Throws RunError on what is not known here.
SketchStage build_sketch_stage(const std::string& include, const std::string& start, int width_px,
                               int height_px);

// What a ray that leaves the stage meets: its light, and how much of it is there (1, but where pictures are
// transparent).
glm::vec4 sample_sky(const SketchStage& stage, const glm::vec3& direction);
// The card that a ray meets first, as bright as it is; 0 if none.
glm::vec3 sample_cards(const SketchStage& stage, const glm::vec3& from, const glm::vec3& direction);

}  // namespace mien

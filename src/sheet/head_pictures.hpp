// Pictures of one head that a page needs besides the cells of a plan: sketched, or in lines.
#pragma once

#include <string>
#include <utility>

#include "frames/figure.hpp"
#include "sketch/sketch.hpp"
#include "wire/drawing.hpp"

namespace mien {

// What all sketched pictures of a page share: one ground and one light, whatever the file says.
struct HeadStage {
  std::string include;
  RenderSpec render;
  SketchDesk desk;
};

HeadStage build_head_stage(const PictureSize& size, const Templates& templates);

// `look`, which may be null, is of the model; without one its materials are asked.
Pixels sketch_head(HeadStage& stage, const CameraView& view, const Model& model, const Drawing& drawing,
                   const SketchLook* look = nullptr);

// Lines on an empty paper of the camera's size.
Paper draw_head_lines(const WireModel& model, const WireCamera& camera, int jobs);

}  // namespace mien

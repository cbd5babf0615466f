// A picture of our own: the drawing that POV-Ray would be given, traced through Embree in a fraction of its
// time, with the same camera, lamps, materials and ground. Soft shadows are sampled once a pixel and smoothed
// among neighbours; edges are traced again, finer. Nothing is random: the same input gives the same pixels.
//
// Sources: I. Wald et al., "Embree", SIGGRAPH 2014; A. Keller, W. Heidrich, "Interleaved Sampling", EGWR
// 2001.
#pragma once

#include <memory>
#include <vector>

#include "core/model.hpp"
#include "render/picture.hpp"
#include "sketch/look.hpp"
#include "sketch/stage.hpp"

namespace mien {

// One who is in the picture.
struct SketchFigure {
  const Model* model = nullptr;
  const SketchLook* look = nullptr;  // of the model
  const Drawing* drawing = nullptr;  // of the model
};

struct SketchTracer;

// What one thread traces with, again and again: a stage, and what is known of it.
struct SketchDesk {
  SketchDesk();
  SketchDesk(SketchDesk&&) noexcept;
  SketchDesk& operator=(SketchDesk&&) noexcept;
  ~SketchDesk();
  SketchStage stage;
  std::vector<glm::vec4> sky;  // what lies behind each pixel, where it has been asked; or empty
  std::unique_ptr<SketchTracer> tracer;
};

void set_stage(SketchDesk& desk, SketchStage stage);

// A picture of the desk's stage with these figures; transparent where the stage's sky is. Throws RunError if
// a drawing does not fit its model or Embree fails.
Pixels trace_sketch(SketchDesk& desk, const std::vector<SketchFigure>& figures, const PictureSize& size);

}  // namespace mien

// Lines and words over a sketched head: what append_povray_overlay writes for POV-Ray, as one more figure.
#pragma once

#include "print/glyphs.hpp"
#include "scene/povray.hpp"
#include "sketch/sketch.hpp"

namespace mien {

struct SketchOverlay {
  Model model;
  SketchLook look;
  Drawing drawing;
};

// Words are set in capitals of one stroke's width, facing the camera of `view`, whose height is to be 0.
SketchOverlay build_sketch_overlay(const Overlay& overlay, const CameraView& view, const Letters& letters);

SketchFigure find_figure(const SketchOverlay& overlay);

}  // namespace mien

// A figure in the style it is drawn in.
#pragma once

#include <optional>

#include "core/staging.hpp"
#include "frames/ink.hpp"

namespace mien {

struct DrawnFigure : Figure {
  std::optional<Ink> ink;

  // What writers are given, with drawings that draw_ink has gone over if there is ink.
  const Model& get_drawn_model() const { return ink ? ink->model : model; }
};

// `render` says the style, and of ink the colours.
DrawnFigure build_drawn_figure(const HeadStock& stock, const HeadSpec& spec, const RenderSpec& render);

}  // namespace mien

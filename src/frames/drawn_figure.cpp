#include "frames/drawn_figure.hpp"

namespace mien {

namespace {

// A cast of it: what is clear (the cornea) is solid there, and nothing has a colour of its own.
void cast_in_plaster(Model& model) {
  constexpr glm::vec3 kPlaster{0.93f, 0.91f, 0.87f};
  for (Part& part : model.parts) {
    part.material = "plaster";
    part.palette = {{kPlaster, 0}};
    part.shade.clear();
    part.grain.clear();
    part.picture.reset();
    part.wear = 0;
  }
}

}  // namespace

DrawnFigure build_drawn_figure(const HeadStock& stock, const HeadSpec& spec, const RenderSpec& render) {
  const bool is_ink = render.style == Style::ink;
  DrawnFigure figure{build_figure(stock, spec, is_ink ? FigureUse::ink : FigureUse::picture), {}};
  if (is_ink) {
    HeadSpec aged = spec;
    aged.look = compute_aged_look(spec.look, spec.age);
    figure.ink = build_ink(figure, aged, render.ink);
  }
  if (render.style == Style::plaster) cast_in_plaster(figure.model);
  return figure;
}

}  // namespace mien

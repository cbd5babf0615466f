// A posed head as a line drawing shows it.
#pragma once

#include "frames/figure.hpp"
#include "options.hpp"
#include "wire/solid.hpp"

namespace mien {

// One face of one head, somewhere on the stage.
struct WireFace {
  Pose pose;
  TurnKey turn;
  glm::dmat4 world_from_figure{1};
};

// Adds what is drawn of the head: its skin with a net of the surface's first subdivision, or the cage with
// its own quads; eyes, teeth, gums and tongue with what is sharp of them; brows and lashes hair by hair. Of
// `wanted` also Loomis' guide lines on the skin, and how far each area may go. Hair of the scalp is left out,
// so that the skull is seen. `figure` is one for pictures, not for ink.
void append_wire_head(const Figure& figure, const WireFace& face, const WireOptions& wanted,
                      WireModel& model);

}  // namespace mien

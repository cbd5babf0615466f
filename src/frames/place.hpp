// Where a figure stands on the stage.
#pragma once

#include "config/spec.hpp"
#include "core/model.hpp"

namespace mien {

// World from the figure's own space.
glm::dmat4 find_place(const PlaceSpec& place);

// From where an actor stands first to where it stands later: world from world.
glm::dmat4 find_motion(const PlaceSpec& first, const PlaceSpec& now);

// Moves all shapes of a drawing there.
void place_drawing(const glm::dmat4& world, Drawing& drawing);

}  // namespace mien

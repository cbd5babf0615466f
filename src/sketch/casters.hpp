// What throws the shadows of a drawing instead of its skin: of each closed part those triangles alone that a
// lamp needs. A ray that the part stops meets a triangle that faces the lamp and one that does not, so one of
// the two may go; without those that face it a ray from a lit place meets nothing of its own surface, which
// is most of what a soft shadow costs.
#pragma once

#include <vector>

#include "core/model.hpp"
#include "sketch/stage.hpp"

namespace mien {

// Of each part of a model whether a caster may stand for it in any drawing: it is closed, but for the few
// edges of a bust's foot and behind its lids, not rigid, and large enough to matter.
std::vector<bool> list_castable(const Model& model);

// One for each part of the model, in mien's space, without normals; none has triangles whose part throws its
// shadow itself, or none at all. `stage` has the lamps and the materials' macros, `castable` is of the model.
// Shadows of those lamps stay as they are, but for a twentieth of a millimetre by which casters lie below the
// skin.
std::vector<Mesh> build_casters(const SketchStage& stage, const Model& model, const Drawing& drawing,
                                const std::vector<bool>& castable);

}  // namespace mien

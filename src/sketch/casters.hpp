// What throws the shadows of a drawing instead of its skin: of each closed part those triangles alone that a
// lamp needs. A ray that the part stops meets a triangle that faces the lamp and one that does not, so one of
// the two may go; without those that face it a ray from a lit place meets nothing of its own surface, which
// is most of what a soft shadow costs.
#pragma once

#include <vector>

#include "core/model.hpp"
#include "sketch/stage.hpp"

namespace mien {

// One for each part of the model, in mien's space, without normals; none has triangles whose part throws its
// shadow itself: it is open, rigid or too small to matter, or throws none. `stage` has the lamps and the
// materials' macros. Shadows of those lamps stay as they are, but for a twentieth of a millimetre by which
// casters lie below the skin.
std::vector<Mesh> build_casters(const SketchStage& stage, const Model& model, const Drawing& drawing);

}  // namespace mien

// Wavefront OBJ: one group a part, right-handed millimetres, so that Blender and others open the head as it
// is.
#pragma once

#include <string>
#include <vector>

#include "core/model.hpp"

namespace mien {

// "# ..." title line, then for each part: o/g NAME, its v, vn and f lines. Positions to 1e-4 mm.
void append_wavefront(std::string& text, const Model& model, const Drawing& drawing,
                      const std::string& title);

// One object of quads, to be edited: "# ..." lines of `comment`, then o NAME, its v and f lines. Positions to
// 1e-4 mm.
void append_wavefront(std::string& text, const std::vector<glm::dvec3>& positions,
                      const std::vector<Quad>& quads, const std::string& name,
                      const std::vector<std::string>& comment);

}  // namespace mien

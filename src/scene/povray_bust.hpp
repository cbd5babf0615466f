// A picture of a print: its mesh in plaster on a table.
#pragma once

#include <string>

#include "core/mesh.hpp"
#include "core/templates.hpp"

namespace mien {

// The scene by templates/povray/bust.pov; `mesh` as it is printed (z up, front toward -y, mm). `aspect` is
// width over height.
std::string build_plaster_scene(const Mesh& mesh, double aspect, const Templates& templates);

}  // namespace mien

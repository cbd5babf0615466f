// OpenSCAD sources: self-contained busts that can be posed in the Customizer. Faces are turned
// clockwise-from-outside here.
#pragma once

#include <filesystem>
#include <string>

#include "core/print.hpp"

namespace mien {

// A customizable source (templates/openscad/bust.scad): height, base, label, hollow, and a slider for each
// move, with the whole print as one polyhedron of numbers, which OpenSCAD need not unite with anything. In
// names of expressions all but letters, digits, "_", "-" and "/" becomes "_"; equal ones are numbered. Throws
// RunError "the bust is not closed: N open edges".
std::string build_openscad_bust(const PosableBust& bust, const std::filesystem::path& templates_folder);

}  // namespace mien

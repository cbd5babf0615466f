// OpenSCAD sources: self-contained busts that can be posed in the Customizer. Faces are turned
// clockwise-from-outside here.
#pragma once

#include <filesystem>
#include <string>

#include "core/print.hpp"

namespace mien {

// A customizable source (templates/openscad/bust.scad): height, base, label, hollow, and a slider for each
// move, with the bust as one polyhedron of numbers. Names of expressions that are no plain words (letters,
// digits, "_",
// "-", "/") are left out of the menu, the one shown is called "own" then. Throws RunError "the bust is not
// closed: N open edges".
std::string build_openscad_bust(const PosableBust& bust, const std::filesystem::path& templates_folder);

}  // namespace mien

// OpenSCAD sources: self-contained busts that can be posed in the Customizer. Faces are turned
// clockwise-from-outside here.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/print.hpp"
#include "scene/stl.hpp"

namespace mien {

// A customizable source (templates/openscad/bust.scad): height, base, label, hollow, and a slider for each
// move, with the bust as one polyhedron of numbers. Names of expressions that are no plain words (letters,
// digits, "_",
// "-", "/") are left out of the menu, the one shown is called "own" then. Throws RunError "the bust is not
// closed: N open edges".
std::string build_openscad_bust(const PosableBust& bust, const std::filesystem::path& templates_folder);

// The command that makes `stl` from `source`, in OpenSCAD's own words.
std::vector<std::string> list_openscad_command(const std::filesystem::path& source,
                                               const std::filesystem::path& stl);

// The first line of OpenSCAD's output that begins with ERROR, WARNING or the like; empty if it is content.
// Its exit status does not tell: a solid that it cannot use is left out of a union with status 0.
std::string find_openscad_complaint(const std::string& output);

// Throws RunError "NAME is not one closed part: ..." and the like unless the facts of an STL file are those
// that were meant: one closed part, its box within 0.02 mm and its volume within 1 %.
void verify_print(const StlFacts& meant, const StlFacts& facts, const std::string& name);

}  // namespace mien

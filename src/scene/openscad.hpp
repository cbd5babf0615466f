// OpenSCAD sources: self-contained busts made of closed polyhedra. Faces are turned clockwise-from-outside
// here.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/print.hpp"
#include "scene/stl.hpp"

namespace mien {

// A customizable source (templates/openscad/bust.scad): height and base as Customizer variables, then the
// solids as literal polyhedra, welded at 1e-4 mm. Throws RunError "solid 'NAME' has N open edges; OpenSCAD
// would drop it", "solid 'NAME' is inside out", "solid 'NAME' is empty" or "solid name 'NAME' is not a
// lower-case identifier".
std::string build_openscad_bust(const BustPrint& bust, const std::filesystem::path& templates_folder);

// The command that makes `stl` from `source`, in OpenSCAD's own words.
std::vector<std::string> list_openscad_command(const std::filesystem::path& source,
                                               const std::filesystem::path& stl);

// The first line of OpenSCAD's output that begins with ERROR, WARNING or the like; empty if it is content.
// Its exit status does not tell: a solid that it cannot use is left out of a union with status 0.
std::string find_openscad_complaint(const std::string& output);

// Throws RunError "NAME.stl is not one closed part: ..." and the like unless the file's facts are those of
// `bust`: one closed part, as high as asked within 0.01 mm, standing on z = 0, its volume between the skin's
// alone and the sum of all.
void verify_print(const BustPrint& bust, const StlFacts& facts, const std::string& name);

}  // namespace mien

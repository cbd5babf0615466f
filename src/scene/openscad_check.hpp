// What OpenSCAD is told to do, and whether it did what was meant.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/stl.hpp"

namespace mien {

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

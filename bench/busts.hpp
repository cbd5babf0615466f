// How long a bust takes: mien's own files, and OpenSCAD with its source.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "timeline.hpp"

namespace mien {

// A line a figure, each the core's time of one program: `mien bust` of one solid bust and of one that is
// hollow, with label and magnet; OpenSCAD's STL of their sources; and OpenSCAD's of the same polyhedron
// without anything to compute. `mien` is the program's path.
void measure_busts(const std::filesystem::path& folder, const std::string& mien, const PrintRow& print);

}  // namespace mien

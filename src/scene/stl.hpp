// STL, as OpenSCAD writes it, read back: the only proof that a print is what we meant.
#pragma once

#include <cstddef>
#include <filesystem>

#include "core/mesh.hpp"

namespace mien {

// What an STL file holds, in the file's own units.
struct StlFacts {
  std::size_t triangles = 0;
  std::size_t parts = 0;  // surfaces that share no vertex; a sealed cavity inside a solid counts as one more
  std::size_t open_edges = 0;  // as count_open_edges, after equal vertices were joined: 0 says closed
  double volume_mm3 = 0;
  Box box;
};

// The triangles of a binary or ASCII file with equal corners joined into one vertex; those with fewer than
// three different corners are left out. Throws RunError "cannot read PATH: reason", "PATH: not an STL file",
// "PATH: cut short" or "PATH: not finite".
Mesh read_stl(const std::filesystem::path& path);

StlFacts measure_stl(const Mesh& mesh);

// measure_stl of what read_stl reads.
StlFacts check_stl(const std::filesystem::path& path);

}  // namespace mien

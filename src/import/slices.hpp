// Slices of a head: the lines along which planes cut it, or along which a digitiser's tip was led.
#pragma once

#include "import/polygons.hpp"

namespace mien {

// The points of one line, in order. It is closed where its last point is its first one, or as near to it as
// its points are to each other.
using Slice = std::vector<glm::dvec3>;

// Lines of point numbers, joined where they end in the same point and no third one does: many programs write
// each step as a line.
std::vector<std::vector<std::uint32_t>> chain_lines(const std::vector<std::vector<std::uint32_t>>& lines);

// Makes the mesh a cloud of points: on the lines, and on the way from each line to those beside it. Slices in
// parallel planes lie beside those of the next plane, whatever their order; others beside those before and
// behind them. Slices much further apart than most are not joined.
void fill_slices(const std::vector<Slice>& slices, Polygons& mesh);

}  // namespace mien

// What passes through itself on a print is relaxed: a drawn head's lips, which are hardly higher than a
// layer, have skin over their corners that a printer would find inside out, and in a frown that is left few
// triangles one may come through another.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/mesh.hpp"

namespace mien {

// Of one body: which vertices lie beside which, and which formulas need where they are.
struct BustRelax {
  std::vector<std::uint32_t> first, around;
  std::vector<bool> is_fixed;
};

BustRelax build_bust_relax(const std::vector<Triangle>& triangles, std::vector<bool> is_fixed);

// Moves the vertices about each place where the surface passes through itself toward their neighbours'
// middle, a ring more in every other round, until it does no more or 12 rounds are over; all others stay.
// `finish` makes of the vertices what is printed.
void relax_crossings(const BustRelax& relax, const std::vector<Triangle>& triangles,
                     const std::function<void(std::vector<glm::vec3>&)>& finish,
                     std::vector<glm::vec3>& positions);

}  // namespace mien

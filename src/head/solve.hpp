// From points on the skin to the control points of the smooth surface that passes them.
//
// Source: the limit position of a Catmull-Clark vertex is linear in the cage (Halstead, Kass, DeRose 1993):
//   L(v) = (n^2 v + 4 sum(edge neighbours) + sum(face diagonals)) / (n (n + 5)),  n the valence.
// We minimise  sum w |L(v) - target|^2 + fairness  over the whole cage. Fairness is the third difference
// where the skin is one broad form (skull, cheek, neck), which does not shrink it, and the umbrella operator
// elsewhere.
#pragma once

#include "head/cage.hpp"

namespace mien {

// Moves `cage.points` (as build_cage left them) so that the limit surface passes the half's skin points, in
// the balance of their weights and fairness. The result is an exact mirror image of itself. About 50 ms.
void solve_cage(const HalfHead& half, Cage& cage);

}  // namespace mien

#include "clip/reach.hpp"

#include "face/limits.hpp"

namespace mien {

MoveReach compute_reach(const Figure& figure) {
  MoveReach reach;
  for (const Limit& limit : measure_limits(figure.head, figure.face, figure.limits))
    (limit.name->sign > 0 ? reach.plus_mm : reach.minus_mm)[limit.name->move] = limit.mm;
  return reach;
}

}  // namespace mien

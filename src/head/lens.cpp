#include "head/lens.hpp"

#include <algorithm>
#include <cmath>

#include "core/print_numbers.hpp"
#include "core/smooth.hpp"

namespace mien {

Lens build_lens(const NeutralHead& head) {
  const DesignNumbers& design = head.design;
  return {head.eye.centre,  head.eye.radius_mm, 1 / head.eye.radius_mm, design.lens_height - 1,
          design.lens_full, design.lens_end,    design.lens_flat};
}

glm::dvec3 bend(const Lens& lens, const glm::dvec3& point) {
  const double radius = lens.radius_mm;
  const double z = (point.z - lens.centre.z) * lens.per_radius;
  if (z <= kLensBehind) return point;
  const double y = (point.y - lens.centre.y) * lens.per_radius, up = std::abs(y);
  if (up >= lens.end) return point;
  const double x = std::abs(std::abs(point.x) - lens.centre.x) * lens.per_radius;
  if (x >= kLensAside) return point;
  const double share = (1 - smooth_step(kLensWide, kLensAside, x)) * smooth_step(kLensBehind, kLensFront, z);
  const double shift =
      lens.taller * (up < lens.full ? up : lens.full * (1 - smooth_step(lens.full, lens.end, up)));
  const double near = share * (1 - smooth_step(kLensWide, kLensFar, up));
  return {point.x, point.y + std::copysign(radius * shift * share, y),
          point.z - radius * lens.flat * std::max(0.0, z - kLensForth) * near};
}

}  // namespace mien

#include "print/plates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "core/error.hpp"
#include "core/text.hpp"

namespace mien {

std::vector<PlatePlace> arrange_plates(const std::vector<glm::dvec2>& footprints, const glm::dvec2& plate_mm,
                                       double gap_mm) {
  for (std::size_t i = 0; i < footprints.size(); ++i)
    if (!(footprints[i].x + 2 * gap_mm <= plate_mm.x && footprints[i].y + 2 * gap_mm <= plate_mm.y))
      throw RunError(fmt::format("print {} of {} x {} mm does not fit a plate of {} x {} mm", i + 1,
                                 format_number(footprints[i].x, 1), format_number(footprints[i].y, 1),
                                 format_number(plate_mm.x, 1), format_number(plate_mm.y, 1)));
  std::vector<std::size_t> order(footprints.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return footprints[a].y > footprints[b].y; });
  std::vector<PlatePlace> places(footprints.size());
  std::size_t plate = 0;
  double shelf = gap_mm, depth = 0, x = gap_mm;
  for (const std::size_t i : order) {
    const glm::dvec2& size = footprints[i];
    if (x + size.x + gap_mm > plate_mm.x) {  // the next shelf
      shelf += depth + gap_mm;
      depth = 0;
      x = gap_mm;
    }
    if (shelf + size.y + gap_mm > plate_mm.y) {
      ++plate;
      shelf = x = gap_mm;
      depth = 0;
    }
    places[i] = {plate, {x, shelf}};
    x += size.x + gap_mm;
    depth = std::max(depth, size.y);
  }
  return places;
}

}  // namespace mien

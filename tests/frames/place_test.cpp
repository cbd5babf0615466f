// Where somebody stands, as a matrix.
#include "frames/place.hpp"

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(place_motion, takes_the_figure_along) {
  const PlaceSpec first{{-100, 0, 20}, 30}, now{{50, 10, -40}, 75};
  const glm::dmat4 moved = find_motion(first, now) * find_place(first), wanted = find_place(now);
  for (int column = 0; column < 4; ++column)
    EXPECT_LT(glm::distance(moved[column], wanted[column]), 1e-9) << column;
}

}  // namespace
}  // namespace mien

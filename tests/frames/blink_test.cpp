// A shut eye, on the skin as it is drawn.
#include <gtest/gtest.h>

#include "core/data.hpp"
#include "frames/figure.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

Pose shut_lids() {
  Pose pose;
  for (const Side side : {Side::left, Side::right}) pose.values[*find_move(Area::lid, side, "upper")] = -1;
  return pose;
}

TEST(blink, takes_the_lashes_along) {
  const Figure figure = build_figure(shipped().heads, HeadSpec{});
  DeformBuffers buffers;
  Drawing open, shut;
  deform_figure(figure, Pose{}, TurnKey{}, buffers, open);
  deform_figure(figure, shut_lids(), TurnKey{}, buffers, shut);
  for (std::size_t i = 0; i < figure.parts.size(); ++i) {
    if (figure.model.parts[i].name != "lash_left") continue;
    const std::size_t middle = 13 * 36;  // the root of the 36th upper lash of 72, 13 vertices each
    const glm::vec3 move = shut.parts[i].positions[middle] - open.parts[i].positions[middle];
    EXPECT_LT(move.y, -6);
    EXPECT_NEAR(move.x, 0, 1);
  }
}

}  // namespace
}  // namespace mien

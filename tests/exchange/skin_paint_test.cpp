#include "exchange/skin_paint.hpp"

#include <gtest/gtest.h>

namespace mien {
namespace {

// A square of two triangles over the whole atlas: black below, white above on the left, red above on the
// right.
struct Square {
  Part part;
  Atlas atlas{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {0, 1, 2, 3}, {{0, 1, 2}, {0, 2, 3}}};
  Square() {
    part.rest.positions.resize(4);
    part.palette = {{{0, 0, 0}, 0}, {{1, 0, 0}, 0}, {{1, 1, 1}, 0}};
    part.shade = {0, 0, 1, 2};
  }
};

TEST(skin_paint, spreads_the_colours_of_vertices) {
  const Square square;
  const Pixels pixels = bake_colours(square.part, square.atlas, 64);
  const auto take = [&](int x, int y) { return &pixels.rgb[3 * (std::size_t(y) * 64 + x)]; };
  EXPECT_NEAR(take(0, 0)[1], 255, 8) << "the atlas's top is the picture's";
  EXPECT_NEAR(take(63, 0)[0], 255, 8);
  EXPECT_NEAR(take(63, 0)[1], 0, 8);
  EXPECT_NEAR(take(32, 63)[0], 0, 8);
  EXPECT_NEAR(take(63, 32)[0], 128, 8);
}

TEST(skin_paint, fills_what_no_triangle_covers) {
  Square square;
  square.atlas.triangles.pop_back();
  const Pixels pixels = bake_colours(square.part, square.atlas, 32);
  const auto take = [&](int x, int y) { return &pixels.rgb[3 * (std::size_t(y) * 32 + x)]; };
  for (int k = 0; k < 3; ++k) EXPECT_EQ(take(0, 10)[k], take(10, 10)[k]) << "as its neighbour";
}

TEST(skin_paint, draws_edges_over_the_colours) {
  const Square square;
  const Pixels pixels = draw_layout(square.part, square.atlas, 64);
  const auto take = [&](int x, int y) { return int(pixels.rgb[3 * (std::size_t(y) * 64 + x)]); };
  EXPECT_LT(take(20, 43), take(16, 43)) << "the diagonal is darker than what is beside it";
}

}  // namespace
}  // namespace mien

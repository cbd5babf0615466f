#include "head/skin_texture.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/error.hpp"
#include "core/text.hpp"
#include "end_to_end/program.hpp"
#include "frames/figure_atlas.hpp"
#include "render/picture.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

// Red on the character's left, blue on the right.
std::filesystem::path write_halves(const std::filesystem::path& folder) {
  Pixels pixels = make_pixels({64, 64});
  for (std::size_t i = 0; i < 64 * 64; ++i) pixels.rgb[3 * i + (i % 64 < 32 ? 2 : 0)] = 255;
  write_file(folder / "skin.png", build_png(pixels));
  return folder / "skin.png";
}

TEST(skin_texture, paints_the_skin_and_keeps_its_gloss) {
  const auto folder = make_folder("skin_texture");
  HeadSpec head;
  const Figure plain = build_figure(shipped().heads, head);
  head.look.texture = FileReference{write_halves(folder), {}};
  const Figure painted = build_figure(shipped().heads, head);
  const Atlas atlas = build_figure_atlas(plain);
  const Part &before = plain.model.parts.front(), &after = painted.model.parts.front();
  ASSERT_EQ(after.shade.size(), before.rest.positions.size());
  EXPECT_EQ(after.rest.positions, before.rest.positions);
  for (std::size_t v = 0; v < after.shade.size(); ++v) {
    const Shade& shade = after.palette[after.shade[v]];
    // Soft edges: down the middle, and where both ends of the picture meet behind.
    const float off = std::abs(atlas.places[v].x - 0.5f);
    if (off < 0.06f || off > 0.48f || after.rest.positions[v].x == 0) continue;
    EXPECT_EQ(shade.srgb, after.rest.positions[v].x > 0 ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1)) << v;
    EXPECT_NEAR(shade.gloss, before.palette[before.shade[v]].gloss, 0.1);
  }
}

// How many pixels of a row are far from the one before.
int count_edges(const Pixels& pixels, int y, int from, int to) {
  constexpr int kFar = 40;
  const auto green = [&](int x) {
    return static_cast<int>(pixels.rgb[3 * static_cast<std::size_t>(y * pixels.size.width_px + x) + 1]);
  };
  int edges = 0;
  for (int x = from; x + 1 < to; ++x)
    if (std::abs(green(x + 1) - green(x)) > kFar) ++edges;
  return edges;
}

// A chequer of squares of 1 mm on the cheek, where the skin's points are 2.5 mm apart.
TEST(skin_texture, is_seen_as_sharp_as_it_was_painted) {
  const auto folder = make_folder("skin_texture_sharp");
  constexpr int kSide_px = 2048, kSquare_px = 4;
  Pixels pixels = make_pixels({kSide_px, kSide_px});
  for (std::size_t i = 0; i < std::size_t{kSide_px} * kSide_px; ++i)
    if ((i % kSide_px / kSquare_px + i / kSide_px / kSquare_px) % 2 == 0)
      for (std::size_t k = 0; k < 3; ++k) pixels.rgb[3 * i + k] = 255;
  write_file(folder / "skin.png", build_png(pixels));
  write_file(folder / "face.yaml", "mien: 1\nhead: {look: {texture: skin.png}}\n");
  const ProgramRun run =
      run_shell(folder, "mien still face.yaml -o face.png --quality draft --size 960x1200 --quiet");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_GT(count_edges(read_pixels(folder / "face.png"), 660, 230, 340), 40);
}

TEST(skin_texture, keeps_the_palette_small) {
  const auto folder = make_folder("skin_texture_noise");
  Pixels pixels = make_pixels({512, 512});
  for (std::size_t i = 0; i < pixels.rgb.size(); ++i)
    pixels.rgb[i] = static_cast<std::uint8_t>(i * 2654435761u >> 13);
  write_file(folder / "skin.png", build_png(pixels));
  HeadSpec head;
  head.look.texture = FileReference{folder / "skin.png", {}};
  EXPECT_LE(build_figure(shipped().heads, head).model.parts.front().palette.size(), 4096u);
}

TEST(skin_texture, tells_what_is_no_picture_where_it_is_named) {
  const auto folder = make_folder("skin_texture_wrong");
  write_file(folder / "skin.png", "no picture");
  write_file(folder / "face.yaml", "mien: 1\nhead: {look: {texture: skin.png}}\n");
  const ProgramRun run = run_shell(folder, "mien still face.yaml -o face.png");
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.err.find(
                "face.yaml:2:24: error: 'skin.png' is no picture (Not a PNG file); expected a PNG of at most "
                "8192x8192 pixels\n"),
            run.err.npos)
      << run.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "face.png"));
  write_file(folder / "face.yaml", "mien: 1\nhead: {look: {texture: none.png}}\n");
  EXPECT_EQ(run_shell(folder, "mien check face.yaml").status, 2);
}

}  // namespace
}  // namespace mien

#include "render/picture.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "render/process.hpp"
#include "render/scratch.hpp"

namespace mien {
namespace {

TEST(picture, says_what_is_wrong_with_a_picture) {
  const std::string png = build_picture(8, 6);
  EXPECT_EQ(find_picture_fault(png, {8, 6}), "");
  EXPECT_EQ(find_picture_fault(png, {6, 8}), "is 8x6 pixels, not 6x8");
  EXPECT_EQ(find_picture_fault(png, {8, 5}), "is 8x6 pixels, not 8x5");
  EXPECT_EQ(find_picture_fault(png, {9, 6}), "is 8x6 pixels, not 9x6");
  EXPECT_EQ(find_picture_fault(build_picture(8, 6, {10, 10, 10}, {10, 10, 10}), {8, 6}), "is all one colour");
  EXPECT_EQ(find_picture_fault(build_picture(8, 6, {10, 10, 10}, {10, 10, 11}), {8, 6}), "");
  EXPECT_EQ(find_picture_fault("", {8, 6}), "does not decode: the file is empty");
  EXPECT_EQ(find_picture_fault("P6 8 6 255", {8, 6}), "does not decode: it is not a PNG");
  EXPECT_EQ(find_picture_fault(png + "x", {8, 6}), "does not decode: something follows its end");
  std::string damaged = png;
  damaged[20] ^= 1;  // in the width
  EXPECT_EQ(find_picture_fault(damaged, {8, 6}), "does not decode: its bytes are damaged");
}

TEST(picture, takes_no_part_of_a_picture_for_a_whole_one) {
  const std::string png = build_picture(8, 6);
  for (std::size_t size = 8; size < png.size(); ++size)
    EXPECT_EQ(find_picture_fault(png.substr(0, size), {8, 6}), "does not decode: the file is cut short")
        << size;
}

TEST(picture, refuses_whole_chunks_without_enough_pixels) {
  // The header of a tall picture on the pixels of a low one: every checksum is right, yet rows are missing.
  const std::string tall = build_picture(8, 60), low = build_picture(8, 6);
  constexpr std::size_t kHeaderEnd = 8 + 25;
  const std::string mixed = tall.substr(0, kHeaderEnd) + low.substr(kHeaderEnd);
  EXPECT_TRUE(find_picture_fault(mixed, {8, 60}).starts_with("does not decode: "))
      << find_picture_fault(mixed, {8, 60});
}

TEST(picture, carries_its_key_and_no_date) {
  const Scratch scratch;
  const auto path = scratch.path / "a.png";
  write_file(path, mark_picture(mark_picture(build_picture(8, 6), "old"), "0123456789abcdef"));
  EXPECT_EQ(read_picture_key(path), "0123456789abcdef");
  const std::string marked = read_file(path);
  EXPECT_EQ(find_picture_fault(marked, {8, 6}), "");
  EXPECT_EQ(marked.find("old"), std::string::npos);
  EXPECT_EQ(mark_picture(marked, "0123456789abcdef"), marked);
  EXPECT_EQ(find_message<RunError>([] { mark_picture("", "k"); }),
            "cannot mark a picture: the file is empty");
}

TEST(picture, drops_dates_and_remarks_of_other_programs) {
  const Scratch scratch;
  write_file(scratch.path / "in.png", build_picture(8, 6));
  ASSERT_EQ(
      run_process({"convert", "in.png", "-set", "comment", "a remark", "out.png"}, scratch.path).exit_code,
      0);
  const std::string png = read_file(scratch.path / "out.png"), marked = mark_picture(png, "k");
  EXPECT_NE(png.find("tIME"), std::string::npos);
  EXPECT_NE(png.find("a remark"), std::string::npos);
  for (const char* left_out : {"tIME", "a remark", "date:create", "zTXt", "iTXt"})
    EXPECT_EQ(marked.find(left_out), std::string::npos) << left_out;
  EXPECT_NE(marked.find("gAMA"), std::string::npos);
}

TEST(picture, has_no_key_unless_it_is_whole) {
  const Scratch scratch;
  const auto path = scratch.path / "a.png";
  EXPECT_EQ(read_picture_key(path), "");
  EXPECT_EQ(read_picture_key(scratch.path), "");
  write_file(path, build_picture(8, 6));
  EXPECT_EQ(read_picture_key(path), "");
  const std::string marked = mark_picture(build_picture(8, 6), "k");
  write_file(path, marked.substr(0, marked.size() - 1));
  EXPECT_EQ(read_picture_key(path), "");
  EXPECT_EQ(find_message<RunError>([&] { read_picture_size(path); }),
            path.string() + " is not a whole PNG picture: the file is cut short");
  write_file(path, marked);
  EXPECT_EQ(read_picture_size(path).width_px, 8);
}

TEST(picture, has_no_key_unless_its_pixels_decode) {
  // As above: every chunk is whole, yet rows are missing.
  constexpr std::size_t kHeaderEnd = 8 + 25;
  const std::string mixed =
      build_picture(8, 60).substr(0, kHeaderEnd) + build_picture(8, 6).substr(kHeaderEnd);
  const Scratch scratch;
  write_file(scratch.path / "a.png", mark_picture(mixed, "k"));
  EXPECT_EQ(read_picture_key(scratch.path / "a.png"), "");
}

TEST(picture, is_pasted_into_a_page_that_reads_back) {
  Pixels page{{5, 4}, std::vector<std::uint8_t>(60, 200)};
  Pixels part{{2, 2}, {}};
  for (std::uint8_t i = 0; i < 12; ++i) part.rgb.push_back(i);
  paste_pixels(page, part, 3, 1);
  const Scratch scratch;
  write_file(scratch.path / "page.png", build_png(page));
  const Pixels read = read_pixels(scratch.path / "page.png");
  EXPECT_EQ(read.size.width_px, 5);
  EXPECT_EQ(read.size.height_px, 4);
  EXPECT_EQ(read.rgb, page.rgb);
  const auto at = [&](int x, int y) { return read.rgb[3 * (5 * y + x)]; };
  EXPECT_EQ(at(3, 1), 0);
  EXPECT_EQ(at(4, 1), 3);
  EXPECT_EQ(at(3, 2), 6);
  EXPECT_EQ(at(2, 1), 200);
  EXPECT_EQ(build_png(page), build_png(read));
  EXPECT_EQ(find_message<RunError>([&] { paste_pixels(page, part, 4, 0); }),
            "internal: a picture lies outside its page");
  EXPECT_THROW(paste_pixels(page, part, 0, -1), RunError);
  EXPECT_THROW(paste_pixels(page, part, -1, 0), RunError);
  EXPECT_THROW(paste_pixels(page, part, 0, 3), RunError);
}

TEST(picture, keeps_what_is_transparent) {
  Pixels clear = make_pixels({3, 2});
  clear.alpha = {0, 51, 255, 255, 128, 1};
  for (std::size_t i = 0; i < clear.rgb.size(); ++i) clear.rgb[i] = static_cast<std::uint8_t>(10 * i);
  const Scratch scratch;
  write_file(scratch.path / "clear.png", build_png(clear));
  write_file(scratch.path / "opaque.png", build_png(make_pixels({3, 2})));
  EXPECT_TRUE(has_alpha(scratch.path / "clear.png"));
  EXPECT_FALSE(has_alpha(scratch.path / "opaque.png"));
  const Pixels read = read_pixels(scratch.path / "clear.png");
  EXPECT_EQ(read.rgb, clear.rgb);
  EXPECT_EQ(read.alpha, clear.alpha);
  EXPECT_TRUE(read_pixels(scratch.path / "opaque.png").alpha.empty());

  Pixels page = make_pixels({4, 2});
  paste_pixels(page, clear, 1, 0);
  EXPECT_EQ(page.alpha, (std::vector<std::uint8_t>{255, 0, 51, 255, 255, 255, 128, 1}));
  paste_pixels(page, make_pixels({1, 2}), 1, 0);
  EXPECT_EQ(page.alpha, (std::vector<std::uint8_t>{255, 255, 51, 255, 255, 255, 128, 1}));
}

TEST(picture, is_covered_as_paint_covers) {
  Pixels opaque = make_pixels({1, 1});
  cover_pixel(opaque, 0, {200, 100, 50}, 0.5);
  EXPECT_EQ(opaque.rgb, (std::vector<std::uint8_t>{100, 50, 25}));
  EXPECT_TRUE(opaque.alpha.empty());
  Pixels clear = make_pixels({1, 1});
  clear.alpha = {0};
  cover_pixel(clear, 0, {200, 100, 50}, 0);
  EXPECT_EQ(clear.alpha[0], 0);
  cover_pixel(clear, 0, {200, 100, 50}, 0.4);
  EXPECT_EQ(clear.rgb, (std::vector<std::uint8_t>{200, 100, 50})) << "nothing of what could not be seen";
  EXPECT_EQ(clear.alpha[0], 102);
  cover_pixel(clear, 0, {0, 0, 0}, 1);
  EXPECT_EQ(clear.rgb, (std::vector<std::uint8_t>{0, 0, 0}));
  EXPECT_EQ(clear.alpha[0], 255);
}

}  // namespace
}  // namespace mien

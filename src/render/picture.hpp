// PNG pictures: judged, stripped of their date, marked with the key of what they show, joined into one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

struct PictureSize {
  int width_px = 0, height_px = 0;
};

// What is wrong with a PNG file's content as a rendered picture: "does not decode: ...", "is 16x12 pixels,
// not 32x24", "is all one colour". Empty if nothing is.
std::string find_picture_fault(std::string_view png, const PictureSize& expected);

// The same picture without date and remarks, so that the same pixels are the same bytes, and with `key` in a
// text chunk "mien-key". `png` must be whole (see find_picture_fault); throws RunError if it is not.
std::string mark_picture(std::string_view png, std::string_view key);

// The key inside a finished picture; empty if there is no picture, it does not decode or it has no key.
std::string read_picture_key(const std::filesystem::path& picture);

// Throws RunError "PATH is not a whole PNG picture: reason" if a chunk is missing, cut or damaged.
PictureSize read_picture_size(const std::filesystem::path& picture);

// A picture in memory: rows from the top, three bytes (red, green, blue; sRGB) a pixel.
struct Pixels {
  PictureSize size;
  std::vector<std::uint8_t> rgb;
  std::vector<std::uint8_t> alpha = {};  // a byte a pixel: 0 shows nothing of it; none: all is opaque
};

// All black, opaque.
Pixels make_pixels(const PictureSize& size);

// Throws RunError as read_picture_size does.
Pixels read_pixels(const std::filesystem::path& picture);

// Whether a PNG's pixels may be transparent: it says so in its header. Throws RunError as read_picture_size
// does.
bool has_alpha(const std::filesystem::path& picture);

// In the place of what `page` has there: `part` with its corner at `left_px`, `top_px`; throws RunError if it
// does not lie within it.
void paste_pixels(Pixels& page, const Pixels& part, int left_px, int top_px);

// Lays `srgb` over a pixel, `cover` of it (0..1).
void cover_pixel(Pixels& picture, std::size_t pixel, const std::array<std::uint8_t, 3>& srgb, double cover);

// Red, green, blue and alpha of each pixel; nothing of an opaque picture.
std::vector<std::uint8_t> join_bytes(const Pixels& pixels);

// A PNG file's content without date or remarks: the same pixels are the same bytes.
std::string build_png(const Pixels& pixels);

}  // namespace mien

// Words drawn on a finished picture, in letters of one stroke's width.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "print/glyphs.hpp"
#include "render/picture.hpp"

namespace mien {

// One line: where it stands and how.
struct WrittenLine {
  std::string words;
  double left_px = 0, base_px = 0;  // of the first letter's lower left corner, from the picture's upper left
  double capital_px = 10;           // height of a capital
  double width_px = 0;              // more is left out, and a smaller letter tried before
  double align = 0;                 // in its width: 0 left, 0.5 in the middle, 1 right
  std::array<std::uint8_t, 3> srgb{255, 255, 255};
};

// Its edges are smooth; what lies outside the picture is left out.
void write_line(Pixels& picture, const WrittenLine& line, const Letters& letters);

// A plain rectangle over the picture, `cover` of it.
void cover_box(Pixels& picture, int left_px, int top_px, const PictureSize& size,
               const std::array<std::uint8_t, 3>& srgb, double cover);

}  // namespace mien

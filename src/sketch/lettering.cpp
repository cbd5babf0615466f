#include "sketch/lettering.hpp"

#include <algorithm>
#include <cmath>

namespace mien {

void write_line(Pixels& picture, const WrittenLine& line, const Letters& letters) {
  constexpr double kSmallest = 0.7;  // of what is asked for
  constexpr double kPen = 0.15;      // of a capital
  const Label label =
      set_label(letters, line.words, line.capital_px, kSmallest * line.capital_px, line.width_px);
  if (label.strokes.empty()) return;
  const double half_px = std::max(0.5, kPen * label.size_mm / 2);
  const double middle_px = line.left_px + label.width_mm / 2 + line.align * (line.width_px - label.width_mm);
  const auto floor_px = [](double px) { return static_cast<int>(std::floor(px)); };
  const int left = std::max(0, floor_px(middle_px - label.width_mm / 2 - half_px)),
            right = std::min(picture.size.width_px, floor_px(middle_px + label.width_mm / 2 + half_px) + 2),
            top = std::max(0, floor_px(line.base_px - 1.5 * label.size_mm)),
            bottom = std::min(picture.size.height_px, floor_px(line.base_px + 0.5 * label.size_mm) + 2);
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x) {
      const double off_px =
          compute_stroke_distance(label.strokes, {x + 0.5 - middle_px, line.base_px - (y + 0.5)});
      const double cover = std::clamp(half_px + 0.5 - off_px, 0.0, 1.0);
      if (cover > 0)
        cover_pixel(picture,
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.size.width_px) +
                        static_cast<std::size_t>(x),
                    line.srgb, cover);
    }
}

void cover_box(Pixels& picture, int left_px, int top_px, const PictureSize& size,
               const std::array<std::uint8_t, 3>& srgb, double cover) {
  const int right = std::min(left_px + size.width_px, picture.size.width_px),
            bottom = std::min(top_px + size.height_px, picture.size.height_px);
  for (int y = std::max(top_px, 0); y < bottom; ++y)
    for (int x = std::max(left_px, 0); x < right; ++x)
      cover_pixel(picture,
                  static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.size.width_px) +
                      static_cast<std::size_t>(x),
                  srgb, cover);
}

}  // namespace mien

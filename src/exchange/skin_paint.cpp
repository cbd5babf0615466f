// Triangles by their barycentric coordinates at the pixels' middles: J. Pineda, "A Parallel Algorithm for
// Polygon Rasterization", SIGGRAPH 1988.
#include "exchange/skin_paint.hpp"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

struct Canvas {
  Pixels pixels;
  std::vector<bool> is_covered;
  int size_px;
};

const glm::vec3& find_colour(const Part& part, std::uint32_t vertex) {
  return part.palette.at(part.shade.empty() ? 0 : part.shade[vertex]).srgb;
}

void set_pixel(Canvas& canvas, int x, int y, const glm::vec3& srgb) {
  const std::size_t at = static_cast<std::size_t>(y) * canvas.size_px + x;
  canvas.is_covered[at] = true;
  for (int k = 0; k < 3; ++k)
    canvas.pixels.rgb[3 * at + k] =
        static_cast<std::uint8_t>(std::lround(255 * std::clamp(srgb[k], 0.0f, 1.0f)));
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

void fill_triangle(Canvas& canvas, const std::array<glm::dvec2, 3>& corners,
                   const std::array<glm::vec3, 3>& colours) {
  const double area = cross(corners[1] - corners[0], corners[2] - corners[0]);
  if (area == 0) return;
  const glm::dvec2 low = glm::min(glm::min(corners[0], corners[1]), corners[2]);
  const glm::dvec2 high = glm::max(glm::max(corners[0], corners[1]), corners[2]);
  const int last = canvas.size_px - 1;
  for (int y = std::max(0, static_cast<int>(low.y)); y <= std::min(last, static_cast<int>(high.y)); ++y)
    for (int x = std::max(0, static_cast<int>(low.x)); x <= std::min(last, static_cast<int>(high.x)); ++x) {
      const glm::dvec2 at(x + 0.5, y + 0.5);
      glm::vec3 colour(0);
      bool is_inside = true;
      for (int k = 0; k < 3; ++k) {
        const double share =
            cross(corners[(k + 2) % 3] - corners[(k + 1) % 3], at - corners[(k + 1) % 3]) / area;
        is_inside &= share >= -1e-9;
        colour += static_cast<float>(share) * colours[k];
      }
      if (is_inside) set_pixel(canvas, x, y, colour);
    }
}

glm::dvec2 place_on(const Canvas& canvas, const glm::vec2& place) {
  return glm::dvec2(place.x, 1 - place.y) * double(canvas.size_px);
}

// From the left, then from the right.
void fill_gaps(Canvas& canvas) {
  const int size = canvas.size_px;
  for (int y = 0; y < size; ++y)
    for (const int step : {1, -1})
      for (int x = step > 0 ? 1 : size - 2; x >= 0 && x < size; x += step) {
        const std::size_t at = static_cast<std::size_t>(y) * size + x;
        if (canvas.is_covered[at] || !canvas.is_covered[at - step]) continue;
        canvas.is_covered[at] = true;
        std::copy_n(&canvas.pixels.rgb[3 * (at - step)], 3, &canvas.pixels.rgb[3 * at]);
      }
}

void draw_line(Canvas& canvas, const glm::dvec2& from, const glm::dvec2& to) {
  constexpr std::array<std::uint8_t, 3> kInk{60, 50, 60};
  constexpr double kCover = 0.45;
  const int steps = std::max(1, static_cast<int>(std::ceil(glm::distance(from, to))));
  for (int i = 0; i < steps; ++i) {
    const glm::dvec2 at = glm::mix(from, to, (i + 0.5) / steps);
    const int x = static_cast<int>(at.x), y = static_cast<int>(at.y);
    if (x < 0 || y < 0 || x >= canvas.size_px || y >= canvas.size_px) continue;
    cover_pixel(canvas.pixels, static_cast<std::size_t>(y) * canvas.size_px + x, kInk, kCover);
  }
}

Canvas bake(const Part& part, const Atlas& atlas, int size_px) {
  const std::size_t count = static_cast<std::size_t>(size_px) * size_px;
  Canvas canvas{make_pixels({size_px, size_px}), std::vector<bool>(count, false), size_px};
  for (const Triangle& triangle : atlas.triangles) {
    std::array<glm::dvec2, 3> corners;
    std::array<glm::vec3, 3> colours;
    for (int k = 0; k < 3; ++k) {
      corners[k] = place_on(canvas, atlas.places[triangle[k]]);
      colours[k] = find_colour(part, atlas.vertices[triangle[k]]);
    }
    fill_triangle(canvas, corners, colours);
  }
  return canvas;
}

}  // namespace

Pixels bake_colours(const Part& part, const Atlas& atlas, int size_px) {
  Canvas canvas = bake(part, atlas, size_px);
  fill_gaps(canvas);
  return std::move(canvas.pixels);
}

Pixels draw_layout(const Part& part, const Atlas& atlas, int size_px) {
  Canvas canvas = bake(part, atlas, size_px);
  for (std::size_t i = 0; i < canvas.is_covered.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      std::uint8_t& channel = canvas.pixels.rgb[3 * i + k];
      channel = canvas.is_covered[i] ? static_cast<std::uint8_t>(128 + channel / 2) : 255;
    }
  for (const Triangle& triangle : atlas.triangles)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3];
      if (atlas.vertices[a] > atlas.vertices[b]) continue;  // its neighbour draws it
      draw_line(canvas, place_on(canvas, atlas.places[a]), place_on(canvas, atlas.places[b]));
    }
  return std::move(canvas.pixels);
}

}  // namespace mien

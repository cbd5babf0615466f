// A line drawing on paper: strokes of a pen and words, which SVG and PNG are made of alike.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "print/glyphs.hpp"
#include "render/picture.hpp"
#include "scene/plate.hpp"
#include "wire/seen.hpp"

namespace mien {

struct PaperStroke {
  std::vector<glm::dvec2> points_px;  // from the paper's upper left corner, at least two; ends are round
  double width_px = 1;
  std::array<std::uint8_t, 3> srgb{38, 34, 31};
};

struct PaperWords {
  std::string words;
  glm::dvec2 at_px{0};     // of the line they stand on
  double capital_px = 12;  // how high a capital is
  double align = 0;        // 0: `at_px` is their left end, 0.5: their middle, 1: their right end
  double room_px = 1e4;    // wider words are made smaller
  std::array<std::uint8_t, 3> srgb{38, 34, 31};
  bool is_serif = false;
};

// Strokes lie over those before them, words over all.
struct Paper {
  PictureSize size;
  std::array<std::uint8_t, 3> srgb{243, 240, 233};  // as templates/povray/plate.pov
  std::string title;
  std::vector<PaperStroke> strokes;
  std::vector<PaperWords> words;
};

struct PenLook {
  double width = 0.001;  // of the picture's height
  std::array<std::uint8_t, 3> srgb{38, 34, 31};
};
using PenLooks = std::array<PenLook, kPenCount>;

// Thin lines of the net, strong outlines; guide lines and limits in the pencils that other sheets have.
PenLooks get_pen_looks();

// The model as the camera sees it, with its upper left corner at `corner_px` of the paper and nothing of it
// beside the camera's picture. Pens that come later in the list lie over the earlier ones. The same whatever
// the number of `jobs`.
void draw_wire(const WireModel& model, const WireCamera& camera, const PenLooks& looks,
               const glm::dvec2& corner_px, int jobs, Paper& paper);

// All lines that draw_wire looks at: the model's own and the edges of its solids.
std::vector<WireLine> list_wire_lines(const WireModel& model, const WireCamera& camera);

// A gap in a line that is shorter may be missed: it would hardly be seen.
inline constexpr double kWireStep_px = 1.2;

// A page's words, rules and lines, and its size; its ink and paper are those of other sheets.
void append_plate(const Plate& plate, Paper& paper);

// As text; numbers to a hundredth of a pixel.
std::string build_paper_svg(const Paper& paper);

// Strokes over a picture; edges are smooth, and a line thinner than a pixel is paler instead.
void draw_strokes(const std::vector<PaperStroke>& strokes, Pixels& picture);

// All of the paper as pixels.
Pixels build_paper_pixels(const Paper& paper, const Letters& letters);

}  // namespace mien

// Letters for labels, drawn with one round pen, so that no font is needed and nothing is thinner than a
// nozzle.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/mesh.hpp"
#include "core/templates.hpp"

namespace mien {

using Stroke = std::vector<glm::dvec2>;  // one point twice is a dot

struct Glyph {
  double width = 0;             // of the middle of its lines; the capitals are kCapital high
  std::vector<Stroke> strokes;  // from (0, 0), y up
};

struct Letters {
  std::map<char32_t, Glyph> glyphs;  // capitals, digits, blank and signs
  Glyph box;                         // for all others
};

// From templates/openscad/letters.csv. Throws RunError "PATH:LINE: not a letter".
Letters build_letters(const Template& table);
Letters find_letters(const Templates& templates);

// One line of text, set.
struct Label {
  std::string text;  // what is set of it; control characters are blanks
  bool is_cut = false;
  double size_mm = 0;  // height of a capital with the pen's width
  double pen_mm = 0;
  double width_mm = 0;
  std::vector<Stroke> strokes;  // mm, middle lines; x from the middle of the text, y from its bottom
};

// The pen for letters of this size: never thinner than kLeastPen_mm.
double compute_pen_mm(double size_mm);

// `text` in letters of `size_mm`, smaller ones down to `least_mm` if it is wider than `width_mm`; cut if it
// still is. No strokes if nothing fits. Any bytes may be in `text`: what is no UTF-8 is set as boxes.
Label set_label(const Letters& letters, const std::string& text, double size_mm, double least_mm,
                double width_mm);

// The distance from `p` to the middle line of the nearest stroke; 1e9 without any.
double compute_stroke_distance(const std::vector<Stroke>& strokes, const glm::dvec2& p);

// The strokes as a list of lists of points, in OpenSCAD's words.
std::string build_openscad_strokes(const std::vector<Stroke>& strokes);

// All letters as "letters = [["A", 4, [[[0, 0], ...], ...]], ...];", the box as the last one, named "".
std::string build_openscad_letters(const Letters& letters);

}  // namespace mien

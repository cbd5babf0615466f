// A sheet's page as a POV-Ray scene: paper, rules, lines and words, to which pictures are added afterwards.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/templates.hpp"

namespace mien {

// Words on one line. Pixels count from the page's upper left corner.
struct PlateWords {
  std::string words;
  double x_px = 0, y_px = 0;  // of the line they stand on; x as `align` says
  double size_px = 16;        // of a letter with all that it may reach up and down
  double align = 0;           // 0: x is their left end, 0.5: their middle, 1: their right end
  double room_px = 1e4;       // wider words are made smaller until they fit
  double strength = 1;        // 1 black, 0 as pale as the paper
  bool is_serif = true;
};

struct PlateRule {
  double x_px = 0, y_px = 0;  // left end, upper edge
  double width_px = 0, thickness_px = 1;
  double strength = 1;
};

// A stroke of the pen, round at its ends. With a tip it is an arrow.
struct PlateLine {
  double x_px = 0, y_px = 0, to_x_px = 0, to_y_px = 0;
  double thickness_px = 1;
  double strength = 1;
  bool has_tip = false;
};

struct Plate {
  int width_px = 0, height_px = 0;
  std::vector<PlateWords> words;
  std::vector<PlateRule> rules;
  std::vector<PlateLine> lines;
};

// The page's scene by `templates_folder`/povray/plate.pov.
std::string build_plate_scene(const Plate& plate, const Templates& templates);

// UTF-8 as the letters that POV-Ray's own fonts have: ASCII. Latin letters lose their marks, typographic
// quotes and dashes become plain, the rest is left out.
std::string simplify_letters(std::string_view utf8);

// `words` as a string of POV-Ray's language, quotes included: nothing in them can end it.
std::string quote_povray(std::string_view words);

}  // namespace mien

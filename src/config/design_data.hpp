// templates/head/designs/*.yaml as values: what a design makes of any head, and of how it moves.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "config/findings.hpp"
#include "config/head_spec.hpp"
#include "core/staging.hpp"

namespace mien {

// The dials of a design, all of which change nothing as they stand here: those of the real head. Lengths are
// an adult's, in mm; on another head they are as much longer or shorter as its eyeball.
struct DesignNumbers {
  // The form of the head.
  double eye_size = 1;     // of the ball with its lids
  double eye_opening = 1;  // how much further the lids are open, along the ball
  double eye_out = 0, eye_up = 0, eye_back = 0;
  double cranium_height = 1, cranium_width = 1, cranium_depth = 1;
  double face_height = 1;  // from the base of the nose to the chin
  double chin_width = 1, chin_forward = 0, cheeks = 0, neck_width = 1;
  double nose_width = 1, nose_up = 0, nose_forward = 0;  // of the wings; of the tip
  double lip_height = 1, lip_fullness = 1;
  double calm = 0;        // how far hollows and swellings between the features are smoothed away
  double difference = 1;  // what the head differs in from the average one of its age
  // The posed head: space is stretched about each eye, so that the ball becomes an oval and the lids still
  // fit.
  double lens_height = 1;                   // how much taller the eye is
  double lens_full = 1.05, lens_end = 3.3;  // until where it is all of that, and where it has died out: radii
  double lens_flat = 0;                     // how much of what stands forth of the ball is taken away
  double brow_rise_gain = 1, brow_gain = 1, corner_gain = 1,
         lips_gain = 1;  // how far areas go, times a real head's; brows up and else
  double early = 0;      // how much more clearly a face tells: brows, lids and corners half way; disgust
  double lid_hood = 0;   // how far towards shut a brow that is low and angry takes the upper lid along
  double jaw_stretch = 0, brow_stretch = 0;  // of the head's height when the jaw is open, the brows are up
  double folds = 1;                          // of the skin
  // Eyes as ink draws them: angles at the centre of the ball.
  double iris_deg = 28.5, pupil_deg = 9;
  double blush = 0;  // of the cheeks
};

// A dial as a file names it.
struct DesignDial {
  std::string_view section, name;
  double DesignNumbers::*number;
  double low, high;
};

inline constexpr std::array kDesignDials{
    DesignDial{"eyes", "size", &DesignNumbers::eye_size, 0.6, 2},
    DesignDial{"eyes", "opening", &DesignNumbers::eye_opening, 0.6, 2.2},
    DesignDial{"eyes", "out", &DesignNumbers::eye_out, -5, 12},
    DesignDial{"eyes", "up", &DesignNumbers::eye_up, -15, 15},
    DesignDial{"eyes", "back", &DesignNumbers::eye_back, -5, 15},
    DesignDial{"cranium", "height", &DesignNumbers::cranium_height, 0.8, 1.5},
    DesignDial{"cranium", "width", &DesignNumbers::cranium_width, 0.8, 1.5},
    DesignDial{"cranium", "depth", &DesignNumbers::cranium_depth, 0.8, 1.5},
    DesignDial{"face", "height", &DesignNumbers::face_height, 0.5, 1.3},
    DesignDial{"face", "chin", &DesignNumbers::chin_width, 0.5, 1.3},
    DesignDial{"face", "forward", &DesignNumbers::chin_forward, -8, 12},
    DesignDial{"face", "cheeks", &DesignNumbers::cheeks, -5, 12},
    DesignDial{"face", "neck", &DesignNumbers::neck_width, 0.5, 1.3},
    DesignDial{"nose", "width", &DesignNumbers::nose_width, 0.4, 1.6},
    DesignDial{"nose", "up", &DesignNumbers::nose_up, -10, 12},
    DesignDial{"nose", "forward", &DesignNumbers::nose_forward, -12, 12},
    DesignDial{"lips", "height", &DesignNumbers::lip_height, 0.3, 1.3},
    DesignDial{"lips", "fullness", &DesignNumbers::lip_fullness, 0.3, 1.3},
    DesignDial{"skin", "calm", &DesignNumbers::calm, 0, 1},
    DesignDial{"head", "difference", &DesignNumbers::difference, 0, 3},
    DesignDial{"lens", "height", &DesignNumbers::lens_height, 1, 1.8},
    DesignDial{"lens", "full", &DesignNumbers::lens_full, 0.9, 1.5},
    DesignDial{"lens", "end", &DesignNumbers::lens_end, 2.4, 4},
    DesignDial{"lens", "flat", &DesignNumbers::lens_flat, 0, 0.5},
    DesignDial{"moves", "brow_rise", &DesignNumbers::brow_rise_gain, 0.3, 3},
    DesignDial{"moves", "brow", &DesignNumbers::brow_gain, 0.3, 4},
    DesignDial{"moves", "corner", &DesignNumbers::corner_gain, 0.3, 2},
    DesignDial{"moves", "lips", &DesignNumbers::lips_gain, 0.3, 2},
    DesignDial{"moves", "early", &DesignNumbers::early, 0, 0.8},
    DesignDial{"moves", "lid_hood", &DesignNumbers::lid_hood, 0, 0.6},
    DesignDial{"moves", "jaw_stretch", &DesignNumbers::jaw_stretch, 0, 0.1},
    DesignDial{"moves", "brow_stretch", &DesignNumbers::brow_stretch, 0, 0.1},
    DesignDial{"skin", "folds", &DesignNumbers::folds, 0, 1.5},
    DesignDial{"ink", "iris", &DesignNumbers::iris_deg, 15, 45},
    DesignDial{"ink", "pupil", &DesignNumbers::pupil_deg, 4, 30},
    DesignDial{"ink", "blush", &DesignNumbers::blush, 0, 1}};

struct Design {
  std::string name, meaning;
  Style style = Style::studio;                // how it is drawn where a file says nothing of it
  std::map<std::string, DesignNumbers> ages;  // of each age that has its own, and of the others under ""
};

inline const std::string kReal = "real";  // the design that changes nothing and has no file

// Every design of `folder` (templates/head/designs), one a file, by name. Mistakes are added to the findings.
std::vector<Design> load_designs(const std::filesystem::path& folder, Findings& findings);

// The dials of a mix of designs on a mix of ages: each dial is the mean of theirs. No ages: an adult's.
// Throws RunError for a design that is not there.
DesignNumbers mix_designs(const std::vector<Design>& designs, const Mix& mix, const Mix& ages);

}  // namespace mien

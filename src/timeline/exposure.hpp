// The exposure sheet (the animator's dope sheet): which drawing each frame shows, and what moved.
#pragma once

#include <string>
#include <vector>

#include "timeline/performance.hpp"

namespace mien {

struct ExposureLine {
  int frame = 1;  // from 1
  double time_s = 0;
  int drawing = 1;  // from 1, in the order of their first frames; a drawing that comes back keeps its number
  bool is_held = false;              // shows the drawing of the frame before
  std::string key;                   // the label of a key whose moment this frame is the first to show
  std::vector<std::string> changed;  // "brows", "lips", "head", "camera": against the frame before
  std::string sound = {};            // what is said from this frame on, in IPA; empty: what was said before
};

// The first frame (from 0) whose drawing shows `time_s` or a later moment; the last one if none does.
int compute_key_frame(const ClipSpec& clip, double time_s);

std::vector<ExposureLine> build_exposure(const Performance& performance);

// RFC 4180 with a line of names first; changed areas with blanks between. A clip that speaks has a column of
// sounds.
std::string build_exposure_csv(const std::vector<ExposureLine>& lines);

}  // namespace mien

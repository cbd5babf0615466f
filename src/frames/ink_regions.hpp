// The regions of a skin that is drawn in ink: flat colours with crisp borders, which the skin's triangles are
// cut along.
#pragma once

#include <vector>

#include "core/staging.hpp"
#include "frames/figure.hpp"

namespace mien {

// A vertex between two others, on the border of a region.
struct CutVertex {
  std::uint32_t from = 0, to = 0;
  float share = 0;  // of the way
};

struct InkRegions {
  std::vector<CutVertex> cuts;       // behind the skin's own vertices; each between two before it
  std::vector<Triangle> triangles;   // of the cut skin
  std::vector<std::uint16_t> shade;  // of each of them, an index into `palette`
  std::vector<Shade> palette;
  std::vector<bool> is_opening;  // of the skin's own vertices: in the mouth, in a nostril or at its rim
  // Of them: how far it lies farther back, for the blush to be seen, 0..1: from the side, and from below.
  std::vector<float> cheek, lower_cheek;
  // And where in the blush they lie: outward and up from its middle, mm, and how far they keep that place in
  // profile, 0..1.
  std::vector<glm::vec3> flush_places;
  float flush = 0;  // how red a blush is, 0..1
};

// Mouth, nostrils, lips, beard, scalp and blush of a figure of FigureUse::ink, whose skin at rest lies at
// `positions`. `spec` tells hair, beard and colours, these as they are at its age.
InkRegions cut_regions(const Figure& figure, const HeadSpec& spec, const InkColours& colours,
                       const std::vector<glm::vec3>& positions);

}  // namespace mien

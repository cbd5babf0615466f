// A cut of hair: tapered locks over a dark mass, single hairs along its border, and a scalp painted under
// them.
#pragma once

#include <string>
#include <vector>

#include "head/head.hpp"

namespace mien {

// The parts of a cut, bound to the skin (Mount::strands): "hair_mass" (closed, and the only one that throws
// shadows; none where hair is too short), "hair" and "hair_back" (the locks before and behind the middle of
// them all) and "hair_fine" (single hairs). Nothing for "none". Mirror images of each other on both halves
// where the cut says so. Hair that is drawn has the locks that its cut has in ink, and no "hair_fine". Throws
// RunError for an unknown cut.
std::vector<HeadPart> build_hair(const NeutralHead& head, const std::string& cut, const Look& look,
                                 bool is_drawn);

// The parts of build_hair that are not drawn, and what paint_scalp gives, of one chart: half the time of
// both.
struct WornHair {
  std::vector<HeadPart> parts;
  std::vector<float> scalp;
};
WornHair build_worn_hair(const NeutralHead& head, const std::string& cut, const Look& look);

// A cut with the locks that it has where it is drawn. Throws RunError for an unknown cut.
HairCut find_drawn_cut(const NeutralHead& head, const std::string& name);

// How much of the scalp's colour hair hides, 0..1 a vertex of the skin; empty for "none".
std::vector<float> paint_scalp(const NeutralHead& head, const std::string& cut);

}  // namespace mien

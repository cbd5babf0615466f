// Beards: short hairs that grow where beards grow, thin out at its borders, and ride on the skin.
#pragma once

#include <string>
#include <vector>

#include "head/head.hpp"

namespace mien {

// How dense the beard is, 0..1 a vertex of the skin; mirror images have the same. Empty for "none". None on a
// child.
std::vector<float> paint_beard(const NeutralHead& head, const std::string& beard);

// How much of that the painted skin shows.
double compute_beard_paint(const NeutralHead& head, const std::string& beard);

// The part "beard"; nothing for "none" and for a child. Exact mirror images. Throws RunError for an unknown
// beard.
std::vector<HeadPart> build_beard(const NeutralHead& head, const Look& look);

// Of the hair's and the brows' colour.
glm::vec3 compute_beard_colour(const Look& look);

}  // namespace mien

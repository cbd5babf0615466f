// Beards: short hairs that grow where beards grow, thin out at its borders, and ride on the skin.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "head/head.hpp"

namespace mien {

// Part of a beard: how dense it is at named points of the cage's left half (0..1; nothing at all others), and
// which way its hairs lie: outward from the middle, up, forward.
struct BeardArea {
  std::map<std::string, double> density;
  glm::dvec3 way{0, -1, 0};
};

// templates/head/hair.yaml says what each means.
struct Beard {
  std::map<std::string, double> shares;  // of each area
  int count = 0;
  double length_mm = 1, radius_mm = 0.05, stand = 0.5, paint = 0.4;
};

struct BeardStock {
  std::map<std::string, BeardArea> areas;
  std::map<std::string, Beard> beards;
};

// Throws RunError naming the file for what it does not understand.
BeardStock load_beards(const std::filesystem::path& file);

// How dense the beard is, 0..1 a vertex of the skin; mirror images have the same. Empty for "none". None on a
// child.
std::vector<float> paint_beard(const NeutralHead& head, const std::string& beard);

// How much of that the painted skin shows.
double find_beard_paint(const std::string& beard);

// The part "beard"; nothing for "none" and for a child. Exact mirror images. Throws RunError for an unknown
// beard.
std::vector<HeadPart> build_beard(const NeutralHead& head, const Look& look);

// Of the hair's and the brows' colour.
glm::vec3 find_beard_colour(const Look& look);

}  // namespace mien

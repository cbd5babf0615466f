// How far a pose takes the skin, region by region: what doctrines are held against each other by.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "frames/figure.hpp"

namespace mien {

inline constexpr std::array<std::string_view, 5> kSkinRegions{"brows", "eyes", "nose and cheeks", "mouth",
                                                              "jaw"};

// The ways of the skin's points at the cage's points, from rest, without a turn of the head, mm.
struct SkinMotion {
  std::vector<glm::vec3> ways_mm;                     // of each point of the cage
  std::array<double, kSkinRegions.size()> mean_mm{};  // of each region's points
};

SkinMotion measure_motion(const Figure& figure, const Pose& pose);

// How alike two motions are, in directions and proportions over the whole face: the cosine between them, 1
// for the same. 0 where one rests.
double compute_likeness(const SkinMotion& a, const SkinMotion& b);

}  // namespace mien

// How far two faces are from each other, point by point: all skins have the same points, and all heads stand
// in one frame (core/conventions.hpp), so nothing is aligned.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/mesh.hpp"

namespace mien {

struct SkinDistances {
  std::vector<float> mm;  // of each vertex
  double mean_mm = 0;     // each vertex weighs as much as the skin around it on the first
  double most_mm = 0;
  std::uint32_t most = 0;  // the vertex there
};

// `other` has a position for each vertex of `skin`, which may have more of its own.
SkinDistances measure_distances(const Mesh& skin, const std::vector<glm::vec3>& other);

// The least of 1, 2 and 5 times a power of ten that is no less: where a scale ends. Of 0 it is 1.
double find_scale_end(double most);

struct LandmarkDistance {
  std::string name;
  glm::dvec3 way_mm{0};  // from the first to the second
  double mm = 0;
};

// Of those landmarks that both have, by name.
std::vector<LandmarkDistance> measure_landmark_distances(const std::map<std::string, glm::dvec3>& first,
                                                         const std::map<std::string, glm::dvec3>& second);

// A colour of the scale, srgb 0..1: from paper through yellow and red to a dark violet, darker all the way,
// so that it reads without colours too.
glm::vec3 find_heat(double share);

}  // namespace mien

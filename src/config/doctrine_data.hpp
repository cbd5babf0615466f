// templates/head/muscles.yaml and candide.yaml as values: what muscles and units do to the adult skin.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "config/area_data.hpp"
#include "config/areas.hpp"

namespace mien {

enum class LipsOf { both, upper, lower };

// A muscle from the bone to the skin, on the left or in the middle. Points of the cage's left half; mm on the
// adult.
struct LinearMuscle {
  std::size_t channel = 0;  // in kChannels, the left one's
  std::string from, to;
  glm::dvec3 off_mm{0};            // of the attachment from the skin at `from`
  double half_deg = 45;            // of the cone of influence
  double start = 0.85, end = 1.5;  // shares of the length: where the pull is greatest, and where it ends
  double most_mm = 0;
  LipsOf lips = LipsOf::both;
};

// A sphincter: an ellipse across and up.
struct RingMuscle {
  std::size_t channel = 0;
  std::vector<std::string> around;  // its middle lies between these; "eye": the eye's own
  glm::dvec2 half_mm{1}, pull{0};
  double deep_mm = 0, forward_mm = 0;
};

// Displacements of points, each as a share of a face unit.
struct PointUnit {
  std::size_t channel = 0;
  std::array<std::string, 3> units;
  Handles points;
  PointPatterns still;
};

// A channel that moves an area, by how much at 1.
struct ChannelToMove {
  std::size_t channel = 0, move = 0;  // in kChannels and in kMoves
  double value = 0;
};

struct DoctrineData {
  std::vector<LinearMuscle> linear;
  std::vector<RingMuscle> rings;
  std::map<std::string, double> rows;  // ring of eye or mouth -> what it keeps of a muscle's pull
  PointPatterns zero;                  // points that no muscle pulls
  std::vector<PointUnit> units;
  std::vector<ChannelToMove> moves, folds;
};

// Reads both files of `folder`; what does not fit, and names that `points` has not, is added to the findings.
DoctrineData load_doctrine_data(const std::filesystem::path& folder, const PointNames& points,
                                Findings& findings);

// The pose with what muscles and units do by moves of the areas. Without either it is the same to the last
// bit.
Pose resolve_channels(const DoctrineData& data, const Pose& pose);

// What folds the skin: the same moves, and those that muscles and units are like.
Pose resolve_folds(const DoctrineData& data, const Pose& resolved);

}  // namespace mien

// Named places on the head, after Farkas: templates/head/landmarks.yaml as plain values.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "config/point_names.hpp"

namespace mien {

// One way to find a place on the left half of the skin.
struct LandmarkRule {
  enum class Kind { points, extreme, hairline, pupil, tongue };
  Kind kind = Kind::points;
  std::vector<std::string> points;  // points: the mean of these
  std::string rule, pattern;        // extreme: "highest" of the points "er*"; "*" is any vertex of the skin
};

struct LandmarkData {
  std::vector<std::pair<std::string, LandmarkRule>> middle, sided;  // by Farkas' codes, in the file's order
  // Everyday words for them: a code of the above, or a point.
  std::vector<std::pair<std::string, std::string>> everyday_middle, everyday_sided;
  std::vector<std::string> needed;  // the codes that a scan must have
};

// Reads templates/head/landmarks.yaml; what does not fit, and names that `points` has not, is added to the
// findings.
LandmarkData load_landmark_data(const std::filesystem::path& file, const PointNames& points,
                                Findings& findings);

// The rule of a code; null if there is none such.
const LandmarkRule* find_landmark_rule(const LandmarkData& data, const std::string& code);

}  // namespace mien

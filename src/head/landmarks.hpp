// Named places on the head, after Farkas: templates/head/landmarks.yaml found on one head.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/model.hpp"
#include "head/head.hpp"

namespace mien {

// A landmark is the mean of some vertices of the skin, or a point fixed to an eyeball.
struct Landmark {
  std::string name;                     // "prn", "ch_l", ...
  std::vector<std::uint32_t> vertices;  // of the skin
  bool is_pupil = false;
  Side side = Side::none;  // of a pupil: whose
};

// In the file's order, each sided one as NAME_l, NAME_r. Throws RunError for a broken file.
std::vector<Landmark> find_landmarks(const NeutralHead& head, const std::filesystem::path& file);

// Where the landmarks are in a drawing of `model`, mm. A pupil is the front of the cornea, which the part
// "eye_left" or "eye_right" of the model carries.
std::map<std::string, glm::dvec3> measure_landmarks(const NeutralHead& head,
                                                    const std::vector<Landmark>& landmarks,
                                                    const Model& model, const Drawing& drawing);

// {"al_l": [16.4, -40.1, 103.2], ...}: by name, millimetres to 0.001.
std::string build_landmarks_json(const std::map<std::string, glm::dvec3>& landmarks);

}  // namespace mien

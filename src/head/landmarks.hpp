// Named places, found on one head.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/model.hpp"
#include "head/head.hpp"

namespace mien {

// A landmark is a weighted mean of some vertices of the skin, a point fixed to an eyeball, or the tongue's
// tip.
struct Landmark {
  std::string name;                     // "prn", "ch_l", ...
  std::vector<std::uint32_t> vertices;  // of the skin
  std::vector<double> shares;           // of each vertex, summing to 1
  bool is_pupil = false;
  Side side = Side::none;  // of a pupil: whose
  bool is_tongue = false;

  bool is_skin() const { return !is_pupil && !is_tongue; }
};

// In the data's order, each sided one as NAME_l, NAME_r.
std::vector<Landmark> find_landmarks(const NeutralHead& head);

// A place on the left half of the skin: the weighted mean of some vertices.
struct SkinSpot {
  std::vector<std::uint32_t> vertices;
  std::vector<double> shares;
  bool is_extreme = false;  // found by a rule, such as the highest point: less sharp than a named one
};

// A landmark without its _l or _r, or an everyday word. Throws RunError for a name that the data do not have,
// and for pupils and the tongue, which are no skin.
SkinSpot find_place(const NeutralHead& head, const std::string& name);

// Where the landmarks are in a drawing of `model`, mm. A pupil is the front of the cornea, which the part
// "eye_left" or "eye_right" of the model carries; the tongue's tip is the last vertex of "tongue".
std::map<std::string, glm::dvec3> measure_landmarks(const NeutralHead& head,
                                                    const std::vector<Landmark>& landmarks,
                                                    const Model& model, const Drawing& drawing);

// {"al_l": [16.4, -40.1, 103.2], ...}: by name, millimetres to 0.001.
std::string build_landmarks_json(const std::map<std::string, glm::dvec3>& landmarks);

}  // namespace mien

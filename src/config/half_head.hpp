// The half head as data: the control points of one half, the skin that they are to have, and the quads
// between them.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace mien {

// One line of templates/head/half_points.csv.
struct SkinPoint {
  std::string name;
  std::optional<glm::dvec3> skin;  // mm; empty: fairness alone places it
  double weight = 0;               // how strongly the skin is drawn to it
  bool is_hard = false;            // the control point itself, not a place on the skin
};

// The right-hand rules of the half are those of core/conventions.hpp: x >= 0, quads counter-clockwise from
// outside.
struct HalfHead {
  std::vector<SkinPoint> points;
  std::vector<std::array<std::string, 4>> quads;
};

// Reads half_points.csv and half_quads.csv of `folder`. Throws RunError "FILE:LINE: ..." for a malformed
// line, a point named twice, an unknown name in a quad or a directed edge used twice.
HalfHead load_half_head(const std::filesystem::path& folder);

}  // namespace mien

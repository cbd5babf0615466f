// The half head as data, and the whole cage made of it by mirroring.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "head/head.hpp"

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

// The whole cage, control points not yet solved: each stands at its skin point (or at the average of its
// neighbours). Points with x = 0 are the mid-plane and stand once; the others follow as "R:name", x negated.
Cage build_cage(const HalfHead& half);

// The index of a named point of the cage. Throws RunError "the head has no point called 'NAME'".
std::uint32_t find_point(const Cage& cage, std::string_view name);

// Whether `name`, its "R:" apart, begins with `prefix`.
bool has_prefix(std::string_view name, std::string_view prefix);

// The name without its "R:".
std::string_view strip_side(std::string_view name);

}  // namespace mien

#include "scene/openscad_lists.hpp"

#include <algorithm>
#include <string_view>

namespace mien {

namespace {

constexpr std::size_t kRowsPerLine = 8;

// For each vertex the states that move it, rising, and what they add.
struct Moved {
  std::vector<std::size_t> states;
  std::vector<glm::vec3> offsets;
};

std::vector<Moved> list_moved(const PosableBust& bust) {
  std::vector<Moved> moved(bust.rest.size());
  const float least = 0.5f * std::pow(10.0f, -float(kScadDecimals));
  for (std::size_t s = 0; s < bust.states.size(); ++s) {
    const BustState& state = bust.states[s];
    for (std::size_t i = 0; i < state.vertices.size(); ++i) {
      const glm::vec3 offset = glm::abs(state.offsets[i]);
      if (std::max({offset.x, offset.y, offset.z}) < least) continue;
      moved[state.vertices[i]].states.push_back(s);
      moved[state.vertices[i]].offsets.push_back(state.offsets[i]);
    }
  }
  return moved;
}

std::string build_settings(const PosableBust& bust) {
  if (bust.cavity.triangles.empty()) return "";
  return fmt::format(
      "// Hollow, with an inner wall and holes to drain it\nhollow = {};\n"
      "// Thickness of the wall in mm\nwall_mm = {}; // [0.8:0.1:10]\n"
      "// Diameter of the holes in mm; 0: none\ndrain_mm = {}; // [0:0.5:12]\n",
      bust.is_hollow ? "true" : "false", format_number(bust.wall_mm, kScadDecimals),
      format_number(bust.drain_mm, kScadDecimals));
}

std::string build_numbers(const PosableBust& bust) {
  if (bust.cavity.triangles.empty()) return "";
  Mesh cavity = bust.cavity;
  update_normals(cavity);
  const auto points = list_rows(cavity.positions.size(), kRowsPerLine, [&](std::string& text, std::size_t i) {
    text += '[';
    append_scad_vector(text, cavity.positions[i]);
    text += ',';
    append_scad_vector(text, cavity.normals[i]);
    text += ']';
  });
  const auto drains = list_rows(bust.drains.size(), 4, [&](std::string& text, std::size_t i) {
    text += fmt::format("[{}, {}, {}]", format_number(bust.drains[i].x, kScadDecimals),
                        format_number(bust.drains[i].y, kScadDecimals),
                        format_number(bust.drain_tops_mm[i], kScadDecimals));
  });
  return fmt::format(
      "// The cavity: places and the way outward; drains: where and how high they reach.\n"
      "cavity_rows = [{}];\ncavity_triangles = [{}];\ndrains = [{}];\nown_wall_mm = {};\n",
      points, list_scad_triangles(cavity.triangles), drains, format_number(bust.wall_mm, kScadDecimals));
}

constexpr std::string_view kHollowModules =
    R"(// The cavity grows with the bust; a wall that is asked for otherwise moves it along its own normals.
cavity_growth = height_mm / own_height_mm;
module cavity() polyhedron(convexity = 12,
  points = [for (r = cavity_rows) r[0] * cavity_growth + r[1] * (own_wall_mm * cavity_growth - wall_mm)],
  faces = cavity_triangles);
module drain_holes() for (d = drains) translate([d[0] * cavity_growth, d[1] * cavity_growth, -1])
  cylinder(h = d[2] * cavity_growth + 1, d = drain_mm, $fn = hole_sides);

)";

}  // namespace

void append_scad_vector(std::string& text, const glm::vec3& p) {
  text += '[';
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) text += ',';
    append_number(text, p[axis], kScadDecimals);
  }
  text += ']';
}

std::string list_scad_vertices(const PosableBust& bust, std::size_t first, std::size_t end) {
  const std::vector<Moved> moved = list_moved(bust);
  return list_rows(end - first, kRowsPerLine, [&](std::string& text, std::size_t row) {
    const std::size_t v = first + row;
    text += '[';
    append_scad_vector(text, bust.rest[v]);
    if (!moved[v].states.empty()) {
      text += ",[";
      for (std::size_t i = 0; i < moved[v].states.size(); ++i)
        text += fmt::format("{}{}", i > 0 ? "," : "", moved[v].states[i]);
      text += "],[";
      for (std::size_t i = 0; i < moved[v].states.size(); ++i) {
        if (i > 0) text += ',';
        append_scad_vector(text, moved[v].offsets[i]);
      }
      text += ']';
    }
    text += ']';
  });
}

std::string list_scad_triangles(const std::vector<Triangle>& triangles) {
  return list_rows(triangles.size(), 12, [&](std::string& text, std::size_t i) {
    const auto& [a, b, c] = triangles[i];
    text += fmt::format("[{},{},{}]", a, c, b);
  });
}

ScadHollow build_scad_hollow(const PosableBust& bust) {
  if (bust.cavity.triangles.empty()) return {};
  return {build_settings(bust), std::string(kHollowModules), build_numbers(bust)};
}

}  // namespace mien

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

std::string list_scad_cavity(const CavityPlan& plan) {
  constexpr int kDecimals = 2;  // nobody sees the inside
  const auto number = [](double value) { return format_number(value, kDecimals); };
  const std::size_t columns = plan.directions.size();
  const auto rows = list_rows(plan.heights_mm.size(), 8, [&](std::string& text, std::size_t k) {
    text += fmt::format("[{}, {}]", format_number(plan.heights_mm[k], kScadDecimals),
                        format_number(plan.middles_mm[k], kScadDecimals));
  });
  const auto walls = list_rows(plan.walls.size(), 1, [&](std::string& text, std::size_t w) {
    const CavityPlan::Wall& wall = plan.walls[w];
    text += fmt::format("[{}, {}, [", format_number(wall.wall_mm, kScadDecimals),
                        format_number(wall.top_mm, kScadDecimals));
    text += list_rows(plan.heights_mm.size(), 1, [&](std::string& row, std::size_t k) {
      row += '[';
      for (std::size_t j = 0; j < columns; ++j)
        row += (j > 0 ? "," : "") + number(wall.reaches_mm[k * columns + j]);
      row += ']';
    });
    text += "]]";
  });
  const auto ways = list_rows(columns, 8, [&](std::string& text, std::size_t j) {
    text += fmt::format("[{}, {}]", format_number(plan.directions[j].x, kScadFine),
                        format_number(plan.directions[j].y, kScadFine));
  });
  return fmt::format(
      "// The hollow: the ways of its columns; rows as [height, middle]; walls as [thickness, top, how far "
      "each row reaches all around].\n"
      "cavity_ways = [{}];\ncavity_rows = [{}];\ncavities = [{}];\n",
      ways, rows, walls);
}

}  // namespace mien

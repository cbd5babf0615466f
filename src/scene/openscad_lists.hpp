// Lists of numbers in OpenSCAD's words.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/print.hpp"
#include "core/text.hpp"

namespace mien {

inline constexpr int kScadDecimals = 3;  // a micrometre; offsets too
inline constexpr int kScadFine = 5;      // of angles and shares

// A list of `count` things, `per_line` in a line: "a, b,\n  c". `append` adds thing i to the text.
template <typename Append>
std::string list_rows(std::size_t count, std::size_t per_line, const Append& append) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) text += ',';
    text += i % per_line == 0 ? "\n  " : " ";
    append(text, i);
  }
  return text;
}

void append_scad_vector(std::string& text, const glm::vec3& p);

// The vertices [first, end) of a bust: "[place]" or "[place, states, what each of them adds]".
std::string list_scad_vertices(const PosableBust& bust, std::size_t first, std::size_t end);

// Clockwise seen from outside, as OpenSCAD wants them: the second and third corner change places.
std::string list_scad_triangles(const std::vector<Triangle>& triangles);

// The plan of the cavity as the variables that templates/openscad/hollow.scad reads.
std::string list_scad_cavity(const CavityPlan& plan);

}  // namespace mien

// A bust that can be posed without a head: what each move and each expression does to its vertices.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/print.hpp"
#include "frames/bust_body.hpp"

namespace mien {

struct NamedPose {
  std::string name;
  Pose pose;
  bool is_shown = false;  // by a bust that is to be made; else it is only offered
};

// Fills what of `bust` poses it: rest, states, moves, expressions, stands, eyes and mouth, triangles and
// foot. A move gets as many values as keep every vertex within `tolerance_mm` of the way it takes in truth;
// an expression's offsets of less than `slight_mm` are left out, but for the rims of eyes and mouth. Returns
// all the shapes that it went through, places of the body's vertices: at rest, with each move at its ends,
// each expression, the other stand.
std::vector<std::vector<glm::vec3>> add_bust_controls(const BustBody& body, const Figure& figure,
                                                      const std::vector<NamedPose>& expressions,
                                                      double tolerance_mm, double slight_mm,
                                                      PosableBust& bust);

// Where the controls put the vertices that no patch places: the sum that the OpenSCAD source computes.
std::vector<glm::vec3> sum_bust_states(const PosableBust& bust, const std::vector<double>& values);

}  // namespace mien

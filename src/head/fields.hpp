// Soft fields: a few named points are moved, others held, and the rest of the cage follows smoothly.
//
// Source: biharmonic deformation with handles (Botsch and Kobbelt, "An intuitive framework for real-time
// freeform modeling", 2004), the Laplacian weighted by 1 / edge length, handles and anchors as soft
// constraints.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "config/shape_data.hpp"
#include "head/head.hpp"

namespace mien {

// A displacement in millimetres for each control point of the cage.
using Field = std::vector<glm::dvec3>;

// Which side of the head a table of handles of the left half moves.
enum class Reach { both, left, odd };

// Ready to solve fields on one cage: the energy is assembled once. Fields that hold and move the same points
// one after the other are solved with the same factors.
struct FieldSolver {
  struct State;  // the sparse matrix and its symbolic factors
  std::shared_ptr<State> state;
  const Cage* cage = nullptr;  // must outlive the solver
};

FieldSolver build_field_solver(const Cage& cage);

// Solves for one field. Reach::both moves the mirror images as well; Reach::odd moves them the same way
// across the face and the other way up and forward, so that the field's mirror image is its negative;
// Reach::left holds the other side's copies of the handles further than 12 mm from the mid-plane still and
// lets the strip between be dragged. A point in `anchors` that is also a handle is a handle. Throws RunError
// for a handle that the cage does not have.
Field solve_field(const FieldSolver& solver, const Handles& handles, const std::vector<bool>& anchors,
                  Reach reach);

// The same for one number a point (a weight between 0 and 1, say), on both sides.
std::vector<double> solve_weights(const FieldSolver& solver, const std::map<std::string, double>& values,
                                  const std::vector<bool>& zeros);

// The mirror image of a field.
Field mirror_field(const Cage& cage, const Field& field);

}  // namespace mien

// Shapes the head's parts are made of: curves through points, closed rows of rings, tapered tubes.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "core/mesh.hpp"

namespace mien {

// The point at `t` of a Catmull-Rom curve through `points` (at least 2): t = i is points[i]. Beyond its ends
// the curve goes on straight. `is_closed`: t counts round and round, points.size() is the start again.
glm::vec3 sample_curve(const std::vector<glm::vec3>& points, double t, bool is_closed = false);

// The same for one number a station: `knots` ascending, clamped at the ends, smooth and without overshoot
// (cosine steps between stations).
double sample_stations(const std::vector<double>& knots, const std::vector<double>& values, double at);

using Ring = std::vector<glm::vec3>;

// The mean of a ring's points.
glm::vec3 compute_middle(const Ring& ring);

// A closed skin over `rings` (each of the same count of points, at least 3), its two ends closed by a fan to
// `start` and to `end`. The rings run counter-clockwise seen from `end`. Adds 1 + rings x points + 1 vertices
// in this order; normals are the caller's affair.
void append_loft(Mesh& mesh, const glm::vec3& start, const std::vector<Ring>& rings, const glm::vec3& end);

// A tube of `sides` around `centres`, tapered by `radii_mm` (as many; the last is taken as 0: the tip is a
// point). Adds (centres.size() - 1) x sides + 1 vertices. The root is closed by a fan: the tube is a closed
// mesh. `across` gives the first side's direction at the root.
void append_hair(Mesh& mesh, const std::vector<glm::vec3>& centres, const std::vector<float>& radii_mm,
                 int sides, const glm::vec3& across);

// A number in [0, 1) that depends on its three arguments only: scattered places that are the same in every
// run.
double scatter(std::uint32_t series, std::uint32_t index, std::uint32_t channel);

// A number in [0, 1) of each index, 0, 1, 2 ..., as unlike those before it as can be: steps of the golden
// section from `first` on.
double step_golden(std::uint32_t index, double first = 0);

// Smooth noise in -1..1 around a circle of `period` cells: `at` counts cells.
double sample_noise(std::uint32_t series, double at, int period);

}  // namespace mien

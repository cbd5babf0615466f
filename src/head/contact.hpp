// What must touch and must not pass through each other on every head: lids and ball, upper and lower lip.
#pragma once

#include <string_view>
#include <vector>

#include "config/part_numbers.hpp"
#include "head/head.hpp"
#include "head/surface.hpp"

namespace mien {

// How far `point` stands off the left eye, mm: off its ball, or off the cornea where that stands out of the
// ball. Negative inside. Measured from the ball's centre outward.
double compute_standoff_mm(const EyeNumbers& numbers, const Eye& eye, const glm::dvec3& point);

// A vertex of a ring round the left eye; `at` counts columns: 0 the inner corner, 4 the middle of the upper
// lid, 8 the outer corner, 12 the middle of the lower lid.
struct MarginVertex {
  std::uint32_t vertex = 0;
  double at = 0;
};

// A ring of the cage and its neighbours on both sides. The margin of the lids runs from E0, its inner edge on
// the ball, to E1.
struct LidRings {
  std::string_view before = "EB_", ring = "E0_", next = "E1_";
};

// The vertices of the skin on a ring.
std::vector<MarginVertex> compute_lid_ring(const Surface& surface, const Cage& cage,
                                           const LidRings& rings = {});

// Whether the margin touches the eye at a column: not in the corners, where the outer one has a fold of its
// own and the inner one the caruncle.
bool touches_eye(double at);

// Turns the lids to where they rest over the iris (head/lid_rest.hpp), then moves the inner edge of their
// margins (E0) out of the ball or onto it where they touch it. Both eyes alike.
void seat_lids(const Surface& surface, const EyeNumbers& numbers, const Eye& eye, Cage& cage);

// The second half of that alone.
void touch_ball(const Surface& surface, const EyeNumbers& numbers, const Eye& eye, Cage& cage);

// Parts the lips where the smooth skin of one passes through the other's: rows M0 to M2 of both give way by
// halves, column by column. Lips that are apart stay as they are.
void part_lips(const Surface& surface, Cage& cage);

}  // namespace mien

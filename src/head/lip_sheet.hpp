// The skin of the lips' red where they meet, as two sheets of one half of the mouth, and how far one passes
// through the other. Heads at rest and posed ones are kept apart by the same measure.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "head/head.hpp"
#include "head/surface.hpp"

namespace mien {

inline constexpr int kLipColumns = 6;  // from the middle (0) to the corner of the mouth
inline constexpr std::array<const char*, 3> kLipRings{"M0_", "M1_", "M2_"};

// The number behind the underscore of "M1_10" in `ring` "M1_", and -1 for a point of another ring.
int compute_ring_column(std::string_view name, std::string_view ring);

// One lip of the left half: the skin between the rings M0 and M2. Vertices are numbered in the sheet's own
// order; vertex v is the sum over [first[v], first[v + 1]) of weight * control point, for the left half and
// for the right one, whose sheet is worked in its mirror.
struct LipSheet {
  std::vector<std::uint32_t> vertices;  // of the skin, left half, ascending
  std::vector<double> column;           // 0 the middle, 6 the corner
  std::vector<std::uint32_t> first, left, right;
  std::vector<double> weight;
  std::vector<std::array<std::uint32_t, 4>> quads;
};

// The most that each column of the lips lacks, mm in height; 0 or less where nothing does.
using LipShortfalls = std::array<double, kLipColumns + 1>;

LipSheet build_lip_sheet(const Surface& surface, const Cage& cage, bool is_upper);

// Where its vertices lie, into `at` (resized): mm, the right half in its mirror.
void place_lip(const LipSheet& sheet, const std::vector<glm::dvec3>& points, Side side,
               std::vector<glm::dvec3>& at);

// Raises `lacks` to how far the vertices of one lip are nearer than `apart_mm` to the other's sheet straight
// above or below them, or through it. At the corner, where the lips are one skin, nothing is asked.
void compute_lip_shortfalls(const LipSheet& upper, const std::vector<glm::dvec3>& upper_at,
                            const LipSheet& lower, const std::vector<glm::dvec3>& lower_at, double apart_mm,
                            LipShortfalls& shortfalls);

}  // namespace mien

#include "frames/skin_motion.hpp"

#include <cmath>

#include "head/patterns.hpp"

namespace mien {

namespace {

// In the order of kSkinRegions.
const std::array<std::vector<std::string>, kSkinRegions.size()> kPoints{
    {{"E5_1..7", "f*_F1", "f*_F2", "c*_F1", "c*_F2", "p_F1", "p_F2", "c*_g", "p_g"},
     {"E1_*", "E2_*", "E3_*", "E4_*"},
     {"k_*", "c3_*", "p_b*", "p_st", "p_tip", "q*_C*"},
     {"M1_*", "M2_*", "M3_*", "M4_*", "MA_*", "M5_*"},
     {"M6_7..12", "m*_D1", "q*_D1"}}};

}  // namespace

SkinMotion measure_motion(const Figure& figure, const Pose& pose) {
  DeformBuffers buffers;
  PartShape rest, posed;
  deform_skin(figure, *figure.head.surface, Pose{}, TurnKey{}, buffers, rest);
  deform_skin(figure, *figure.head.surface, pose, TurnKey{}, buffers, posed);
  SkinMotion motion;
  for (std::size_t i = 0; i < figure.head.cage.points.size(); ++i)
    motion.ways_mm.push_back(posed.positions[i] - rest.positions[i]);
  for (std::size_t region = 0; region < kSkinRegions.size(); ++region) {
    const std::vector<bool> found = find_points(figure.head.cage, kPoints[region]);
    double count = 0;
    for (std::size_t i = 0; i < found.size(); ++i)
      if (found[i]) motion.mean_mm[region] += double(glm::length(motion.ways_mm[i])), ++count;
    motion.mean_mm[region] /= count;
  }
  return motion;
}

double compute_likeness(const SkinMotion& a, const SkinMotion& b) {
  double product = 0, of_a = 0, of_b = 0;
  for (std::size_t i = 0; i < a.ways_mm.size(); ++i) {
    const glm::dvec3 one(a.ways_mm[i]), other(b.ways_mm[i]);
    product += glm::dot(one, other);
    of_a += glm::dot(one, one);
    of_b += glm::dot(other, other);
  }
  return of_a == 0 || of_b == 0 ? 0 : product / std::sqrt(of_a * of_b);
}

}  // namespace mien

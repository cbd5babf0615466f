// Eyes and ears as wholes: sized, moved and turned as one thing each, the skin around them following.
#pragma once

#include <functional>
#include <string_view>

#include "head/guides.hpp"

namespace mien {

// What happens to the left eye; the right one is its mirror image.
struct EyeChange {
  double size = 1;        // of the ball, its lids and its opening
  glm::dvec2 move_mm{0};  // outward, upward
  double tilt_deg = 0;    // outer corner up (+), about the ball's own axis: the lids stay on the ball
  bool is_none() const { return size == 1 && move_mm == glm::dvec2(0) && tilt_deg == 0; }
};

struct EarChange {
  double size = 1;
  double out_deg = 0;  // stands out from the head further (+), about its root
  bool is_none() const { return size == 1 && out_deg == 0; }
};

// How far a point follows the ball: 1 on the lids, less on the three rings around them.
double compute_eye_share(std::string_view name, double e3, double e4, double e5);

// How far the places around an ear follow it: three rings of skin around its hole, outermost first, the
// hole's edge, and the first three rings of the ear itself. The rest of the ear is the ear.
struct EarShares {
  double far, near, around, edge, first, second, third;
};
inline constexpr EarShares kGrownEar{0.22, 0.48, 0.75, 1,
                                     1,    1,    1};  // the hole grows with it, or the root would fold
inline constexpr EarShares kTurnedEar{0, 0, 0, 0, 0, 0.3, 0.65};  // the head stays as it is

// How far a point follows the ear.
double compute_ear_share(std::string_view name, const EarShares& shares);

// Moves each point by its share of `move`, which is told for the left half.
void move_shares(const Cage& cage, const std::function<double(std::string_view)>& compute_share,
                 const std::function<glm::dvec3(const glm::dvec3&)>& move, HeadForm& shape);

// `cage` lends names only.
void change_eyes(const Cage& cage, const EyeChange& change, HeadForm& shape);
void change_ears(const Cage& cage, const EarChange& change, HeadForm& shape);

}  // namespace mien

// The limits of the areas by name, with the names that they have in the thesis (Yen, "Animation of Human
// Faces", Tamkang University, 1990, section 5.3), where each is one adjustable variable of the head.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "config/areas.hpp"

namespace mien {

// One way of one move of one side. Its left and right are the character's own; those of the thesis's names
// are the viewer's, so that "brow.left.up" is EYEBROW_R_U_VERT_LIMIT.
struct LimitName {
  std::string name;    // "brow.left.up", "lips.lower_down"
  std::string plural;  // "brows.up"; empty for an area without sides
  std::string thesis;  // empty where the thesis names none
  std::size_t move = 0;
  int sign = 1;  // which way of the move
};

// All of them, in the order of kMoves, the positive way first. Shutting the upper lid is none: it ends where
// the lids meet.
const std::vector<LimitName>& list_limits();

inline constexpr double kMaxLimit = 2;      // times the head's own; further the skin folds over
inline constexpr double kMaxLimit_mm = 60;  // as a length

// The level where both lips and the chin stop: as a length it is a height, up (+) or down from where the lips
// meet at rest.
inline constexpr std::string_view kMatchLevel = "LIPS_MATCH_LEVEL";
inline constexpr double kMaxMatchLevel_mm = 15;  // the lips of a shut mouth go no further up or down

// The lengths of a face that limits are stored in, so that one performance reads the same on every head
// (after the facial animation parameter units of MPEG-4).
inline constexpr std::array<std::string_view, 5> kFaceUnits{"eye_separation", "eye_nose", "mouth_nose",
                                                            "mouth_width", "iris"};

}  // namespace mien

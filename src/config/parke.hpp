// Parke's expression parameters in the moves of our areas: words, and no skin of their own.
//
// Source: F. I. Parke, "Parameterized models for facial animation" (IEEE CG&A, 1982), whose face is moved by
// interpolation, rotation, scaling and offsets of regions, each hard-wired to a number. The parameters are
// those that his papers and the thesis name; how far each goes is that of our moves. His conformation
// parameters shape a head and move nothing: conformation.hpp.
#pragma once

#include <array>
#include <string_view>

#include "config/areas.hpp"

namespace mien {

struct ParkeRow {
  std::string_view name;
  double low = 0, high = 1;
  std::string_view meaning;
  std::array<ChannelMove, 4> plus = {}, minus = {};  // at 1 and at -1; without a name: none
};

// The tables are read across. Moves of an area with sides are of both.
// clang-format off
inline constexpr std::array kParkeRows{
    ParkeRow{"jaw_rotation", 0, 1, "the jaw turned open", {{{"chin", "down", 1}}}},
    ParkeRow{"mouth_width", -1, 1, "the mouth scaled wider (+) or narrower (-)", {{{"corner", "out", 1}}}, {{{"corner", "out", -1}}}},
    ParkeRow{"mouth_expression", -1, 1, "a smile (+) or a frown (-): an interpolation of the mouth", {{{"corner", "up", 1}, {"corner", "out", 0.3}}}, {{{"corner", "up", -1}, {"corner", "out", 0.1}}}},
    ParkeRow{"upper_lip", -1, 1, "the upper lip raised (+) or lowered (-)", {{{"lips", "upper", 1}}}, {{{"lips", "upper", -1}}}},
    ParkeRow{"lower_lip", -1, 1, "the lower lip raised (+) or lowered (-)", {{{"lips", "lower", 1}}}, {{{"lips", "lower", -1}}}},
    ParkeRow{"lower_lip_tuck", 0, 1, "the lower lip under the upper teeth, as in an f", {{{"lips", "lower", 0.9}, {"lips", "roll", 0.5}, {"lips", "upper", 0.25}}}},
    ParkeRow{"mouth_forward", 0, 1, "the mouth pushed forward", {{{"lips", "funnel", 0.6}, {"corner", "out", -0.5}}}},
    ParkeRow{"nostril_size", 0, 1, "the wings of the nose wider and up", {{{"nose", "sneer", 0.6}}}},
    ParkeRow{"brow_height", -1, 1, "the brows up (+) or down (-)", {{{"brow", "up", 1}}}, {{{"brow", "up", -1}}}},
    ParkeRow{"brow_arch", -1, 1, "the brows arched (+): their inner ends lower than their outer ones; or inner ends up (-)", {{{"brow", "turn", -1}, {"brow", "up", 0.35}}}, {{{"brow", "turn", 1}}}},
    ParkeRow{"brow_separation", -1, 1, "the brows apart (+) or together (-)", {{{"brow", "out", 1}}}, {{{"brow", "out", -1}}}},
    ParkeRow{"eyelid_opening", -1, 1, "the upper lids opened wide (+) or shut (-)", {{{"lid", "upper", 1}}}, {{{"lid", "upper", -1}}}},
    ParkeRow{"lower_lid", 0, 1, "the lower lids raised", {{{"lid", "lower", 1}}}},
    ParkeRow{"gaze_side", -1, 1, "the eyes to the character's left (+) or right (-)", {{{"eye", "side", 1}}}, {{{"eye", "side", -1}}}},
    ParkeRow{"gaze_up", -1, 1, "the eyes up (+) or down (-)", {{{"eye", "up", 1}}}, {{{"eye", "up", -1}}}},
};
// clang-format on

}  // namespace mien

// Who moves the skin: the areas of areas.hpp, or one of three doctrines that came before them, written beside
// the areas as numbers of their own. Muscles and units are channels of a pose as moves are; Parke's
// parameters are words for moves (config/parke.hpp).
//
// Sources: K. Waters, "A muscle model for animating three-dimensional facial expression" (SIGGRAPH 1987), and
// the muscles of his program geoface (1994); J. Ahlberg, "CANDIDE-3, an updated parameterised face"
// (Linkoping, 2001); F. I. Parke, "Parameterized models for facial animation" (IEEE CG&A, 1982).
#pragma once

#include <array>
#include <string_view>

#include "config/area_info.hpp"

namespace mien {

enum class Doctrine { areas, muscles, candide, parke };

inline constexpr std::string_view kMusclesKey = "muscles", kCandideKey = "candide", kParkeKey = "parke";

// What a channel of a doctrine does besides its own field, or in its place: a move of the areas, by how much
// at 1.
struct ChannelMove {
  std::string_view area, move;
  double value = 0;
};

// A muscle or a unit. `of` is the area that it moves most: with it the channel sets out and arrives (lead).
struct ChannelRow {
  std::string_view name;
  std::string_view alias;  // another name that the language knows
  bool is_sided = false;   // one each side
  double low = 0, high = 1;
  Area of = Area::brow;
  std::string_view meaning;
  std::string_view stop;  // why it goes no further than its limit
};

inline constexpr std::string_view kMuscleStop = "a muscle contracts no further";
inline constexpr std::string_view kUnitStop = "the unit's data end there";

// The tables are read across.
// clang-format off

// Those of geoface, and those that the thesis names besides (table 3-1).
inline constexpr std::array kMuscleRows{
    ChannelRow{"frontalis_inner", "", true, 0, 1, Area::brow, "the inner end of the brow up", kMuscleStop},
    ChannelRow{"frontalis_major", "", true, 0, 1, Area::brow, "the whole brow up", kMuscleStop},
    ChannelRow{"frontalis_outer", "", true, 0, 1, Area::brow, "the outer end of the brow up", kMuscleStop},
    ChannelRow{"secondary_frontalis", "", true, 0, 1, Area::brow, "the skin between brow and lid up", kMuscleStop},
    ChannelRow{"lateral_corrugator", "corrugator", true, 0, 1, Area::brow, "the brow inward and down", kMuscleStop},
    ChannelRow{"levator_palpebrae", "", true, 0, 1, Area::lid, "the upper lid up: it turns", kMuscleStop},
    ChannelRow{"orbicularis_oculi", "", true, 0, 1, Area::lid, "a ring about the eye: cheek and brow toward it, the lids narrower", kMuscleStop},
    ChannelRow{"labi_nasi", "", true, 0, 1, Area::lips, "the side of the upper lip up", kMuscleStop},
    ChannelRow{"inner_labi_nasi", "", true, 0, 1, Area::nose, "the wing of the nose up, and the lip below it", kMuscleStop},
    ChannelRow{"zygomatic_minor", "", true, 0, 1, Area::corner, "the lip beside the corner up and outward", kMuscleStop},
    ChannelRow{"zygomatic_major", "", true, 0, 1, Area::corner, "the corner of the mouth up and outward", kMuscleStop},
    ChannelRow{"risorius", "", true, 0, 1, Area::corner, "the corner outward", kMuscleStop},
    ChannelRow{"buccinator", "", true, 0, 1, Area::corner, "the corner outward and back, against the teeth", kMuscleStop},
    ChannelRow{"angular_depressor", "", true, 0, 1, Area::corner, "the corner down", kMuscleStop},
    ChannelRow{"depressor_labii", "", true, 0, 1, Area::lips, "the side of the lower lip down", kMuscleStop},
    ChannelRow{"orbicularis_oris", "", false, 0, 1, Area::lips, "a ring about the mouth: the lips together and forward", kMuscleStop},
    ChannelRow{"pterygoids", "", false, 0, 1, Area::chin, "the jaw open: it turns", kMuscleStop},
    ChannelRow{"masseter", "", false, 0, 1, Area::chin, "half of what shuts the jaw against the pterygoids", kMuscleStop},
    ChannelRow{"temporalis", "", false, 0, 1, Area::chin, "the other half", kMuscleStop},
};

// CANDIDE-3's animation units, in the order of its file, by their names and by the action unit they stand for.
inline constexpr std::array kUnitRows{
    ChannelRow{"upper_lip_raiser", "AU10", false, -1, 1, Area::lips, "AUV 0: the upper lip up", kUnitStop},
    ChannelRow{"jaw_drop", "AU26", false, 0, 1, Area::chin, "AUV 11, of AU 26 and 27: the jaw open; it turns", kUnitStop},
    ChannelRow{"lip_stretcher", "AU20", false, -1, 1, Area::corner, "AUV 2: the corners outward and back", kUnitStop},
    ChannelRow{"brow_lowerer", "AU4", false, -1, 1, Area::brow, "AUV 3: the brows inward and down", kUnitStop},
    ChannelRow{"lip_corner_depressor", "AU15", false, -1, 1, Area::corner, "AUV 14, of AU 13 and 15: the corners down; below 0 up", kUnitStop},
    ChannelRow{"outer_brow_raiser", "AU2", false, -1, 1, Area::brow, "AUV 5: the brows up, outside most", kUnitStop},
    ChannelRow{"eyes_closed", "AU43", false, 0, 1, Area::lid, "AUV 6, of AU 42 to 45: the lids shut; they turn", kUnitStop},
    ChannelRow{"lid_tightener", "AU7", false, 0, 1, Area::lid, "AUV 7: the lids narrower; they turn", kUnitStop},
    ChannelRow{"nose_wrinkler", "AU9", false, -1, 1, Area::nose, "AUV 8: wings, upper lip and corners up", kUnitStop},
    ChannelRow{"lip_presser", "AU24", false, 0, 1, Area::lips, "AUV 9, of AU 23 and 24: the lips together", kUnitStop},
    ChannelRow{"upper_lid_raiser", "AU5", false, 0, 1, Area::lid, "AUV 10: the upper lids up; they turn", kUnitStop},
    ChannelRow{"inner_brow_raiser", "AU1", false, -1, 1, Area::brow, "AUV 12: the inner ends of the brows up", kUnitStop},
    ChannelRow{"jaw_forward", "AU29", false, 0, 1, Area::jaw, "the file's jaw z-push: the jaw forward", kUnitStop},
    ChannelRow{"jaw_side", "AU30", false, -1, 1, Area::jaw, "the file's jaw x-push: the jaw to the character's left (+)", kUnitStop},
};

// clang-format on

template <std::size_t Count>
constexpr std::size_t count_channels(const std::array<ChannelRow, Count>& rows) {
  std::size_t count = 0;
  for (const ChannelRow& row : rows) count += row.is_sided ? 2 : 1;
  return count;
}

inline constexpr std::size_t kMuscleCount = count_channels(kMuscleRows),
                             kUnitCount = count_channels(kUnitRows);

}  // namespace mien

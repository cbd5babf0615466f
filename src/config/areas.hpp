// The areas of the face and their moves, as the language names them: Tezuka's nine with limits as in Yen
// 1990, and what faces do beyond them. One table of areas and one of moves: whatever speaks of areas takes it
// from here, and what a new one needs is a row of each. Knows words and numbers only; what a move does to the
// skin is face/'s affair.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>

#include "config/area_info.hpp"
#include "config/doctrines.hpp"
#include "core/error.hpp"

namespace mien {

// The lines of the face, on the character's left or across the mouth.
inline constexpr PlaceText kBrowLine = "E5_2..6";
inline constexpr PlaceText kUpperLidLine = "E1_0..8", kLowerLidLine = "E1_8..15 E1_0";
inline constexpr PlaceText kUpperLipLine = "R:M3_6..1 M3_0..6", kLowerLipLine = "R:M3_6..11 M3_12..6";
inline constexpr PlaceText kJawLine = "R:M6_8..11 M6_12..8";
inline constexpr PlaceText kCheekLine = "q12_C4..8", kWingLine = "k_b2 k_st k_tip k_it";

// The head's, behind all areas.
inline constexpr AreaLead kHeadLead{LeadPart::head, 0.1875, 0.1875, 0.1875, 0.1875};

// The tables are read across.
// clang-format off

// What is drawn for the limits.
inline constexpr std::array kBrowLimits{
    LimitMark{LimitShape::lines, kBrowLine},
    LimitMark{LimitShape::lines, kBrowLine, "turn", 1},
    LimitMark{LimitShape::lines, kBrowLine, "turn", -1},
    LimitMark{LimitShape::box, kBrowLine, "out"},
};
inline constexpr std::array kLidLimits{
    LimitMark{LimitShape::lines, kUpperLidLine},
    LimitMark{LimitShape::lines, kLowerLidLine},
    LimitMark{LimitShape::lines, kUpperLidLine, "upper", 1},
    LimitMark{LimitShape::lines, kLowerLidLine, "lower", 1},
    LimitMark{LimitShape::level, "E1_4", "upper", 1, "upper"},
    LimitMark{LimitShape::level, "E1_12", "lower", 1, "lower"},
    LimitMark{LimitShape::level, "E1_12", "", 0, "where both end below"},
};
inline constexpr std::array kEyeLimits{
    LimitMark{LimitShape::lines, kUpperLidLine},
    LimitMark{LimitShape::lines, kLowerLidLine},
    LimitMark{LimitShape::box, "pupil_l", "side"},
};
inline constexpr std::array kLipsLimits{
    LimitMark{LimitShape::line, kUpperLipLine},
    LimitMark{LimitShape::line, kLowerLipLine},
    LimitMark{LimitShape::line, kUpperLipLine, "upper", 1},
    LimitMark{LimitShape::line, kLowerLipLine, "lower", -1},
    LimitMark{LimitShape::level, "M3_0", "upper", 1, "upper up"},
    LimitMark{LimitShape::level, "M1_0", "", 0, "match level"},
    LimitMark{LimitShape::level, "M3_12", "lower", -1, "lower down"},
};
inline constexpr std::array kCornerLimits{
    LimitMark{LimitShape::line, kUpperLipLine},
    LimitMark{LimitShape::line, kLowerLipLine},
    LimitMark{LimitShape::box, "ch_l", "out"},
};
inline constexpr std::array kChinLimits{
    LimitMark{LimitShape::line, kJawLine},
    LimitMark{LimitShape::line, kJawLine, "up", 1},
    LimitMark{LimitShape::line, kJawLine, "down", 1},
    LimitMark{LimitShape::level, "M6_12", "up", 1, "up"},
    LimitMark{LimitShape::level, "M6_12", "", 0, "at rest"},
    LimitMark{LimitShape::level, "M6_12", "down", 1, "down"},
};
inline constexpr std::array kTongueLimits{
    LimitMark{LimitShape::line, kUpperLipLine},
    LimitMark{LimitShape::line, kLowerLipLine},
};
inline constexpr std::array kCheekLimits{
    LimitMark{LimitShape::lines, kCheekLine},
    LimitMark{LimitShape::lines, kCheekLine, "puff", 1},
};
inline constexpr std::array kJawLimits{
    LimitMark{LimitShape::line, kJawLine},
    LimitMark{LimitShape::line, kJawLine, "side", 1},
    LimitMark{LimitShape::line, kJawLine, "side", -1},
};
inline constexpr std::array kMouthLimits{
    LimitMark{LimitShape::line, kUpperLipLine},
    LimitMark{LimitShape::line, kUpperLipLine, "side", 1},
    LimitMark{LimitShape::line, kUpperLipLine, "side", -1},
};
inline constexpr std::array kNoseLimits{
    LimitMark{LimitShape::lines, kWingLine},
    LimitMark{LimitShape::lines, kWingLine, "sneer", 1},
};

inline constexpr std::array kAreas{
    AreaInfo{.area = Area::brow, .name = "brow", .plural = "brows", .left_key = "brow.left",
     .right_key = "brow.right", .title = "brow", .in_words = "the eyebrow", .is_one_column = false, .sign = AreaSign::turned_way, .aside = "out", .is_quick = false,
     .lead = {LeadPart::brows, 0.0625, 0.0625, 0.0625, 0.2917}, .lean = {1, true},
     .framing = {"en_l ex_l brow_inner_l brow_outer_l brow_mid_l", 1.45}, .outlines = {kBrowLine},
     .limits = {0, "Eyebrows", "each stays in its rectangle, and between its two turns",
                {"ex_l ex_r brow_mid_l brow_mid_r", 0.98}, kBrowLimits}},
    AreaInfo{.area = Area::lid, .name = "lid", .plural = "lids", .left_key = "lid.left", .right_key = "lid.right",
     .title = "lids", .in_words = "the eyelids", .is_one_column = false, .sign = AreaSign::pair, .aside = "", .is_quick = true,
     .lead = {LeadPart::lids, 0.0625, 0.0625, 0.0625, 0.1458},
     // One nucleus drives both eyes' lids: one that opens a frame later winks. An eye open less than its fellow
     // looks ill.
     .lean = {0.5, false},
     .framing = {"en_l ex_l", 1.35}, .outlines = {kUpperLidLine, kLowerLidLine},
     .limits = {4, "Eyelids", "both end below where the lower lid rests", {"en_l ex_l", 1.35}, kLidLimits}},
    AreaInfo{.area = Area::eye, .name = "eye", .plural = "eyes", .left_key = "eye.left", .right_key = "eye.right",
     .title = "eyeball", .in_words = "the eyeball", .is_one_column = false, .sign = AreaSign::way, .aside = "side", .is_quick = true,
     .lead = {LeadPart::eyes, 0, 0, 0, 0}, .lean = {},  // they move together
     .framing = {"en_l ex_l", 1.35}, .outlines = {},
     // One eye's: beside two there is no room for words.
     .limits = {2, "Eyeballs", "each pupil stays in its rectangle", {"en_l ex_l", 1.35}, kEyeLimits}},
    AreaInfo{.area = Area::lips, .name = "lips", .plural = "", .left_key = "", .right_key = "",
     .title = "lips", .in_words = "the lips", .is_one_column = true, .sign = AreaSign::pair, .aside = "", .is_quick = false,
     .lead = {LeadPart::lips, 0.125, 0.1667, 0, 0.0417}, .lean = {},
     .framing = {"ch_l ch_r", 1.3}, .outlines = {kUpperLipLine, kLowerLipLine},
     .limits = {3, "Lips", "both stop where they meet, at the match level", {"ch_l ch_r", 1.35}, kLipsLimits}},
    AreaInfo{.area = Area::corner, .name = "corner", .plural = "corners", .left_key = "corner.left",
     .right_key = "corner.right", .title = "mouth corners", .in_words = "the mouth corner", .is_one_column = true, .sign = AreaSign::way, .aside = "out", .is_quick = false,
     .lead = {LeadPart::corners, 0.125, 0, 0.1667, 0.1458}, .lean = {1, true},
     .framing = {"ch_l ch_r", 1.5}, .outlines = {kUpperLipLine, kLowerLipLine},
     .limits = {1, "Mouth corners", "each stays in its rectangle", {"ch_l ch_r", 1.35}, kCornerLimits}},
    AreaInfo{.area = Area::chin, .name = "chin", .plural = "", .left_key = "", .right_key = "",
     .title = "chin", .in_words = "the chin", .is_one_column = true, .sign = AreaSign::lift, .aside = "", .is_quick = false,
     .lead = {LeadPart::chin, 0.1875, 0.1667, 0, 0}, .lean = {},
     .framing = {"li gn", 3.2}, .outlines = {kJawLine},
     .limits = {5, "Chin", "turns about the jaw's axis; stops above where the lips meet", {"li gn", 3.4},
                kChinLimits}},
    AreaInfo{.area = Area::tongue, .name = "tongue", .plural = "", .left_key = "", .right_key = "",
     .title = "tongue", .in_words = "the tongue", .is_one_column = true, .sign = AreaSign::words, .aside = "", .is_quick = true,
     .lead = {LeadPart::tongue, 0.1875, 0.1667, 0, 0}, .lean = {},
     .framing = {"ch_l ch_r", 1.5}, .outlines = {},
     .limits = {6, "Tongue", "goes out where lips and teeth leave it room, and up to the ridge behind the teeth",
                {"ch_l ch_r", 1.35}, kTongueLimits},
     .open = 0.6},
    AreaInfo{.area = Area::cheek, .name = "cheek", .plural = "cheeks", .left_key = "cheek.left", .right_key = "cheek.right",
     .title = "cheeks", .in_words = "the cheek", .is_one_column = true, .sign = AreaSign::words, .aside = "", .is_quick = false,
     .lead = {LeadPart::cheeks, 0.125, 0.1667, 0, 0.0417}, .lean = {1, true},
     .framing = {"ch_l ch_r", 2.4}, .outlines = {},
     .limits = {7, "Cheeks", "blown up from within", {"ch_l ch_r", 2.2}, kCheekLimits}},
    AreaInfo{.area = Area::jaw, .name = "jaw", .plural = "", .left_key = "", .right_key = "",
     .title = "jaw", .in_words = "the jaw", .is_one_column = true, .sign = AreaSign::words, .aside = "", .is_quick = false,
     .lead = {LeadPart::jaw, 0.1875, 0.1667, 0, 0}, .lean = {},
     .framing = {"li gn", 3.2}, .outlines = {kJawLine},
     .limits = {8, "Jaw", "slides to either side and forward", {"li gn", 3.4}, kJawLimits}},
    AreaInfo{.area = Area::mouth, .name = "mouth", .plural = "", .left_key = "", .right_key = "",
     .title = "mouth", .in_words = "the mouth", .is_one_column = true, .sign = AreaSign::words, .aside = "", .is_quick = false,
     .lead = {LeadPart::mouth, 0.125, 0.1667, 0, 0.0417}, .lean = {},
     .framing = {"ch_l ch_r", 1.7}, .outlines = {kUpperLipLine, kLowerLipLine},
     .limits = {9, "Mouth", "all of it goes to either side", {"ch_l ch_r", 1.7}, kMouthLimits}},
    AreaInfo{.area = Area::nose, .name = "nose", .plural = "nose", .left_key = "nose.left", .right_key = "nose.right",
     .title = "nose", .in_words = "the nose", .is_one_column = true, .sign = AreaSign::words, .aside = "", .is_quick = false,
     .lead = {LeadPart::nose, 0.0625, 0.0625, 0.0625, 0.2917}, .lean = {1, true},
     .framing = {"al_l al_r", 2.4}, .outlines = {kWingLine},
     .limits = {10, "Nose", "each wing is drawn up", {"al_l al_r", 2.4}, kNoseLimits}},
};

constexpr const AreaInfo& find_area(Area area) { return kAreas[static_cast<std::size_t>(area)]; }

// kMoves without sides: those of one area lie side by side, the areas in the order of kAreas.
inline constexpr std::array kMovesOfOneSide{
    MoveInfo{"brow", Side::none, "up", -1, 1, "the whole brow up (+) or down (-)",
             Area::brow, {"up", "EYEBROW_@_U_VERT_LIMIT"}, {"down", "EYEBROW_@_D_VERT_LIMIT"},
             "brow_mid", "brow_mid_l brow_inner_l brow_outer_l"},
    MoveInfo{"brow", Side::none, "out", -1, 1, "away from (+) or toward (-) the middle of the face",
             Area::brow, {"out", "EYEBROW_@_@_HORT_LIMIT"}, {"in", "EYEBROW_@_~_HORT_LIMIT"},
             "brow_mid", "brow_mid_l brow_inner_l brow_outer_l", true},
    MoveInfo{"brow", Side::none, "turn", -1, 1, "inner end up (+) or down (-)",
             Area::brow, {"turn_up", "EYEBROW_ROTATE_RANGE"}, {"turn_down", "EYEBROW_ROTATE_RANGE"},
             "brow_mid", "E5_2 E5_3 E5_5 E5_6"},
    MoveInfo{"lid", Side::none, "upper", -1, 1, "upper lid shut (-1), at rest (0), at its upper limit (1)",
             Area::lid, {"upper", "EYELID_@U_U_VERT_LIMIT"}, {"shut", "", "shut is shut", "where lids meet"},
             "lid_upper", "E1_4 E1_2 E1_6"},
    MoveInfo{"lid", Side::none, "lower", 0, 1, "lower lid raised to its limit (1)",
             Area::lid, {"lower", "EYELID_@D_U_VERT_LIMIT"}, {},
             "lid_lower", "E1_12 E1_10 E1_14"},
    MoveInfo{"lid", Side::none, "out", -1, 1, "both lids drawn away from the nose (+) or toward it (-), as by a gaze aside",
             Area::lid, {"out"}, {"in"},
             "lid_upper", "E2_4 E2_12", true, true},
    MoveInfo{"eye", Side::none, "up", -1, 1, "gaze up (+) or down (-)",
             Area::eye, {"up", "", "an eye turns no further"}, {"down", "", "an eye turns no further"},
             "pupil", "pupil_l"},
    MoveInfo{"eye", Side::none, "side", -1, 1, "gaze to the character's left (+) or right (-)",
             Area::eye, {"to_left", "", "an eye turns no further"}, {"to_right", "", "an eye turns no further"},
             "pupil", "pupil_l"},
    MoveInfo{"lips", Side::none, "upper", -1, 1, "upper lip up (+) or down to the match level (-)",
             Area::lips, {"upper_up", "LIP_U_VERT_LIMIT"}, {"upper_down", "LIPS_MATCH_LEVEL"},
             "ls", "M3_0 M3_3 R:M3_3"},
    MoveInfo{"lips", Side::none, "lower", -1, 1, "lower lip up to the match level (+) or down (-)",
             Area::lips, {"lower_up", "LIPS_MATCH_LEVEL"}, {"lower_down", "LIP_D_VERT_LIMIT"},
             "li", "M3_12 M3_9 R:M3_9"},
    MoveInfo{"lips", Side::none, "press", 0, 1, "lips pressed together and rolled in",
             Area::lips, {"press", "LIPS_MATCH_LEVEL", "the lips have met"}, {},
             "ls", "M3_12 M3_0"},
    MoveInfo{"lips", Side::none, "roll", 0, 1, "both lips rolled in over the teeth",
             Area::lips, {"roll"}, {},
             "li", "M3_12 M3_0", false, true},
    MoveInfo{"lips", Side::none, "funnel", 0, 1, "both lips turned out, as a funnel",
             Area::lips, {"funnel"}, {},
             "ls", "M3_12 M3_0", false, true},
    MoveInfo{"lips", Side::none, "shut", 0, 1, "lips that stay together where the jaw opens (1)",
             Area::lips, {"shut", "", "shut is shut", "where lips meet"}, {},
             "li", "M3_12 M3_0", false, true, 0.6},
    MoveInfo{"lips", Side::none, "roll_upper", 0, 1, "the upper lip alone rolled in over its teeth",
             Area::lips, {"roll_upper"}, {},
             "ls", "M3_0 M3_3 R:M3_3", false, true},
    MoveInfo{"lips", Side::none, "roll_lower", 0, 1, "the lower lip alone rolled in over its teeth",
             Area::lips, {"roll_lower"}, {},
             "li", "M3_12 M3_9 R:M3_9", false, true},
    MoveInfo{"lips", Side::none, "pucker", 0, 1, "both lips pursed forward, shut, as for a kiss",
             Area::lips, {"pucker"}, {},
             "ls", "M3_12 M3_0", false, true},
    MoveInfo{"lips", Side::none, "shrug_upper", 0, 1, "the middle of the upper lip pushed up",
             Area::lips, {"shrug_upper"}, {},
             "ls", "M3_0 M3_3 R:M3_3", false, true},
    MoveInfo{"lips", Side::none, "shrug_lower", 0, 1, "the lower lip and the chin's skin pushed up, further than the chin alone",
             Area::lips, {"shrug_lower"}, {},
             "li", "M3_12 M3_9 R:M3_9", false, true},
    MoveInfo{"corner", Side::none, "out", -1, 1, "mouth corner outward (+) or inward (-)",
             Area::corner, {"out", "MOUTH_CORNER_@_@_HORT_LIMIT"}, {"in", "MOUTH_CORNER_@_~_HORT_LIMIT"},
             "ch", "ch_l ch_r", true},
    MoveInfo{"corner", Side::none, "up", -1, 1, "mouth corner up (+) or down (-)",
             Area::corner, {"up", "MOUTH_CORNER_@_U_VERT_LIMIT"}, {"down", "MOUTH_CORNER_@_D_VERT_LIMIT"},
             "ch", "ch_l ch_r"},
    MoveInfo{"corner", Side::none, "dimple", 0, 1, "mouth corner drawn in and back, with a dimple beside it",
             Area::corner, {"dimple"}, {},
             "ch", "ch_l ch_r", false, true},
    MoveInfo{"corner", Side::none, "lift", 0, 1, "the upper lip of this side drawn up",
             Area::corner, {"lift"}, {},
             "ch", "M3_3 R:M3_3", false, true},
    MoveInfo{"corner", Side::none, "bare", 0, 1, "the lower lip of this side drawn down",
             Area::corner, {"bare"}, {},
             "ch", "M3_9 R:M3_9", false, true},
    MoveInfo{"chin", Side::none, "down", 0, 1, "jaw open to its limit (1)",
             Area::chin, {"down", "CHIN_D_LIMIT"}, {},
             "pg", "pg M6_9 R:M6_9"},
    MoveInfo{"chin", Side::none, "up", 0, 1, "chin pushed up to the match level (1)",
             Area::chin, {"up", "LIPS_MATCH_LEVEL"}, {},
             "pg", "pg M6_9 R:M6_9"},
    MoveInfo{"chin", Side::none, "straight", 0, 1, "jaw straight down without turning, to its limit (1)",
             Area::chin, {"straight", "CHIN_D_LIMIT"}, {},
             "pg", "pg M6_9 R:M6_9"},
    MoveInfo{"tongue", Side::none, "out", 0, 1, "out between the teeth, as far as they and the lips let it (1)",
             Area::tongue, {"out", "", "a tongue is no longer"}, {},
             "tongue", "tongue", false, true},
    MoveInfo{"tongue", Side::none, "up", 0, 1, "its tip up to the ridge behind the upper teeth (1)",
             Area::tongue, {"up", "", "a tongue is no longer"}, {},
             "tongue", "tongue", false, true},
    MoveInfo{"cheek", Side::none, "puff", 0, 1, "blown up",
             Area::cheek, {"puff"}, {},
             "cheek", "cheek_l", false, true},
    MoveInfo{"cheek", Side::none, "squint", 0, 1, "drawn up under the eye",
             Area::cheek, {"squint"}, {},
             "cheek", "q11_C2", false, true},
    MoveInfo{"jaw", Side::none, "side", -1, 1, "to the character's left (+) or right (-)",
             Area::jaw, {"to_left"}, {"to_right"},
             "pg", "pg M6_9 R:M6_9", false, true},
    MoveInfo{"jaw", Side::none, "forward", 0, 1, "forward, the lower teeth before the upper ones",
             Area::jaw, {"forward"}, {},
             "pg", "pg M6_9 R:M6_9", false, true},
    MoveInfo{"mouth", Side::none, "side", -1, 1, "lips and corners to the character's left (+) or right (-)",
             Area::mouth, {"to_left"}, {"to_right"},
             "ls", "ls ch_l ch_r", false, true},
    MoveInfo{"nose", Side::none, "sneer", 0, 1, "the wing of the nose and what is beside it drawn up",
             Area::nose, {"sneer"}, {},
             "al", "al_l k_b2", false, true},
};

// clang-format on

inline constexpr std::size_t kMoveCount = [] {
  std::size_t count = 0;
  for (const MoveInfo& info : kMovesOfOneSide) count += find_area(info.of).has_sides() ? 2 : 1;
  return count;
}();

// Area by area; of an area the left side's moves, then the right one's.
inline constexpr std::array<MoveInfo, kMoveCount> kMoves = [] {
  std::array<MoveInfo, kMoveCount> moves{};
  std::size_t at = 0;
  for (const AreaInfo& area : kAreas)
    for (const Side side : {Side::none, Side::left, Side::right})
      for (const MoveInfo& info : kMovesOfOneSide)
        if (info.of == area.area && (side != Side::none) == area.has_sides()) {
          moves[at] = info;
          moves[at++].side = side;
        }
  return moves;
}();

// All numbers of a pose: the moves of the areas, then the muscles and the units of doctrines.hpp, of a pair
// the left one first.
inline constexpr std::size_t kFirstMuscle = kMoveCount, kFirstUnit = kFirstMuscle + kMuscleCount;
inline constexpr std::size_t kChannelCount = kFirstUnit + kUnitCount;

inline constexpr std::array<MoveInfo, kChannelCount> kChannels = [] {
  std::array<MoveInfo, kChannelCount> channels{};
  std::ranges::copy(kMoves, channels.begin());
  std::size_t at = kMoveCount;
  const auto add = [&](std::string_view key, const ChannelRow& row, Side side) {
    MoveInfo& info = channels[at++];
    info = {key, side, row.name, row.low, row.high, row.meaning, row.of, {"full", "", row.stop}, {}, "", ""};
    info.is_beyond = true;
    if (row.low < 0) info.minus = {"reverse", "", row.stop};
  };
  const auto add_all = [&](std::string_view key, const auto& rows) {
    for (const ChannelRow& row : rows) {
      add(key, row, row.is_sided ? Side::left : Side::none);
      if (row.is_sided) add(key, row, Side::right);
    }
  };
  add_all(kMusclesKey, kMuscleRows);
  add_all(kCandideKey, kUnitRows);
  return channels;
}();

constexpr bool is_area_move(std::size_t channel) { return channel < kMoveCount; }

// The index in kChannels of a muscle or a unit; empty if there is none such.
constexpr std::optional<std::size_t> find_channel(std::string_view key, Side side, std::string_view name) {
  for (std::size_t i = kMoveCount; i < kChannelCount; ++i)
    if (kChannels[i].area == key && kChannels[i].side == side && kChannels[i].move == name) return i;
  return std::nullopt;
}

// The same on the other side; itself without sides.
constexpr std::size_t find_twin(std::size_t channel) {
  const MoveInfo& info = kChannels[channel];
  for (std::size_t i = 0; i < kChannelCount; ++i)
    if (i != channel && kChannels[i].area == info.area && kChannels[i].move == info.move) return i;
  return channel;
}

// Whether an area is none of Tezuka's nine.
constexpr bool is_beyond(const AreaInfo& area) {
  return std::ranges::all_of(kMovesOfOneSide,
                             [&](const MoveInfo& move) { return move.of != area.area || move.is_beyond; });
}

// The index in kMoves of a move; empty if there is none such.
constexpr std::optional<std::size_t> find_move(std::string_view area, Side side, std::string_view move) {
  for (std::size_t i = 0; i < kMoveCount; ++i)
    if (kMoves[i].area == area && kMoves[i].side == side && kMoves[i].move == move) return i;
  return std::nullopt;
}
constexpr std::optional<std::size_t> find_move(Area area, Side side, std::string_view move) {
  return find_move(find_area(area).name, side, move);
}

// The key of a move's area on its own side: "brow.left", "lips".
constexpr std::string_view find_area_key(const AreaInfo& area, Side side) {
  return side == Side::none ? area.name : side == Side::left ? area.left_key : area.right_key;
}
constexpr std::string_view find_area_key(const MoveInfo& info) {
  const AreaInfo& area = find_area(info.of);
  return info.area == area.name ? find_area_key(area, info.side) : info.area;  // "muscles"
}

// Which area keys the language knows, singular and plural: "brows" sets both sides, "brow.left" one.
struct AreaKey {
  std::string_view key;
  std::string_view area;
  Side side;  // none with `is_both` false: an area without sides
  bool is_both;
};

inline constexpr std::size_t kAreaKeyCount = [] {
  std::size_t count = 0;
  for (const AreaInfo& area : kAreas) count += area.has_sides() ? 3 : 1;
  return count;
}();

inline constexpr std::array<AreaKey, kAreaKeyCount> kAreaKeys = [] {
  std::array<AreaKey, kAreaKeyCount> keys{};
  std::size_t at = 0;
  for (const AreaInfo& area : kAreas) {
    keys[at++] = {area.has_sides() ? area.plural : area.name, area.name, Side::none, area.has_sides()};
    if (!area.has_sides()) continue;
    for (const Side side : {Side::left, Side::right})
      keys[at++] = {find_area_key(area, side), area.name, side, false};
  }
  return keys;
}();

inline constexpr std::size_t kLongestAreaKey = [] {
  std::size_t longest = 0;
  for (const AreaKey& key : kAreaKeys) longest = std::max(longest, key.key.size());
  return longest;
}();

// The parts of the face come before the head in LeadPart.
inline constexpr std::size_t kFacePartCount = kAreas.size();
inline constexpr std::size_t kLeadCount = kFacePartCount + 1;

// The area that a part of the face is.
constexpr const AreaInfo& find_area(LeadPart part) {
  return *std::ranges::find(kAreas, part, [](const AreaInfo& area) { return area.lead.part; });
}

// The key of a part of `lead`: "eyes", "lips", "head".
constexpr std::string_view find_part_key(std::size_t part) {
  if (part == kFacePartCount) return "head";
  const AreaInfo& area = find_area(static_cast<LeadPart>(part));
  return area.has_sides() ? area.plural : area.name;
}

// All values at one moment, indexed as kChannels: those of the areas first, as kMoves.
struct Pose {
  std::array<double, kChannelCount> values{};

  bool operator==(const Pose&) const = default;
};

// Whether any muscle or unit is not at rest.
inline bool has_doctrine(const Pose& pose) {
  return std::ranges::any_of(pose.values.begin() + kMoveCount, pose.values.end(),
                             [](double value) { return value != 0; });
}

// What an author set: a value where the author wrote one, nothing elsewhere. A sided key has overridden a
// plural one already, whatever their order in the file.
struct AreaValues {
  std::array<std::optional<double>, kChannelCount> values{};
  std::map<std::size_t, Place> places;  // of the values past their limits
};

}  // namespace mien

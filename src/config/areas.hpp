// The nine areas of the face and their moves, as the language names them (Tezuka's areas; limits as in Yen
// 1990). Knows words and ranges only; what a move does to the skin is face/'s affair.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string_view>

#include "core/error.hpp"

namespace mien {

enum class Side { none, left, right };

// One number of a pose. Values are fractions of the area's limit on the head: 0 rest, 1 (or -1) the limit.
struct MoveInfo {
  std::string_view area;     // the key's stem: "brow", "lid", "eye", "lips", "corner", "chin"
  Side side;                 // none for lips and chin
  std::string_view move;     // "up", "out", "turn", "upper", "lower", "side", "press", "down"
  double low, high;          // the limits of the value
  std::string_view meaning;  // one line for `mien list areas`
};

inline constexpr std::array kMoves{
    MoveInfo{"brow", Side::left, "up", -1, 1, "the whole brow up (+) or down (-)"},
    MoveInfo{"brow", Side::left, "out", -1, 1, "away from (+) or toward (-) the middle of the face"},
    MoveInfo{"brow", Side::left, "turn", -1, 1, "inner end up (+) or down (-)"},
    MoveInfo{"brow", Side::right, "up", -1, 1, "the whole brow up (+) or down (-)"},
    MoveInfo{"brow", Side::right, "out", -1, 1, "away from (+) or toward (-) the middle of the face"},
    MoveInfo{"brow", Side::right, "turn", -1, 1, "inner end up (+) or down (-)"},
    MoveInfo{"lid", Side::left, "upper", -1, 1, "upper lid shut (-1), at rest (0), at its upper limit (1)"},
    MoveInfo{"lid", Side::left, "lower", 0, 1, "lower lid raised to its limit (1)"},
    MoveInfo{"lid", Side::right, "upper", -1, 1, "upper lid shut (-1), at rest (0), at its upper limit (1)"},
    MoveInfo{"lid", Side::right, "lower", 0, 1, "lower lid raised to its limit (1)"},
    MoveInfo{"eye", Side::left, "up", -1, 1, "gaze up (+) or down (-)"},
    MoveInfo{"eye", Side::left, "side", -1, 1, "gaze to the character's left (+) or right (-)"},
    MoveInfo{"eye", Side::right, "up", -1, 1, "gaze up (+) or down (-)"},
    MoveInfo{"eye", Side::right, "side", -1, 1, "gaze to the character's left (+) or right (-)"},
    MoveInfo{"lips", Side::none, "upper", -1, 1, "upper lip up (+) or down to the match level (-)"},
    MoveInfo{"lips", Side::none, "lower", -1, 1, "lower lip up to the match level (+) or down (-)"},
    MoveInfo{"lips", Side::none, "press", 0, 1, "lips pressed together and rolled in"},
    MoveInfo{"corner", Side::left, "out", -1, 1, "mouth corner outward (+) or inward (-)"},
    MoveInfo{"corner", Side::left, "up", -1, 1, "mouth corner up (+) or down (-)"},
    MoveInfo{"corner", Side::right, "out", -1, 1, "mouth corner outward (+) or inward (-)"},
    MoveInfo{"corner", Side::right, "up", -1, 1, "mouth corner up (+) or down (-)"},
    MoveInfo{"chin", Side::none, "down", 0, 1, "jaw open to its limit (1)"},
    MoveInfo{"chin", Side::none, "up", 0, 1, "chin pushed up to the match level (1)"},
};

inline constexpr std::size_t kMoveCount = kMoves.size();

// The index in kMoves of a move; empty if there is none such.
constexpr std::optional<std::size_t> find_move(std::string_view area, Side side, std::string_view move) {
  for (std::size_t i = 0; i < kMoveCount; ++i)
    if (kMoves[i].area == area && kMoves[i].side == side && kMoves[i].move == move) return i;
  return std::nullopt;
}

// Which area keys the language knows, singular and plural: "brows" sets both sides, "brow.left" one.
struct AreaKey {
  std::string_view key;
  std::string_view area;
  Side side;  // none with `is_both` false: an area without sides
  bool is_both;
};

inline constexpr std::array kAreaKeys{
    AreaKey{"brows", "brow", Side::none, true},
    AreaKey{"brow.left", "brow", Side::left, false},
    AreaKey{"brow.right", "brow", Side::right, false},
    AreaKey{"lids", "lid", Side::none, true},
    AreaKey{"lid.left", "lid", Side::left, false},
    AreaKey{"lid.right", "lid", Side::right, false},
    AreaKey{"eyes", "eye", Side::none, true},
    AreaKey{"eye.left", "eye", Side::left, false},
    AreaKey{"eye.right", "eye", Side::right, false},
    AreaKey{"lips", "lips", Side::none, false},
    AreaKey{"corners", "corner", Side::none, true},
    AreaKey{"corner.left", "corner", Side::left, false},
    AreaKey{"corner.right", "corner", Side::right, false},
    AreaKey{"chin", "chin", Side::none, false},
};

// The nine areas' values at one moment, indexed as kMoves.
struct Pose {
  std::array<double, kMoveCount> values{};

  bool operator==(const Pose&) const = default;
};

// What an author set: a value where the author wrote one, nothing elsewhere. A sided key has overridden a
// plural one already, whatever their order in the file.
struct AreaValues {
  std::array<std::optional<double>, kMoveCount> values{};
  std::map<std::size_t, Place> places;  // of the values past their limits
};

}  // namespace mien

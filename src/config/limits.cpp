#include "config/limits.hpp"

#include <fmt/format.h>
#include <array>

namespace mien {

namespace {

// `way` is the last part of the name. In `thesis`, @ stands for the viewer's side of the area and ~ for its
// other side: outward and inward are left and right there.
struct Way {
  std::string_view area, move;
  int sign;
  std::string_view way, thesis;
};

constexpr std::array kWays{
    Way{"brow", "up", 1, "up", "EYEBROW_@_U_VERT_LIMIT"},
    Way{"brow", "up", -1, "down", "EYEBROW_@_D_VERT_LIMIT"},
    Way{"brow", "out", 1, "out", "EYEBROW_@_@_HORT_LIMIT"},
    Way{"brow", "out", -1, "in", "EYEBROW_@_~_HORT_LIMIT"},
    Way{"brow", "turn", 1, "turn_up", "EYEBROW_ROTATE_RANGE"},
    Way{"brow", "turn", -1, "turn_down", "EYEBROW_ROTATE_RANGE"},
    Way{"lid", "upper", 1, "upper", "EYELID_@U_U_VERT_LIMIT"},
    Way{"lid", "lower", 1, "lower", "EYELID_@D_U_VERT_LIMIT"},
    Way{"eye", "up", 1, "up", ""},
    Way{"eye", "up", -1, "down", ""},
    Way{"eye", "side", 1, "to_left", ""},
    Way{"eye", "side", -1, "to_right", ""},
    Way{"lips", "upper", 1, "upper_up", "LIP_U_VERT_LIMIT"},
    Way{"lips", "upper", -1, "upper_down", "LIPS_MATCH_LEVEL"},
    Way{"lips", "lower", 1, "lower_up", "LIPS_MATCH_LEVEL"},
    Way{"lips", "lower", -1, "lower_down", "LIP_D_VERT_LIMIT"},
    Way{"lips", "press", 1, "press", "LIPS_MATCH_LEVEL"},
    Way{"corner", "out", 1, "out", "MOUTH_CORNER_@_@_HORT_LIMIT"},
    Way{"corner", "out", -1, "in", "MOUTH_CORNER_@_~_HORT_LIMIT"},
    Way{"corner", "up", 1, "up", "MOUTH_CORNER_@_U_VERT_LIMIT"},
    Way{"corner", "up", -1, "down", "MOUTH_CORNER_@_D_VERT_LIMIT"},
    Way{"chin", "down", 1, "down", "CHIN_D_LIMIT"},
    Way{"chin", "up", 1, "up", "LIPS_MATCH_LEVEL"},
};

// The character's left is the viewer's right.
std::string name_by_thesis(std::string_view pattern, Side side) {
  std::string name;
  for (const char c : pattern) {
    if (c == '@')
      name += side == Side::left ? 'R' : 'L';
    else if (c == '~')
      name += side == Side::left ? 'L' : 'R';
    else
      name += c;
  }
  return name;
}

std::vector<LimitName> build_limits() {
  std::vector<LimitName> limits;
  for (std::size_t i = 0; i < kMoveCount; ++i)
    for (const Way& way : kWays) {
      const MoveInfo& info = kMoves[i];
      if (way.area != info.area || way.move != info.move) continue;
      const bool is_sided = info.side != Side::none;
      const char* side = info.side == Side::left ? ".left" : ".right";
      limits.push_back({fmt::format("{}{}.{}", way.area, is_sided ? side : "", way.way),
                        is_sided ? fmt::format("{}s.{}", way.area, way.way) : "",
                        name_by_thesis(way.thesis, info.side), i, way.sign});
    }
  return limits;
}

}  // namespace

const std::vector<LimitName>& list_limits() {
  static const std::vector<LimitName> limits = build_limits();
  return limits;
}

}  // namespace mien

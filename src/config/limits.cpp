#include "config/limits.hpp"

#include <fmt/format.h>
#include <utility>

namespace mien {

namespace {

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
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    const MoveInfo& info = kMoves[i];
    const AreaInfo& area = find_area(info.of);
    for (const auto& [way, sign] : {std::pair{&info.plus, 1}, std::pair{&info.minus, -1}})
      if (way->is_limit())
        limits.push_back({fmt::format("{}.{}", find_area_key(info), way->name),
                          area.has_sides() ? fmt::format("{}.{}", area.plural, way->name) : "",
                          name_by_thesis(way->thesis, info.side), i, sign});
  }
  return limits;
}

}  // namespace

const std::vector<LimitName>& list_limits() {
  static const std::vector<LimitName> limits = build_limits();
  return limits;
}

}  // namespace mien

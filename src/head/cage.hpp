// The whole cage, made of the half head by mirroring.
#pragma once

#include <string_view>

#include "config/half_head.hpp"
#include "head/head.hpp"

namespace mien {

// The whole cage, control points not yet solved: each stands at its skin point (or at the average of its
// neighbours). Points with x = 0 are the mid-plane and stand once; the others follow as "R:name", x negated.
Cage build_cage(const HalfHead& half);

// The index of a named point of the cage. Throws RunError "the head has no point called 'NAME'".
std::uint32_t find_point(const Cage& cage, std::string_view name);

// Whether `name`, its "R:" apart, begins with `prefix`.
bool has_prefix(std::string_view name, std::string_view prefix);

// The name without its "R:".
std::string_view strip_side(std::string_view name);

}  // namespace mien

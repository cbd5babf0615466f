// Going from 0 to 1 without a corner at either end: Hermite's cubic 3t^2 - 2t^3.
#pragma once

#include <algorithm>
#include <concepts>
#include <type_traits>

namespace mien {

// Of a share t in 0..1, or of a vector of them.
template <typename T>
constexpr T smooth_share(const T& t) {
  return t * t * (T(3) - T(2) * t);
}

// 0 up to `low`, 1 from `high` on, smooth between; `low` is less than `high`. Computed in the type of `at`.
template <std::floating_point T>
constexpr T smooth_step(std::type_identity_t<T> low, std::type_identity_t<T> high, T at) {
  return smooth_share(std::clamp((at - low) / (high - low), T(0), T(1)));
}

}  // namespace mien

// Seeded numbers that are the same on every machine: the library's own distributions may differ from one
// library to the next, std::mt19937_64 does not.
#pragma once

#include <cstdint>
#include <random>

namespace mien {

inline constexpr int kMaxSeed = 1'000'000'000;  // that an author may give; from 0

// A generator of its own for each use of one seed, so that one more use changes no other.
inline std::mt19937_64 build_random(std::uint64_t seed, std::uint64_t use) {
  return std::mt19937_64(seed * 0x9E3779B97F4A7C15u + use);  // the golden ratio's bits: seeds lie far apart
}

// 0 <= u < 1.
inline double sample_uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

inline double sample_uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * sample_uniform(random);
}

// Near enough to a standard normal, never beyond +-6: the sum of twelve uniforms (Irwin and Hall, 1927).
inline double sample_normal(std::mt19937_64& random) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += sample_uniform(random);
  return sum;
}

}  // namespace mien

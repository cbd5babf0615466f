// What a tongue passes on its way out: teeth and lips as a floor and a ceiling over a grid seen from above,
// in the jaw's rest space, where the lower teeth stand still.
#pragma once

#include <array>
#include <vector>

#include "frames/tongue.hpp"

namespace mien {

// Millimetres of an adult's mouth: between the tongue and what it passes (less and the grid's steps touch),
// and before the teeth's edge, over which it comes into the lane.
inline constexpr double kTongueFree_mm = 0.6, kTongueCome_mm = 9;

// Over a grid of x and z.
struct TongueLane {
  static constexpr int kWide = 45, kLong = 72, kMiddle = kWide / 2;
  static constexpr float kNone = 1e6f;
  using Grid = std::array<float, static_cast<std::size_t>(kWide* kLong)>;
  double step = 1, begin_z = 0, along = 0.7;  // mm
  Grid floor{}, ceiling{};
  std::array<bool, kWide> is_open{};  // columns with a lip above and a lip below

  static std::size_t at(int x, int z) { return static_cast<std::size_t>(x * kLong + z); }
  // A cast is quicker than rounding, of what is above 0.
  static int find_nearest(double at) { return static_cast<int>(at + 1000.5) - 1000; }
  int find_x(double x) const { return find_nearest(x / step) + kMiddle; }
  int find_z(double z) const { return find_nearest((z - begin_z) / along); }
};

// The lane along the middle of the mouth, and what it lets through.
struct TonguePassage {
  using Line = std::array<double, TongueLane::kLong>;
  Line floor{}, ceiling{};
  Line left{}, right{};  // how wide a tongue gets so far, mm, on either side
  double way_mm = 0;     // how far the tip gets
};

// What TongueRig::lower_heights holds, of `lower`, `scale` and `tip`.
std::vector<float> measure_lower_heights(const TongueRig& rig);

// `points` is the posed cage, before the head is turned.
TongueLane build_tongue_lane(const TongueRig& rig, const Face& face, const glm::dmat4& into_jaw,
                             const std::vector<glm::dvec3>& points);
TonguePassage build_tongue_passage(const TongueRig& rig, const TongueLane& lane);

// Between the grid's places, at the nearest of its ends beyond.
double sample_tongue_lane(const TongueLane& lane, const TongueLane::Grid& of, double x, double z);
double sample_tongue_lane(const TongueLane& lane, const TonguePassage::Line& of, double z);

}  // namespace mien

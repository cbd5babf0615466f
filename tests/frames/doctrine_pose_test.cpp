// Faces by muscles and by units are as sound as the areas' contacts can keep them. What they do worse than
// areas is stated here by number, so that it cannot get worse unseen.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <string_view>

#include "frames/pose_sweep.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

// The bounds of the areas' sweep, but for these.
using Bounds = std::map<std::string_view, double>;

void expect_sound(std::string_view doctrine, const Bounds& others) {
  constexpr unsigned kFirst = 1, kPoses = 60;
  const SweepTable table = run_doctrine_sweep(doctrine, kFirst, kPoses);
  for (std::size_t check = 0; check < kPoseCheckCount; ++check) {
    const SweepWorst& worst = table[check];
    const auto other = others.find(kPoseChecks[check].name);
    const double bound = other == others.end() ? kPoseChecks[check].bound : other->second;
    EXPECT_LE(worst.finding.value, bound)
        << kPoseChecks[check].name << ", " << kPoseChecks[check].unit << ", " << worst.count << " poses; "
        << list_doctrine_heads()[worst.head].name << ", seed " << worst.seed << ", at " << worst.place << ": "
        << describe_pose(build_doctrine_pose(doctrine, worst.seed));
  }
}

// A lip that three muscles of a digitised head lift at once turns over beside the nose, and shows a tooth's
// corner.
TEST(doctrine_pose, holds_nearly_every_check_by_muscles) {
  expect_sound(kMusclesKey, {{"turned over", 40}, {"upper teeth through", 0.15}});
}

// Units that are reversed and add up past what skin has room for: nothing in the model keeps them apart.
TEST(doctrine_pose, turns_lips_over_by_units) {
  expect_sound(kCandideKey, {{"turned over", 150}, {"lips crossed", 0.7}});
}

TEST(doctrine_pose, leaves_the_resting_face_to_the_last_bit) {
  const Figure figure = build_figure(shipped().heads, HeadSpec{});
  DeformBuffers buffers;
  buffers.has_folds = false;
  Drawing before, after;
  deform_figure(figure, Pose{}, TurnKey{}, buffers, before);
  deform_figure(figure, build_doctrine_pose(kMusclesKey, 5), TurnKey{}, buffers, after);
  deform_figure(figure, Pose{}, TurnKey{}, buffers, after);
  EXPECT_EQ(before.parts.front().positions, after.parts.front().positions);
  EXPECT_EQ(before.parts.front().positions, figure.model.parts.front().rest.positions);
}

}  // namespace
}  // namespace mien

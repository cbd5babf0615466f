// The posed face is sound on heads of all kinds in poses of all kinds. The suite takes a few poses a head;
// `./run bench poses` takes hundreds. A failure names head, pose and place.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <string_view>

#include "core/data.hpp"
#include "frames/pose_sweep.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

constexpr unsigned kFirst = 1, kPoses = 16, kExaggerated = 4;

const SweepTable& sweep(bool is_exaggerated) {
  static const std::array tables = [] {
    return run_sweep(list_sweep_indices(false), kFirst, {kPoses, kExaggerated});
  }();
  return tables[is_exaggerated ? 1 : 0];
}

void expect_sound(std::size_t check) {
  for (const bool is_exaggerated : {false, true}) {
    const SweepWorst& worst = sweep(is_exaggerated)[check];
    const std::string name =
        fmt::format("{}{}", kPoseChecks[check].name, is_exaggerated ? ", exaggerated" : "");
    ::testing::Test::RecordProperty(name, std::to_string(worst.finding.value));
    EXPECT_LE(worst.finding.value, kPoseChecks[check].bound)
        << name << ", " << kPoseChecks[check].unit << ", " << worst.count << " poses; "
        << list_sweep_heads()[worst.head].name << ", seed " << worst.seed << ", at " << worst.place << ": "
        << describe_pose(build_sweep_pose(worst.seed, is_exaggerated));
  }
}

TEST(sound_pose, holds_every_check_on_every_head) {
  for (std::size_t check = 0; check < kPoseCheckCount; ++check) expect_sound(check);
}

// Drawn heads: the same but for a few triangles that their lips and the hood, which go much further, turn
// over.
TEST(sound_pose, holds_on_drawn_heads) {
  constexpr double kTurned = 45;  // of 53,376
  const std::array tables = run_sweep(list_sweep_indices(true), kFirst, {kPoses, kExaggerated});
  for (std::size_t check = 0; check < kPoseCheckCount; ++check)
    for (const bool is_exaggerated : {false, true}) {
      const bool is_turned = std::string_view(kPoseChecks[check].name) == "turned over";
      const double bound = is_turned ? kTurned : kPoseChecks[check].bound;
      const SweepWorst& worst = tables[is_exaggerated ? 1 : 0][check];
      EXPECT_LE(worst.finding.value, bound)
          << kPoseChecks[check].name << "; " << list_sweep_heads()[worst.head].name << ", seed " << worst.seed
          << ", at " << worst.place << ": " << describe_pose(build_sweep_pose(worst.seed, is_exaggerated));
    }
}

TEST(sound_pose, holds_on_faces_that_speak) {
  const SweepTable table = run_speech_sweep(kFirst, 150);
  for (std::size_t check = 0; check < kPoseCheckCount; ++check) {
    const SweepWorst& worst = table[check];
    RecordProperty(std::string(kPoseChecks[check].name) + ", speaking", std::to_string(worst.finding.value));
    EXPECT_LE(worst.finding.value, kPoseChecks[check].bound)
        << kPoseChecks[check].name << ", " << worst.count << " poses; "
        << list_speech_heads()[worst.head].name << ", seed " << worst.seed << ", at " << worst.place << ": "
        << describe_pose(build_speech_pose(worst.seed));
  }
}

// The measures themselves: what is moved out of its place is found there.
TEST(sound_pose, sees_teeth_that_are_moved_through_the_lips) {
  Figure figure = build_figure(shipped().heads, HeadSpec{});
  for (Part& part : figure.model.parts)
    if (part.name == "teeth_lower")
      for (glm::vec3& p : part.rest.positions) p.z += 14;
  DeformBuffers buffers;
  Drawing drawing;
  const PoseFindings found = measure_pose(build_pose_probe(figure), Pose{}, buffers, drawing);
  for (std::size_t check = 0; check < kPoseCheckCount; ++check)
    if (std::string(kPoseChecks[check].name) == "lower teeth through") {
      EXPECT_GT(found[check].value, 1);
    } else {
      EXPECT_LE(found[check].value, kPoseChecks[check].bound) << kPoseChecks[check].name;
    }
}

}  // namespace
}  // namespace mien

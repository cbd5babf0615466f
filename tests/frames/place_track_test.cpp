// Actors who walk, enter and leave.
#include <gtest/gtest.h>

#include "config/load_spec.hpp"
#include "shipped.hpp"
#include "timeline/drawings.hpp"
#include "timeline/performance.hpp"

namespace mien {
namespace {

// The thesis's worked example of section 2.3.1, as somebody's way over the stage.
constexpr const char* kFlight = R"(mien: 1
actors:
  ann:
    place:
      - {at: 0s, to: [-3000mm, 0, 2000mm]}
      - {at: 1s, to: [-2000mm, -2000mm, 3000mm], turn: 90deg, between: spline}
      - {at: 2s, to: [0, -3000mm, 2000mm], between: spline}
      - {at: 5s, to: [2000mm, 1400mm, -2200mm], between: spline}
      - {at: 8s, to: [3000mm, 3000mm, -3000mm], between: spline}
  bob: {place: {at: [100mm, 0, 0]}, from: 1s, to: 3s}
)";

Spec load(const std::string& text) { return load_spec("walk.yaml", text, *shipped().stock.language); }

std::string tell(const std::string& text) {
  try {
    load(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

PlaceKey find_place_at(const ClipSpec& clip, double time_s) {
  return *sample_performance(build_performance(clip), time_s).place;
}

TEST(place_track, follows_the_spline_of_the_worked_example) {
  const Spec spec = load(kFlight);
  EXPECT_EQ(spec.clip.length_s, 8);
  const ClipSpec& clip = spec.actors[0].clip;
  EXPECT_EQ(find_place_at(clip, 0).to_mm, glm::dvec3(-3000, 0, 2000));
  EXPECT_EQ(find_place_at(clip, 2).to_mm, glm::dvec3(0, -3000, 2000));
  EXPECT_EQ(find_place_at(clip, 2).turn_deg, 90);
  EXPECT_EQ(find_place_at(clip, 8).to_mm, glm::dvec3(3000, 3000, -3000));
  // Smooth across a key: the same speed from both sides, and no acceleration at the ends.
  constexpr double kStep_s = 0.01;
  const auto at = [&](double time_s) { return find_place_at(clip, time_s).to_mm; };
  for (const double key_s : {1.0, 2.0, 5.0}) {
    const glm::dvec3 before = (at(key_s) - at(key_s - kStep_s)) / kStep_s,
                     after = (at(key_s + kStep_s) - at(key_s)) / kStep_s;
    EXPECT_LT(glm::distance(before, after), 60) << key_s;
    EXPECT_GT(glm::length(after), 500) << key_s;
  }
  const glm::dvec3 bend = at(0) - 2.0 * at(kStep_s) + at(2 * kStep_s);
  EXPECT_LT(glm::length(bend) / (kStep_s * kStep_s), 100);
}

TEST(place_track, actors_enter_and_leave) {
  const Spec spec = load(kFlight);
  const Performance bob = build_performance(spec.actors[1].clip);
  EXPECT_FALSE(sample_performance(bob, 0.99).is_there);
  EXPECT_TRUE(sample_performance(bob, 1).is_there);
  EXPECT_TRUE(sample_performance(bob, 2.99).is_there);
  EXPECT_FALSE(sample_performance(bob, 3).is_there);
  EXPECT_TRUE(sample_performance(build_performance(spec.actors[0].clip), 0).is_there);
  // Whatever somebody does who is not there, it is one drawing.
  ClipSpec clip = spec.actors[1].clip;
  clip.keys.resize(1);
  const std::vector<std::string> keys = list_drawing_keys(build_performance(clip));
  EXPECT_EQ(keys.front(), keys.back());
  EXPECT_NE(keys.front(), keys[static_cast<std::size_t>(clip.fps) * 2]);
}

TEST(place_track, says_what_is_wrong) {
  EXPECT_NE(
      tell("mien: 1\nactors: {ann: {from: 2s, to: 1s}}\n")
          .find("walk.yaml:2:30: error: the actor leaves at 1s and enters at 2s; expected a later 'to'"),
      std::string::npos)
      << tell("mien: 1\nactors: {ann: {from: 2s, to: 1s}}\n");
  EXPECT_NE(tell("mien: 1\nactors: {ann: {place: [{at: 1s}, {at: 0s}]}}\n").find("error:"),
            std::string::npos);
}

}  // namespace
}  // namespace mien

// Laws of camera, turn, light and place: what they come to upon the keys.
#include "timeline/track_laws.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "config/config_fixture.hpp"
#include "config/law_numbers.hpp"
#include "timeline/drawings.hpp"
#include "timeline/parts.hpp"
#include "timeline/performance.hpp"
#include "timeline/stage_track.hpp"

namespace mien {
namespace {

ClipSpec load_laws_of(const std::string& laws, const std::string& more = "") {
  return load_text("mien: 1\nclip:\n  length: 4s\n" + more + "  laws:\n" + laws).clip;
}

Moment sample_at(const ClipSpec& clip, double time_s) {
  return sample_performance(build_performance(clip), time_s);
}

TEST(track_laws, move_what_no_key_moves) {
  const ClipSpec clip = load_laws_of(R"Y(    - {camera: angle, value: "20*sin(t)"}
    - {camera: distance, value: "1 + t/10"}
    - {camera: lens, value: "50 + t"}
    - {turn: nod, value: "-4*t"}
    - {turn: turn, value: 12deg}
    - {light: brightness, value: "t/4"}
    - {light: angle, value: "-10*t"}
)Y");
  for (const double t : {0.0, 0.7, 1.3, 3.5}) {
    const Moment moment = sample_at(clip, t);
    EXPECT_EQ(moment.camera.angle_deg, 20 * std::sin(t));
    EXPECT_EQ(moment.camera.height_deg, 0);
    EXPECT_EQ(moment.camera.distance, 1 + t / 10);
    EXPECT_EQ(moment.turn.nod_deg, -4 * t);
    EXPECT_EQ(moment.turn.turn_deg, 12);
    EXPECT_EQ(moment.turn.tilt_deg, 0);
    const StageMoment stage = sample_stage(clip, t);
    EXPECT_EQ(stage.lens_mm, 50 + t);
    ASSERT_EQ(stage.lights.size(), 1u);
    EXPECT_EQ(stage.lights[0].set, "studio");
    EXPECT_EQ(stage.lights[0].bright, t / 4);
    EXPECT_EQ(stage.lights[0].angle_deg, -10 * t);
  }
}

TEST(track_laws, lie_upon_the_keys_by_their_rule) {
  constexpr const char* kKeys =
      "  turn: [{at: 0s}, {at: 4s, nod: 20deg, ease: linear}]\n"
      "  camera: [{at: 0s, distance: 2}]\n";
  const auto nod = [&](const std::string& law, double t) {
    return sample_at(load_laws_of("    - {turn: nod, " + law + "}\n", kKeys), t).turn.nod_deg;
  };
  EXPECT_EQ(nod("value: \"t\"", 2), 2);
  EXPECT_EQ(nod("value: \"t\", rule: add", 2), 12);
  EXPECT_EQ(nod("value: \"8\", rule: max", 2), 10);
  EXPECT_EQ(nod("value: \"12\", rule: max", 2), 12);
  EXPECT_EQ(nod("value: \"-3\", rule: max", 2), 7) << "the furthest of each way";
  EXPECT_EQ(nod("value: \"t\", rule: share", 2), 2) << "alone it has all";
  EXPECT_EQ(nod("value: \"30*t\", range: [0, 15deg]", 2), 15);
  EXPECT_EQ(nod("value: \"30*t\", rule: add", 2), kMaxNod_deg) << "what a neck can do";
  EXPECT_EQ(nod("value: \"t\", from: 1s, to: 3s", 0.5), 2.5);
  EXPECT_EQ(nod("value: \"t\", from: 1s, to: 3s", 1), 1) << "at once";
  EXPECT_EQ(nod("value: \"t\", from: 1s, to: 3s", 3), 15) << "and gone at once";
  EXPECT_EQ(nod("value: \"0\", from: 1s, to: 3s, attack: 0.5s", 1.25), 3.125) << "half of it is there";
  EXPECT_EQ(nod("value: \"0\", from: 1s, to: 3s, release: 0.5s", 2.75), 6.875);
  const auto distance = [&](const std::string& law) {
    return sample_at(load_laws_of("    - {camera: distance, " + law + "}\n", kKeys), 1).camera.distance;
  };
  EXPECT_EQ(distance("value: 0.5, rule: add"), 2.5);
  EXPECT_EQ(distance("value: 0.5, rule: max"), 1.5) << "1 is rest: further by 1 and nearer by 0.5";
}

TEST(track_laws, share_a_number_by_their_weights_and_follow_each_other_without_the_keys_between) {
  const ClipSpec shared = load_laws_of(R"Y(    - {turn: turn, value: 10deg, rule: share}
    - {turn: turn, value: 20deg, rule: share, from: 2s}
)Y");
  EXPECT_EQ(sample_at(shared, 1).turn.turn_deg, 10);
  EXPECT_EQ(sample_at(shared, 3).turn.turn_deg, 15);
  // The first one goes while the second one comes: what is seen lies between them, and never nearer to rest.
  const ClipSpec row = load_laws_of(R"Y(    - {turn: turn, value: 20deg, from: 0s, to: 2s, release: 0.5s}
    - {turn: turn, value: 20deg, from: 1.5s, attack: 0.5s}
    - {turn: nod, value: 20deg, from: 0s, to: 2s, release: 0.5s}
)Y");
  for (double t = 0; t < 4; t += 0.0625) EXPECT_EQ(sample_at(row, t).turn.turn_deg, 20) << t;
  EXPECT_EQ(sample_at(row, 1.75).turn.nod_deg, 10) << "another number is not held by it";
  EXPECT_EQ(compute_law_weight(row.laws, row.laws[0], compute_ticks(1.75)), 1);
}

TEST(track_laws, of_turn_lie_upon_scripts_and_stand_in_them) {
  const ClipSpec clip = load_text(R"Y(mien: 1
clip:
  length: 4s
  scripts:
    sway: {length: 2s, laws: [{turn: tilt, value: "5*t"}, {turn: nod, value: "t"}]}
  cues: [{from: 1s, play: sway, attack: 0s, release: 0s}]
  laws: [{turn: nod, value: "3", rule: add}]
)Y")
                            .clip;
  EXPECT_EQ(sample_at(clip, 0.5).turn.nod_deg, 3);
  EXPECT_EQ(sample_at(clip, 2).turn.tilt_deg, 5);
  EXPECT_EQ(sample_at(clip, 2).turn.nod_deg, 4);
}

TEST(track_laws, of_light_are_upon_both_sets_of_a_fade) {
  const ClipSpec clip =
      load_laws_of("    - {light: brightness, value: 0.5}\n",
                   "  light: [{at: 0s}, {at: 4s, set: moon, brightness: 2, ease: linear}]\n");
  const StageMoment moment = sample_stage(clip, 1);
  ASSERT_EQ(moment.lights.size(), 2u);
  EXPECT_EQ(moment.lights[0].bright, 0.75 * 0.5);
  EXPECT_EQ(moment.lights[1].bright, 0.25 * 0.5);
  const ClipSpec more =
      load_laws_of("    - {light: brightness, value: \"t\", rule: add}\n",
                   "  light: [{at: 0s, set: moon}, {at: 4s, brightness: 2, ease: linear}]\n");
  EXPECT_EQ(sample_stage(more, 0.5).lights[0].bright, 1.125 + 0.5);
  EXPECT_EQ(sample_stage(more, 3).lights[0].bright, kMostBrightness) << "no light is brighter";
}

TEST(track_laws, of_actors_move_them_and_everybodys_camera) {
  const Spec spec = load_text(R"Y(mien: 1
actors:
  ann:
    place: {at: [-100mm, 0, 20mm], turn: 30deg}
    clip:
      gaze: [{at: 0s, look: camera}]
      laws:
        - {place: x, value: "50*t", rule: add}
        - {place: turn, value: "10*t"}
        - {turn: nod, value: "t"}
  bob: {place: {at: [100mm, 0, 0]}}
clip:
  length: 2s
  inputs: {far: 40}
  camera: [{at: 0s, angle: 5deg}]
  laws:
    - {camera: angle, value: "far*t"}
    - {camera: height, value: "t", rule: add}
    - {light: angle, value: "far*t"}
)Y");
  const Moment ann = sample_at(spec.actors[0].clip, 1);
  ASSERT_TRUE(ann.place.has_value());
  EXPECT_EQ(ann.place->to_mm, glm::dvec3(-50, 0, 20));
  EXPECT_EQ(ann.place->turn_deg, 10);
  EXPECT_EQ(ann.turn.nod_deg, 1);
  EXPECT_FALSE(sample_at(spec.actors[1].clip, 1).place.has_value());
  EXPECT_EQ(sample_at(spec.clip, 1).camera.angle_deg, 40);
  EXPECT_EQ(ann.camera.angle_deg, 10) << "as one sees it who is turned by 30";
  EXPECT_EQ(ann.camera.height_deg, 1);
  EXPECT_EQ(sample_stage(spec.clip, 1).lights[0].angle_deg, 40);
  EXPECT_EQ(spec.clip.length_s, 2);
}

TEST(track_laws, make_drawings_differ_and_are_told_with_what_a_moment_is_made_of) {
  const ClipSpec still = load_text("mien: 1\nclip: {length: 1s}\n").clip;
  EXPECT_EQ(compute_drawings(build_performance(still)).back(), 0);
  for (const char* law : {"{camera: angle, value: \"t\"}", "{camera: lens, value: \"50 + t\"}",
                          "{turn: tilt, value: \"t\"}", "{light: brightness, value: \"t\"}"}) {
    const ClipSpec clip = load_text(fmt::format("mien: 1\nclip: {{length: 1s, laws: [{}]}}\n", law)).clip;
    EXPECT_EQ(compute_drawings(build_performance(clip)).back(), 23) << law;
    const std::vector<MomentPart> parts = list_parts(build_performance(clip), 0.5);
    ASSERT_EQ(parts.size(), 2u) << law;
    EXPECT_EQ(parts[1].label, clip.laws[0].label);
    EXPECT_TRUE(parts[1].is_cue);
  }
}

TEST(track_laws, last_until_they_end_and_count_as_others_do) {
  EXPECT_EQ(load_text("mien: 1\nclip: {laws: [{turn: nod, value: \"t\", to: 3s}]}\n").clip.length_s, 3);
  std::string text = "mien: 1\nclip:\n  length: 1s\n  laws:\n";
  for (int i = 0; i < 201; ++i) text += "    - {turn: nod, value: \"t\"}\n";
  EXPECT_EQ(find_text_mistakes(text),
            "test.yaml:205:7: error: more than 200 laws of camera, turn, light and place; expected fewer\n"
            "      - {turn: nod, value: \"t\"}\n"
            "        ^");
}

// Whatever they are, every number stays within what an author may write, and one law that is all there is its
// formula.
TEST(track_laws, stay_within_their_bounds) {
  std::mt19937_64 random(7);
  constexpr std::array<const char*, 4> kSomeRules{"over", "add", "max", "share"};
  for (int round = 0; round < 60; ++round) {
    std::string laws;
    const auto count = 1 + random() % 6;
    for (std::size_t i = 0; i < count; ++i) {
      const LawNumber& number = kLawNumbers[random() % 9];  // no place: there are no actors
      const double from = static_cast<double>(random() % 30) / 10;
      laws += fmt::format(
          "    - {{{}: {}, value: \"{}*sin({}*t) + {}\", from: {}, to: {}, attack: {}, release: {}, rule: "
          "{}}}\n",
          kLawTracks[static_cast<std::size_t>(number.track)], number.name, random() % 500, random() % 9,
          random() % 100, from, from + 0.3 + static_cast<double>(random() % 20) / 10,
          static_cast<double>(random() % 10) / 10, static_cast<double>(random() % 10) / 10,
          kSomeRules[random() % 4]);
    }
    const ClipSpec clip = load_laws_of(laws);
    const Performance performance = build_performance(clip);
    for (double t = 0; t < 4; t += 0.05) {
      const Moment moment = sample_performance(performance, t);
      const StageMoment stage = sample_stage(clip, t);
      const auto is_within = [](double value, const Bounds& bounds) {
        return value >= bounds.low && value <= bounds.high;
      };
      EXPECT_TRUE(is_within(moment.camera.angle_deg, kCameraBounds[0])) << laws;
      EXPECT_TRUE(is_within(moment.camera.height_deg, kCameraBounds[1])) << laws;
      EXPECT_TRUE(is_within(moment.camera.distance, kCameraBounds[2])) << laws;
      EXPECT_TRUE(is_within(stage.lens_mm, {kShortestLens_mm, kLongestLens_mm})) << laws;
      EXPECT_TRUE(is_within(moment.turn.turn_deg, kTurnBounds[0])) << laws;
      EXPECT_TRUE(is_within(moment.turn.nod_deg, kTurnBounds[1])) << laws;
      EXPECT_TRUE(is_within(moment.turn.tilt_deg, kTurnBounds[2])) << laws;
      for (const LightShare& light : stage.lights)
        EXPECT_TRUE(is_within(light.bright, {0, kMostBrightness})) << laws;
    }
    for (const TrackLaw& law : clip.laws)
      for (double t = 0; t < 4; t += 0.05) {
        const double weight = compute_law_weight(clip.laws, law, compute_ticks(t));
        EXPECT_TRUE(weight >= 0 && weight <= 1) << laws;
      }
  }
}

}  // namespace
}  // namespace mien

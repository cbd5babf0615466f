// Formulas wherever a number stands: what they know, what they come to, and what is told of those that are
// wrong.
#include "config/constants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "config/config_fixture.hpp"
#include "config/edit.hpp"

namespace mien {
namespace {

TEST(constants, stand_wherever_a_number_or_a_quantity_stands) {
  const Spec spec = load_text(R"Y(mien: 1
head:
  age: {child: "w", adult: "3*w"}
  character: "w - 1/2"
  guides: {eye_line: "0.48 + w/100"}
  features: {nose_length: "sin(pi/6)"}
  limits: {brow.left.up: "2*w", LIPS_MATCH_LEVEL: -1mm}
  look: {freckles: "w"}
  sculpt: [{at: chin, move: [0, "-8*w", "12*w"], radius: "40*w", scale: "1 + w/5"}]
exaggerate: "1 + w"
expressions:
  sly: {from: smile, attack: "w/2", brow.left: {up: "3*w"}}
clip:
  fps: "5*6"
  length: "bars*2"
  draw: "fps/15"
  inputs: {w: 0.25, bars: 3, beat: "runtime/12"}
  keys:
    - {at: 0s}
    - {at: "beat*3", express: smile, exaggerate: "1.2", ease: ["w", 0, "1 - w", 1], release: {brows: "beat/2"}}
    - {at: "runtime/2", express: anger, strength: "2*w", areas: {lips: {press: "w"}}}
  camera: [{at: 0s, angle: "80*w", distance: "4*w", lens: "400*w", look_at: ["100*w", 0, "-w"]}]
  turn: [{at: "fps/30", nod: "20*w"}]
  light: [{at: "2*beat", set: moon, brightness: "2*w", angle: "-40*w"}]
  blink: {per_minute: "60*w", seed: "fps"}
  blinks: ["beat", "5*beat"]
  gaze: [{at: "w", look: {side: "100*w", up: "-20*w"}}, {at: "8*w", look: ["400*w", 0, "2000*w"]}]
  drift: "2*w"
  asymmetry: {amount: "w", seed: "bars"}
  cues:
    - {from: "runtime/2", express: sly, attack: "0.1*runtime", hold: "beat", release: "beat/4", strength: "w*3"}
    - {from: "runtime - 1", play: nod_yes, repeat: "bars - 1", with: {depth: "40*w"}}
  scripts:
    nod_yes:
      length: "depth/20"
      parameters: {depth: 6}
      turn: [{at: 0s}, {at: "runtime/2", nod: "depth*runtime"}]
  laws: [{area: chin, move: down, value: 0.1, from: "beat", to: "7*beat", attack: "beat", range: ["w/5", "w"]}]
  head: [{at: "beat", features: {nose_length: "w"}}]
render: {size: "480*w x 640*w"}
busts: [{express: smile, height: "200*w", strength: "2*w"}]
)Y");
  EXPECT_EQ(spec.head.age, (Mix{{"child", 0.25}, {"adult", 0.75}}));
  EXPECT_EQ(spec.head.character, -0.25);
  EXPECT_EQ(spec.head.guides.at("eye_line"), 0.48 + 0.25 / 100);
  EXPECT_EQ(spec.head.features.at("nose_length"), std::sin(std::numbers::pi / 6));
  EXPECT_EQ(spec.head.limits.at("brow.left.up"), 0.5);
  EXPECT_EQ(spec.head.look.freckles, 0.25);
  ASSERT_EQ(spec.head.sculpt.size(), 1u);
  EXPECT_EQ(spec.head.sculpt[0].move_mm, glm::dvec3(0, -2, 3));
  EXPECT_EQ(spec.head.sculpt[0].radius_mm, 10);
  EXPECT_EQ(spec.head.sculpt[0].scale, 1.05);
  EXPECT_EQ(spec.exaggerate, 1.25);
  const Expression& sly = find_expression(spec, "sly");
  EXPECT_EQ(find_value(sly.pose, "brow", Side::left, "up"), 0.75);
  const ClipSpec& clip = spec.clip;
  EXPECT_EQ(clip.fps, 30);
  EXPECT_EQ(clip.draw, 2);
  EXPECT_EQ(clip.length_s, 6);
  EXPECT_EQ(clip.keys[1].at_s, 1.5);
  EXPECT_EQ(clip.keys[1].ease.handles, (std::array<double, 4>{0.25, 0, 0.75, 1}));
  const auto brows = std::ranges::find(kReleaseKeys, "brows") - kReleaseKeys.begin();
  EXPECT_EQ(clip.keys[1].release[static_cast<std::size_t>(brows)], 0.25);
  EXPECT_EQ(clip.keys[2].at_s, 3);
  EXPECT_EQ(find_value(clip.keys[2].pose, "lips", Side::none, "press"), 0.3125) << "1.25 times as far";
  EXPECT_EQ(clip.camera[0].angle_deg, 20);
  EXPECT_EQ(clip.camera[0].lens_mm, 100);
  EXPECT_EQ(clip.camera[0].aim.point_mm, glm::dvec3(25, 0, -0.25));
  EXPECT_EQ(clip.turn[0].at_s, 1);
  EXPECT_EQ(clip.turn[0].nod_deg, 5);
  EXPECT_EQ(clip.light[0].at_s, 1);
  EXPECT_EQ(clip.light[0].brightness, 0.5);
  EXPECT_EQ(clip.light[0].angle_deg, -10);
  EXPECT_EQ(clip.blink.per_minute, 15);
  EXPECT_EQ(clip.blink.seed, 30u);
  EXPECT_EQ(clip.blinks_s, (std::vector<double>{0.5, 2.5}));
  EXPECT_EQ(clip.gaze.keys[0].side_deg, 25);
  EXPECT_EQ(clip.gaze.keys[1].point_mm, glm::dvec3(100, 0, 500));
  EXPECT_EQ(clip.drift.amount, 0.5);
  EXPECT_EQ(clip.asymmetry.amount, 0.25);
  EXPECT_EQ(clip.asymmetry.seed, 3u);
  ASSERT_EQ(clip.cues.size(), 3u);
  EXPECT_EQ(clip.cues[0].from_s, 3);
  EXPECT_EQ(clip.cues[0].full_s, 3.6);
  EXPECT_EQ(clip.cues[0].ebb_s, 4.1);
  EXPECT_EQ(clip.cues[0].end_s, 4.225);
  EXPECT_EQ(clip.cues[1].from_s, 5);
  EXPECT_EQ(clip.cues[1].script->length_s, 0.5) << "of the depth that the cue gives";
  EXPECT_EQ(clip.cues[1].script->turn[1].at_s, 0.25) << "a script's runtime is its own length";
  EXPECT_EQ(clip.cues[1].script->turn[1].nod_deg, 5);
  EXPECT_EQ(clip.cues[1].ebb_s, 6);
  EXPECT_EQ(clip.cues[2].from_s, 0.5);
  EXPECT_EQ(clip.cues[2].full_s, 1);
  EXPECT_EQ(clip.cues[2].end_s, 3.5);
  EXPECT_EQ(clip.head[0].head.features.at("nose_length"), 0.25);
  EXPECT_EQ(spec.render.width_px, 120);
  EXPECT_EQ(spec.render.height_px, 160);
  EXPECT_EQ(spec.busts[0].height_mm, 50);
}

TEST(constants, runtime_is_the_length_that_other_times_come_to) {
  const Spec spec = load_text(R"Y(mien: 1
clip:
  inputs: {half: "runtime/2"}
  keys: [{at: 0s}, {at: "half", express: smile}, {at: 4s, express: anger, strength: "t/runtime"}]
  cues: [{from: "runtime - 1", express: surprise, hold: "0.1*runtime", attack: "0.1", release: "0.1"}]
)Y");
  EXPECT_EQ(spec.clip.length_s, 4);
  EXPECT_EQ(spec.clip.keys[1].at_s, 2);
  EXPECT_EQ(spec.clip.cues[0].from_s, 3);
  EXPECT_EQ(evaluate(spec.clip.keys[2].live->strength, 3), 0.75);
  // Numbers alone may ask, too, as may formulas of time: only the numbers come after the length.
  EXPECT_EQ(load_text("mien: 1\nhead: {features: {nose_length: \"runtime/10\"}}\nclip: {keys: [{at: 5s}]}\n")
                .head.features.at("nose_length"),
            0.5);
}

TEST(constants, of_actors_know_their_own_inputs_and_everybodys) {
  const Spec spec = load_text(R"Y(mien: 1
actors:
  ann:
    head: {features: {nose_length: "mine*all"}}
    place: {at: ["-300*all", 0, 0], turn: "10*mine"}
    clip:
      inputs: {mine: 2}
      keys: [{at: "mine", express: smile, name: smiled}, {at: "runtime", express: anger}]
  bob:
    from: "all"
    clip:
      inputs: {mine: 3}
      keys: [{at: {after: ann.smiled, delay: "all"}, express: surprise}]
clip:
  length: 6s
  inputs: {all: 0.25}
  camera: [{at: 0s, angle: "40*all"}, {at: 1s, angle: "40*all*t"}]
)Y");
  EXPECT_EQ(spec.actors[0].head.features.at("nose_length"), 0.5);
  EXPECT_EQ(spec.actors[0].place.at_mm.x, -75);
  EXPECT_EQ(spec.actors[0].place.turn_deg, 20);
  EXPECT_EQ(spec.actors[0].clip.keys[0].at_s, 2);
  EXPECT_EQ(spec.actors[0].clip.keys[1].at_s, 6);
  EXPECT_EQ(spec.actors[1].clip.enters_s, 0.25);
  EXPECT_EQ(spec.actors[1].clip.keys[0].at_s, 2.25);
  EXPECT_EQ(spec.clip.camera[0].angle_deg, 10);
  EXPECT_EQ(spec.clip.camera[1].angle_deg, 10);
}

TEST(constants, of_other_files_know_what_is_theirs) {
  const auto folder = make_test_folder();
  write_file(folder / "nose.yaml",
             "mien: 1\nhead: {features: {nose_length: \"long\"}}\nclip: {length: 2s, inputs: {long: "
             "\"runtime/4\"}}\n");
  write_file(
      folder / "wave.yaml",
      "mien: 1\nclip:\n  fps: 10\n  length: 9s\n  inputs: {size: 0.5}\n  cues: [{from: \"size\", express: "
      "smile, attack: \"fps/100\", hold: \"runtime/8\", release: 0s}]\n");
  write_file(
      folder / "a.yaml",
      "mien: 1\nhead: {mix: {nose.yaml: \"fps/24\"}}\nclip:\n  length: 4s\n  include: {file: wave.yaml, at: "
      "\"runtime/4\"}\n  inputs: {twice: \"2*size\"}\n  turn: [{at: \"twice\", nod: 2deg}]\n");
  const Spec spec = load_spec(folder / "a.yaml", *find_language());
  EXPECT_EQ(spec.head.mix[0].head.features.at("nose_length"), 0.5);
  EXPECT_EQ(spec.clip.cues[0].from_s, 1.5);
  EXPECT_EQ(spec.clip.cues[0].full_s, 1.6);
  EXPECT_EQ(spec.clip.cues[0].ebb_s, 2.1) << "runtime is the clip's that is played";
  EXPECT_EQ(spec.clip.turn[0].at_s, 1);
  // Outside of the clip only the file's own are known.
  write_file(
      folder / "b.yaml",
      "mien: 1\nhead: {features: {nose_length: \"twice\"}}\nclip:\n  include: wave.yaml\n  inputs: {twice: "
      "\"2*size\"}\n  keys: [{at: \"twice\", name: late}]\n  turn: [{at: {after: late}}]\n");
  EXPECT_EQ(find_mistakes(folder / "b.yaml"),
            "b.yaml:2:33: error: in the formula of 'head.features.nose_length': 'twice' is not known here\n"
            "  head: {features: {nose_length: \"twice\"}}\n"
            "                                  ^\n"
            "b.yaml:7:23: error: the time of 'late' is a formula that is not known here; expected one of the "
            "file's own inputs\n"
            "    turn: [{at: {after: late}}]\n"
            "                        ^");
}

TEST(constants, are_no_quantities_in_quotes) {
  const ClipSpec clip =
      load_text(
          "mien: 1\nclip: {camera: [{at: \"0.5s\", lens: \"6cm\"}], light: [{at: \"36f\", angle: "
          "\"20deg\"}], blinks: [\"2\"]}\n")
          .clip;
  EXPECT_EQ(clip.camera[0].at_s, 0.5);
  EXPECT_EQ(clip.camera[0].lens_mm, 60);
  EXPECT_EQ(clip.light[0].at_s, 1.5);
  EXPECT_EQ(clip.light[0].angle_deg, 20);
  EXPECT_EQ(clip.blinks_s, std::vector<double>{2});
}

TEST(constants, are_whole_where_whole_numbers_stand) {
  const auto load_seed = [](const std::string& formula) {
    return load_text("mien: 1\nclip: {blink: {per_minute: 5, seed: \"" + formula + "\"}}\n").clip.blink.seed;
  };
  EXPECT_EQ(load_seed("0.1*30"), 3u);
  EXPECT_EQ(load_seed("(0.1 + 0.2)*10"), 3u) << "3.0000000000000004 is meant to be 3";
  EXPECT_EQ(
      find_text_mistakes("mien: 1\nclip: {blink: {per_minute: 5, seed: \"3 + 1e-6\"}}\n"),
      "test.yaml:2:37: error: 'clip.blink.seed' is the formula '3 + 1e-6', which comes to 3.000001; expected "
      "a whole number from 0 to 1000000000\n"
      "  clip: {blink: {per_minute: 5, seed: \"3 + 1e-6\"}}\n"
      "                                      ^");
}

TEST(constants, may_be_too_many) {
  std::string text = "mien: 1\nclip:\n  blinks:\n";
  for (int i = 0; i < 4001; ++i) text += "    - \"1\"\n";
  EXPECT_EQ(
      find_text_mistakes(text),
      "test.yaml:4004:7: error: more than 4000 formulas stand in place of plain numbers; expected fewer "
      "(those of a script count for each set of parameters that it is played with)\n"
      "      - \"1\"\n"
      "        ^");
}

TEST(constants, a_time_that_is_one_is_not_moved) {
  const std::string text =
      "mien: 1\nclip:\n  keys:\n    - {at: 0s}\n    - {at: \"runtime/2\", express: smile}\n";
  try {
    move_time(text, {5, 7, "at", 1, 24});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "'clip.keys[1].at' is the formula 'runtime/2'; expected a time such as 1.5s, 36f or 500ms, which "
        "can be moved");
  }
  // Others are moved past it, and stay in their order.
  const std::string long_text =
      "mien: 1\nclip:\n  length: 4s\n  keys:\n    - {at: 0s}\n    - {at: \"runtime/2\"}\n    - {at: 3s}\n";
  EXPECT_EQ(
      move_time(long_text, {7, 7, "at", 1, 24}),
      "mien: 1\nclip:\n  length: 4s\n  keys:\n    - {at: 0s}\n    - {at: 1s}\n    - {at: \"runtime/2\"}\n");
}

}  // namespace
}  // namespace mien

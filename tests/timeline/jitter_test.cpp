// Swings that drawings cannot carry are told of with their place.
#include "timeline/jitter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "config/config_fixture.hpp"

namespace mien {
namespace {

std::string report(const std::string& clip) {
  std::string text;
  for (Diagnostic advice : list_jitter(load_text("mien: 1\nclip:\n" + clip).clip)) {
    advice.place.file = "a.yaml";
    text += format_diagnostic(advice) + "\n";
  }
  return text;
}

TEST(jitter, finds_how_often_a_number_swings) {
  ClipSpec clip;
  clip.length_s = 2;
  clip.draw = 2;
  const auto wave = [](double hz) {
    return [hz](double t) { return std::sin(2 * std::numbers::pi * hz * t); };
  };
  for (const double hz : {1.5, 3.0, 4.2, 9.0}) {
    const Swing swing = compute_quickest_swing(clip, 0, 2, 0.1, wave(hz));
    EXPECT_NEAR(swing.per_second, hz, 0.1 * hz);
    EXPECT_NEAR(swing.drawings, 12 / hz, 0.1 * 12 / hz);
    EXPECT_EQ(swing.draw, 2);
  }
  EXPECT_EQ(compute_quickest_swing(clip, 0, 2, 3, wave(4)).per_second, 0) << "too small to be seen";
  EXPECT_EQ(compute_quickest_swing(clip, 0, 2, 0.1, [](double t) { return t; }).per_second, 0);
}

TEST(jitter, of_a_head_that_shakes_too_fast_for_twos) {
  const std::string turn =
      "  length: 2s\n"
      "  turn:\n"
      "    - {at: 0s, nod: \"2*sin(2*pi*4.2*t)\"}\n";
  EXPECT_EQ(
      report("  draw: twos\n" + turn),
      "a.yaml:6:7: warning: the head's nod swings 4.2 times a second (at 0.057s), 2.9 drawings each time on "
      "twos; fewer than 4 jitter: draw it on ones, or let it swing 3 times a second and die away\n");
  EXPECT_EQ(report("  draw: ones\n" + turn), "");
  EXPECT_EQ(report("  draw: [{at: 0s, on: ones}]\n" + turn), "");
}

TEST(jitter, of_laws_that_tremble) {
  const std::string law =
      "  length: 1s\n"
      "  laws: [{area: corners, move: out, value: \"0.1*sin(2*pi*9*t)\"}]\n";
  const std::string told = report("  draw: twos\n" + law);
  EXPECT_TRUE(told.starts_with("a.yaml:5:10: warning: corner.out of a law swings ")) << told;
  EXPECT_NE(told.find("let it swing 3 times a second and die away"), std::string::npos) << told;
  EXPECT_NE(report("  draw: ones\n" + law).find(": let it swing 6 times a second and die away"),
            std::string::npos);
  EXPECT_EQ(report("  length: 1s\n  laws: [{area: corners, move: out, value: \"0.01*sin(2*pi*9*t)\"}]\n"), "")
      << "not seen";
  EXPECT_EQ(report("  length: 1s\n  draw: twos\n  laws: [{area: chin, move: down, value: "
                   "\"0.1+0.1*sin(2*pi*3*t)\"}]\n"),
            "");
}

TEST(jitter, of_laws_that_shake_the_head) {
  const std::string law = "  length: 1s\n  laws: [{turn: nod, value: \"2*sin(2*pi*9*t)\"}]\n";
  EXPECT_TRUE(
      report("  draw: twos\n" + law).starts_with("a.yaml:5:10: warning: the head's nod of a law swings "))
      << report("  draw: twos\n" + law);
  EXPECT_EQ(report("  length: 1s\n  draw: twos\n  laws: [{turn: nod, value: \"2*sin(2*pi*2*t)\"}]\n"), "");
  EXPECT_EQ(report("  length: 1s\n  draw: twos\n  laws: [{camera: angle, value: \"2*sin(2*pi*9*t)\"}]\n"), "")
      << "a camera may shake";
}

TEST(jitter, of_cues_whose_scripts_shake) {
  const std::string script =
      "  length: 3s\n"
      "  scripts: {shake: {length: 0.25s, turn: [{at: 0s}, {at: 0.06s, turn: 8deg}, {at: 0.19s, turn: "
      "-8deg}, {at: "
      "0.25s, turn: 0deg}]}}\n"
      "  cues: [{from: 1s, play: shake, repeat: 4}]\n";
  const std::string told = report("  draw: twos\n" + script);
  EXPECT_TRUE(told.starts_with("a.yaml:6:10: warning: the turn of 'shake' swings 4.0 times a second"))
      << told;
  EXPECT_EQ(report("  draw: ones\n" + script), "");
}

}  // namespace
}  // namespace mien

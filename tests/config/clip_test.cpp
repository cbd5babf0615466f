// Cues, laws, scripts, tables and other files, from the text to the plain values.
#include <fmt/format.h>

#include "config/config_fixture.hpp"

namespace mien {
namespace {

ClipSpec load_clip_text(const std::string& clip) { return load_text("mien: 1\nclip:\n" + clip).clip; }

std::size_t find_move_of(std::string_view area, Side side, std::string_view move) {
  return find_move(area, side, move).value();
}

TEST(clip, reads_eases_and_curves) {
  const ClipSpec clip = load_clip_text(R"Y(  between: spline
  keys:
    - {at: 0s}
    - {at: 1s, express: smile}
    - {at: 2s, ease: back}
    - {at: 3s, ease: [0.3, 0, 0.2, 1]}
    - {at: 4s, between: smooth}
  turn: [{at: 0s}, {at: 1s, turn: 10deg, between: linear}]
)Y");
  EXPECT_EQ(clip.keys[1].between, Between::spline);
  EXPECT_EQ(clip.keys[2].between, Between::ease);
  EXPECT_EQ(clip.keys[2].ease, Easing::back);
  EXPECT_EQ(clip.keys[3].ease.handles, (std::array{0.3, 0.0, 0.2, 1.0}));
  EXPECT_EQ(clip.keys[4].between, Between::smooth);
  EXPECT_EQ(clip.turn[1].between, Between::linear);
}

TEST(clip, leads_unless_it_is_told_not_to) {
  EXPECT_EQ(load_text("mien: 1\n").clip.lead.after_s, kNaturalLead.after_s);
  EXPECT_EQ(load_clip_text("  lead: natural\n").lead.after_s, kNaturalLead.after_s);
  EXPECT_EQ(load_clip_text("  lead: none\n").lead.after_s, LeadSpec{}.after_s);
  std::array<double, kLeadCount> brows_and_head{};
  brows_and_head[static_cast<std::size_t>(LeadPart::brows)] = 2.0 / 24;
  brows_and_head.back() = 0.5;
  EXPECT_EQ(load_clip_text("  lead: {brows: 2f, head: 0.5s}\n").lead.after_s, brows_and_head);
  EXPECT_TRUE(load_text("mien: 1\n").clip.lead.suits_shapes);
  EXPECT_FALSE(load_clip_text("  lead: {brows: 2f}\n").lead.suits_shapes) << "an author's word is kept";
}

TEST(clip, reads_what_is_natural_of_a_face_that_leans_and_breathes) {
  EXPECT_EQ(load_text("mien: 1\n").clip.asymmetry.amount, 0);
  EXPECT_EQ(load_clip_text("  asymmetry: natural\n").asymmetry.amount, kNaturalAsymmetry);
  EXPECT_EQ(load_clip_text("  asymmetry: none\n").asymmetry.amount, 0);
  EXPECT_EQ(load_clip_text("  asymmetry: {seed: 4}\n").asymmetry.amount, kNaturalAsymmetry);
  EXPECT_EQ(load_clip_text("  asymmetry: 0.1\n").asymmetry.amount, 0.1);
  EXPECT_EQ(load_clip_text("  drift: 0.5\n").drift.breaths_per_minute, 0);
  const DriftSpec drift = load_clip_text("  drift: {breath: 14}\n").drift;
  EXPECT_EQ(drift.amount, 0);
  EXPECT_EQ(drift.breaths_per_minute, 14);
}

TEST(clip, reads_changes_of_drawing) {
  const ClipSpec clip = load_clip_text("  draw: [{at: 0s, on: twos}, {at: 2s, on: 4}]\n");
  ASSERT_EQ(clip.draw_changes.size(), 2u);
  EXPECT_EQ(clip.draw_changes[0].draw, 2);
  EXPECT_EQ(clip.draw_changes[1].at_s, 2);
  EXPECT_EQ(clip.draw_changes[1].draw, 4);
}

TEST(clip, reads_cues) {
  const ClipSpec clip = load_clip_text(R"Y(  cues:
    - {from: 1s, express: smile, attack: 0.4s, hold: 1s, release: 0.8s, areas: [corners, lid.left], strength: 0.5, rule: add}
    - {from: 0.5s, areas: {brows: {up: 0.4}}}
    - {from: 3s, express: anger, areas: [brows]}
)Y");
  ASSERT_EQ(clip.cues.size(), 3u);
  const CueSpec &brow = clip.cues[0], &smile = clip.cues[1], &anger = clip.cues[2];
  EXPECT_EQ(smile.from_s, 1);
  EXPECT_EQ(smile.full_s, 1.4);
  EXPECT_EQ(smile.ebb_s, 2.4);
  EXPECT_EQ(smile.end_s, 3.2);
  EXPECT_EQ(smile.rule, Rule::add);
  EXPECT_TRUE(smile.owns[find_move_of("corner", Side::left, "up")]);
  EXPECT_TRUE(smile.owns[find_move_of("lid", Side::left, "lower")]);
  EXPECT_FALSE(smile.owns[find_move_of("lid", Side::right, "lower")]);
  EXPECT_FALSE(smile.owns[find_move_of("lips", Side::none, "upper")]);
  // It goes when the next one on its areas comes.
  EXPECT_EQ(brow.ebb_s, 3);
  EXPECT_TRUE(brow.owns[find_move_of("brow", Side::right, "turn")]);
  EXPECT_EQ(find_value(brow.what.pose, "brow", Side::left, "up"), 0.4);
  EXPECT_EQ(anger.end_s, kForever_s);
  EXPECT_GT(clip.length_s, 3);
}

TEST(clip, an_expression_takes_the_areas_that_it_moves_in_its_own_time) {
  const ClipSpec clip =
      load_clip_text("  cues: [{from: 0s, express: surprise}, {from: 3s, express: sadness}]\n");
  EXPECT_LT(clip.cues[0].full_s, 0.5);
  EXPECT_GT(clip.cues[1].full_s, 3.8);
  EXPECT_GT(clip.cues[0].end_s - clip.cues[0].ebb_s, clip.cues[0].full_s);
  EXPECT_TRUE(clip.cues[0].owns[find_move_of("brow", Side::left, "up")]);
  EXPECT_FALSE(clip.cues[0].owns[find_move_of("eye", Side::left, "up")]);
  EXPECT_TRUE(load_clip_text("  cues: [{from: 0s, express: neutral}]\n").cues[0].owns.all());
}

TEST(clip, numbers_may_be_formulas) {
  const ClipSpec clip = load_clip_text(R"Y(  inputs: {mood: 0.5, wave: "mood*sin(t)"}
  keys:
    - {at: 0s, express: {smile: "wave", anger: 0.1}, strength: "1 - t/10"}
    - {
at:
  2s, areas : {
  brows : {
  up:
    "wave"
  }
    , brow.left : {
    up:
      0.2
    }
  }
}
  turn: [{at: 1s, turn: "10*t", nod: "5deg"}]
  camera: [{at: 1s, distance: "0.5 + t"}]
)Y");
  ASSERT_NE(clip.keys[0].live, nullptr);
  ASSERT_NE(clip.keys[1].live, nullptr);
  EXPECT_EQ(find_value(clip.keys[1].pose, "brow", Side::left, "up"), 0.2);
  EXPECT_DOUBLE_EQ(find_value(clip.keys[1].pose, "brow", Side::right, "up"), 0.5 * std::sin(2.0));
  EXPECT_EQ(clip.turn[0].turn_deg, 10);
  EXPECT_EQ(clip.turn[0].nod_deg, 5);
  EXPECT_EQ(clip.turn[0].live[1], nullptr);
  EXPECT_EQ(clip.camera[0].distance, 1.5);
}

TEST(clip, reads_laws) {
  const ClipSpec clip = load_clip_text(R"Y(  laws:
    - {area: brow.left, move: up, value: "0.3*sin(2*pi*t/1.5)", from: 1s, to: 3s, range: [-0.2, 1]}
    - {area: lids, move: lower, value: 0.4}
    - {area: chin, move: down, value: "t", from: 1s, to: 3s, attack: 0.2s, release: 0.4s}
    - {area: chin, move: up, value: "t", from: 1s, to: 2s, attack: 1.5s, release: 0.5s}
)Y");
  ASSERT_EQ(clip.cues.size(), 4u);
  EXPECT_EQ(clip.cues[0].from_s, 0);
  EXPECT_EQ(clip.cues[0].full_s, 0);
  EXPECT_EQ(clip.cues[0].owns.count(), 2u);
  const CueSpec& wave = clip.cues[1];
  EXPECT_EQ(wave.owns.count(), 1u);
  EXPECT_EQ(wave.full_s, 1) << "nothing fades that nobody asked to";
  EXPECT_EQ(wave.ebb_s, 3);
  EXPECT_EQ(wave.end_s, 3);
  EXPECT_EQ(clip.cues[2].full_s, 1.2);
  EXPECT_EQ(clip.cues[2].ebb_s, 2.6);
  EXPECT_EQ(clip.cues[3].full_s, 1.75) << "fades longer than its time share it";
  EXPECT_EQ(clip.cues[3].ebb_s, 1.75);
  EXPECT_EQ(evaluate_pose(*wave.what.live, 1.125).pose.values[0], -0.2);
}

TEST(clip, plays_scripts_with_parameters) {
  const ClipSpec clip = load_clip_text(R"Y(  scripts:
    nod_yes:
      length: 0.5s
      parameters: {depth: 0.5}
      turn: [{at: 0s}, {at: 0.25s, nod: "20*depth"}, {at: 0.5s, nod: 0deg}]
      laws: [{area: lids, move: lower, value: "depth*t"}]
  cues:
    - {from: 1s, play: nod_yes, repeat: 3}
    - {from: 4s, play: nod_yes, with: {depth: 1}, to: 4.25s}
)Y");
  ASSERT_EQ(clip.cues.size(), 2u);
  ASSERT_NE(clip.cues[0].script, nullptr);
  EXPECT_EQ(clip.cues[0].script->turn[1].nod_deg, 10);
  EXPECT_EQ(clip.cues[1].script->turn[1].nod_deg, 20);
  EXPECT_TRUE(clip.cues[0].is_repeated);
  EXPECT_EQ(clip.cues[0].ebb_s, 2.5);
  EXPECT_EQ(clip.cues[1].ebb_s, 4.25);
  EXPECT_EQ(clip.cues[0].owns.count(), 2u);
}

TEST(clip, a_file_with_inputs_may_be_included_again) {
  const auto folder = make_test_folder();
  write_file(folder / "wave.yaml", R"(mien: 1
clip:
  inputs: {size: 0.5, swell: "size*t"}
  cues: [{from: 0s, areas: {brows: {up: "swell"}}, attack: 0s, hold: 1s, release: 0s}]
)");
  write_file(folder / "a.yaml", R"(mien: 1
clip:
  include: [wave.yaml, {file: wave.yaml, at: 3s}]
  inputs: {twice: "2*size"}
  laws: [{area: chin, move: down, value: "twice/4"}]
)");
  EXPECT_EQ(find_mistakes(folder / "a.yaml"), "");
  const ClipSpec clip = load_spec(folder / "a.yaml", *find_language()).clip;
  ASSERT_EQ(clip.cues.size(), 3u);
  const std::size_t brow = *find_move(Area::brow, Side::left, "up");
  EXPECT_EQ(evaluate_pose(*clip.cues[0].what.live, 0.5).pose.values[brow], 0.25);
  EXPECT_EQ(evaluate_pose(*clip.cues[1].what.live, 3.5).pose.values[brow], 0.25) << "it counts from 3 s";
  EXPECT_EQ(evaluate_pose(*clip.cues[2].what.live, 0).pose.values[*find_move(Area::chin, Side::none, "down")],
            0.25);
  // What another file made of them stays what it is.
  write_file(folder / "twice.yaml", R"(mien: 1
clip:
  inputs: {both: "2*size"}
  laws: [{area: chin, move: down, value: "both/4"}]
)");
  write_file(
      folder / "c.yaml",
      "mien: 1\nclip: {include: [wave.yaml, twice.yaml, {file: wave.yaml, at: 3s}], laws: [{area: chin, "
      "move: up, value: \"both/2\"}]}\n");
  EXPECT_EQ(find_mistakes(folder / "c.yaml"), "");
  const ClipSpec again = load_spec(folder / "c.yaml", *find_language()).clip;
  for (const CueSpec& cue : again.cues)
    if (cue.layer == Layer::law) {
      const std::size_t move =
          *find_move(Area::chin, Side::none, cue.what.label.ends_with("up") ? "up" : "down");
      EXPECT_EQ(evaluate_pose(*cue.what.live, 0).pose.values[move],
                move == *find_move(Area::chin, Side::none, "up") ? 0.5 : 0.25);
    }
  // Two files that name the same number are two opinions.
  write_file(folder / "other.yaml", "mien: 1\nclip: {inputs: {size: 1}}\n");
  write_file(folder / "b.yaml", "mien: 1\nclip: {include: [wave.yaml, other.yaml]}\n");
  EXPECT_EQ(find_mistakes(folder / "b.yaml"),
            "other.yaml:2:17: error: 'size' is an input already; expected another name\n"
            "  clip: {inputs: {size: 1}}\n"
            "                  ^");
}

TEST(clip, names_a_sound) {
  const auto folder = make_test_folder("_files");
  write_file(folder / "voice.WAV", "RIFF");
  const auto load = [&](const std::string& sound) {
    write_file(folder / "main.yaml", "mien: 1\nclip: {sound: " + sound + "}\n");
    return load_spec(folder / "main.yaml", *find_language());
  };
  const Spec alone = load("voice.WAV"), later = load("{file: voice.WAV, at: 12f}");
  ASSERT_TRUE(alone.clip.sound && later.clip.sound);
  EXPECT_EQ(alone.clip.sound->file.path, folder / "voice.WAV");
  EXPECT_EQ(alone.clip.sound->at_s, 0);
  EXPECT_EQ(later.clip.sound->at_s, 0.5);
  EXPECT_NE(std::ranges::find(later.files, folder / "voice.WAV"), later.files.end()) << "what a run reads";
  EXPECT_FALSE(load_text("mien: 1\n").clip.sound);
  const std::string expected = "expected a file that ends in .wav, .mp3, .ogg, .flac, .m4a";
  for (const auto& [sound, message] :
       {std::pair{"none.wav", "2:15: error: there is no file 'none.wav'; " + expected},
        {"main.yaml", "2:15: error: 'main.yaml' is no such file's name; " + expected},
        {"[voice.WAV]",
         "2:15: error: 'clip.sound' is a list; expected a file such as voice.wav or a mapping "
         "such as {file: voice.wav, at: 0.5s}"},
        {"{at: 1s}", "2:15: error: 'clip.sound' has no 'file'; expected a file such as voice.wav"},
        {"{file: voice.WAV, at: soon}",
         "2:37: error: 'clip.sound.at' is 'soon'; expected a time such as 1.5s, 36f or 500ms"}}) {
    write_file(folder / "main.yaml", fmt::format("mien: 1\nclip: {{sound: {}}}\n", sound));
    const std::string mistakes = find_mistakes(folder / "main.yaml");
    EXPECT_EQ(mistakes.substr(0, mistakes.find('\n')), "main.yaml:" + message);
  }
}

TEST(clip, includes_other_files) {
  const auto folder = make_test_folder("_files");
  write_file(folder / "other.yaml", R"Y(mien: 1
expressions: {sly: {from: smile, brow.left: {up: 0.7}}}
clip:
  fps: 12
  inputs: {mood: 0.5}
  keys: [{at: 0s}, {at: 12f, express: sly}, {at: 2s, areas: {brows: {up: "mood*t"}}}]
  scripts: {wink: {keys: [{at: 0s}, {at: 0.2s, express: wink}, {at: 0.5s}]}}
)Y");
  write_file(folder / "main.yaml", R"Y(mien: 1
clip:
  include: {file: other.yaml, at: 1s}
  keys: [{at: 0s, express: anger}, {at: 2s, express: fear}]
  cues: [{from: 3s, play: wink}]
)Y");
  const ClipSpec clip = load_spec(folder / "main.yaml", *find_language()).clip;
  EXPECT_EQ(clip.fps, 24);
  ASSERT_EQ(clip.keys.size(), 4u);
  EXPECT_EQ(clip.keys[1].at_s, 1);
  EXPECT_EQ(clip.keys[2].label, "fear");  // its own key in place of the included one
  EXPECT_EQ(clip.keys[3].at_s, 3);
  EXPECT_EQ(find_value(clip.keys[3].pose, "brow", Side::left, "up"), 1);  // its t counts from 1 s
  ASSERT_EQ(clip.cues.size(), 1u);
  write_file(folder / "part.yaml", "mien: 1\nclip: {include: {file: other.yaml, take: [scripts]}}\n");
  const ClipSpec part = load_spec(folder / "part.yaml", *find_language()).clip;
  EXPECT_EQ(part.keys.size(), 1u);
  write_file(folder / "loop.yaml", "mien: 1\nclip: {include: [loop.yaml, none.yaml]}\n");
  EXPECT_EQ(find_mistakes(folder / "loop.yaml"),
            "loop.yaml:2:18: error: 'loop.yaml' includes itself; expected another file\n"
            "  clip: {include: [loop.yaml, none.yaml]}\n"
            "                   ^\n"
            "loop.yaml:2:29: error: there is no file 'none.yaml'; expected a file that ends in .yaml, .yml\n"
            "  clip: {include: [loop.yaml, none.yaml]}\n"
            "                              ^");
}

TEST(clip, reads_tables) {
  const auto folder = make_test_folder("_files");
  write_file(folder / "talk.csv", "time,lips.upper, brows.up\n0.5,0,0.1\n1,0.5,0.2\n\n1.5,1,-0.3\n");
  write_file(folder / "main.yaml", "mien: 1\nclip: {tracks: [{csv: talk.csv, at: 1s}]}\n");
  const ClipSpec clip = load_spec(folder / "main.yaml", *find_language()).clip;
  ASSERT_EQ(clip.cues.size(), 1u);
  const CueSpec& cue = clip.cues[0];
  EXPECT_EQ(cue.full_s, 1.5);
  EXPECT_EQ(cue.ebb_s, 2.5);
  EXPECT_EQ(cue.table->moves.size(), 3u);
  EXPECT_EQ(cue.table->values, (std::vector<double>{0, 0.1, 0.1, 0.5, 0.2, 0.2, 1, -0.3, -0.3}));
}

TEST(clip, tells_what_is_wrong_in_a_table) {
  const auto folder = make_test_folder("_files");
  const auto mistakes = [&](const std::string& table) {
    write_file(folder / "talk.csv", table);
    write_file(folder / "main.yaml", "mien: 1\nclip: {tracks: [{csv: talk.csv}]}\n");
    return find_mistakes(folder / "main.yaml");
  };
  EXPECT_EQ(mistakes("time,lips.uper\n0,0\n"),
            "talk.csv:1:6: error: unknown column 'lips.uper'; did you mean 'lips.upper'?\n"
            "  time,lips.uper\n"
            "       ^");
  EXPECT_EQ(mistakes("time;lips.upper\n0;x\n1;3\n0.5;0\n2;0;1\n"),
            "talk.csv:2:3: error: 'lips.upper' is 'x'; expected a number from -2 to 2\n  0;x\n    ^\n"
            "talk.csv:3:3: error: 'lips.upper' is '3'; expected a number from -2 to 2\n  1;3\n    ^\n"
            "talk.csv:4:1: error: this time is not after the one of the line before; expected rising times\n"
            "  0.5;0\n  ^\n"
            "talk.csv:5:1: error: this line has 3 cells; expected 2 as in the first line\n  2;0;1\n  ^");
  EXPECT_NE(mistakes("lips.upper\n0\n").find("no column is the time"), std::string::npos);
  EXPECT_NE(mistakes("").find("talk.csv"), std::string::npos);
  EXPECT_NE(mistakes("time,lips.upper\n").find("there are no rows"), std::string::npos);
}

std::string repeat(const std::string& line, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += line;
  return text;
}

// A hundred tracks of one file were a hundred tables.
TEST(clip, a_table_is_read_once) {
  const auto folder = make_test_folder("_files");
  write_file(folder / "talk.csv", "time,lips.upper\n0,0.1\n1,0.2\n");
  write_file(folder / "main.yaml", "mien: 1\nclip:\n  tracks:\n" + repeat("    - {csv: talk.csv}\n", 3) +
                                       "    - {csv: talk.csv, between: spline}\n");
  const ClipSpec clip = load_spec(folder / "main.yaml", *find_language()).clip;
  ASSERT_EQ(clip.cues.size(), 4u);
  EXPECT_EQ(clip.cues[0].table, clip.cues[1].table);
  EXPECT_EQ(clip.cues[0].table, clip.cues[2].table);
  EXPECT_NE(clip.cues[0].table, clip.cues[3].table) << "another way between its rows";
}

TEST(clip, tells_the_first_part_that_is_one_too_many) {
  const std::string law = "    - {area: brows, move: up, value: 0.1}\n";
  EXPECT_EQ(
      find_text_mistakes("mien: 1\nclip:\n  laws:\n" + repeat(law, 20001)),
      "test.yaml:20004:7: error: more than 20000 keys, cues, laws and tracks; expected fewer (those of a "
      "script count for each set of parameters that it is played with)\n  " +
          law + "        ^");
}

TEST(clip, tells_the_first_formula_that_is_one_too_many) {
  const std::string law = "    - {area: brows, move: up, value: \"sin(t)\"}\n";
  EXPECT_EQ(
      find_text_mistakes("mien: 1\nclip:\n  length: 1f\n  laws:\n" + repeat(law, 4001)),
      "test.yaml:4005:38: error: more than 4000 formulas; expected fewer (those of a script count for each "
      "set of parameters that it is played with)\n  " +
          law + "                                       ^");
}

// Six scripts of ten cues that play each other were a million faces at one moment.
TEST(clip, tells_a_clip_that_is_too_much_work) {
  std::string text = "mien: 1\nclip:\n  length: 4s\n  scripts:\n";
  for (int layer = 0; layer < 6; ++layer) {
    text += fmt::format("    s{}:\n", layer);
    text += layer == 5
                ? "      keys: [{at: 0s, express: smile}, {at: 1s, express: neutral}]\n"
                : "      cues:\n" + repeat(fmt::format("        - {{from: 0s, play: s{}}}\n", layer + 1), 10);
  }
  EXPECT_EQ(
      find_text_mistakes(text + "  cues: [{from: 0s, play: s0}, {from: 0s, play: s0}]\n"),
      "test.yaml:3:3: error: 'clip' is 8e+07 numbers to work out over its 96 frames; expected 4e+07 at most: "
      "fewer cues, laws and formulas at one time, or a shorter clip (a script counts with all that it "
      "plays)\n"
      "    length: 4s\n"
      "    ^");
  EXPECT_EQ(find_text_mistakes(text + "  cues: [{from: 0s, play: s1}]\n"), "");
}

// A formula is tried at every frame with the inputs that it uses: here a second's work each.
TEST(clip, tells_formulas_that_take_too_long_to_try) {
  std::string text = "mien: 1\nclip:\n  length: 100s\n  inputs:\n    i0: \"sin(t)\"\n";
  for (int i = 1; i < 60; ++i)
    text += fmt::format("    i{}: \"i{}*0.9{}\"\n", i, i - 1, repeat("+sin(t)", 100));
  const std::string law = "    - {area: brows, move: up, value: \"0.001*i59\"}\n";
  const std::string mistakes = find_text_mistakes(text + "  laws:\n" + repeat(law, 60));
  EXPECT_EQ(
      mistakes.substr(mistakes.find('\n') + 1),
      "    length: 100s\n    ^\n"
      "test.yaml:81:38: error: with 'clip.laws.value' the formulas before it take too long to try at every "
      "time; expected fewer, shorter ones or fewer that use each other\n  " +
          law + "                                       ^");
}

TEST(clip, texts_that_it_names_are_not_too_long_together) {
  const auto folder = make_test_folder("_files");
  std::string text = "mien: 1\nclip:\n  tracks:\n";
  for (int i = 0; i < 5; ++i) {
    const std::string name = fmt::format("t{}.csv", i);
    write_file(folder / name, "time,lips.upper\n0,0\n" + std::string(999'980, ' '));
    text += "    - {csv: " + name + "}\n";
  }
  write_file(folder / "main.yaml", text);
  EXPECT_EQ(
      find_mistakes(folder / "main.yaml"),
      "main.yaml:8:13: error: 't4.csv' makes the texts that are named here 5000000 bytes long; expected "
      "4194304 at most, all together\n"
      "      - {csv: t4.csv}\n"
      "              ^");
}

TEST(clip, tells_a_table_of_more_columns_than_there_are) {
  const auto folder = make_test_folder("_files");
  write_file(folder / "talk.csv", "time" + repeat(",lips.upper", 5000) + "\n0\n");
  write_file(folder / "main.yaml", "mien: 1\nclip: {tracks: [{csv: talk.csv}]}\n");
  EXPECT_EQ(find_mistakes(folder / "main.yaml").substr(0, 57),
            "talk.csv:1:1: error: this line has 5001 columns; expected");
}

// Whatever a link or a path leads to: of what is no file for mien nothing is shown.
TEST(clip, shows_nothing_of_a_file_that_is_of_another_kind) {
  const auto folder = make_test_folder("_files");
  write_file(folder / "secret", "root:x:hidden\n\t- [hidden\n");
  for (const char* link : {"link.yaml", "link.csv"}) std::filesystem::create_symlink("secret", folder / link);
  const std::string no_file =
      "link.yaml:1:1: error: is no file for mien: it has none of the keys mien, head, clip, expressions; "
      "expected a "
      "file that begins with 'mien: 1'";
  for (const auto& [text, told] : std::vector<std::pair<std::string, std::string>>{
           {"clip: {include: [link.yaml]}", no_file},
           {"head: {mix: {link.yaml: 1}}", no_file},
           {"actors: {a: {head: link.yaml}}", no_file},
           {"clip: {tracks: [{csv: link.csv}]}",
            "link.csv:1:1: error: is no table: none of the words of its first line is a column; expected "
            "time, "
            "frame or "
            "a move such as lips.upper"}}) {
    write_file(folder / "main.yaml", "mien: 1\n" + text + "\n");
    EXPECT_EQ(find_mistakes(folder / "main.yaml"), told) << text;
  }
  write_file(folder / "empty.yaml", "# nothing\n");
  write_file(folder / "empty.csv", "");
  write_file(folder / "main.yaml", "mien: 1\nclip: {include: [empty.yaml], tracks: [{csv: empty.csv}]}\n");
  EXPECT_EQ(find_mistakes(folder / "main.yaml"),
            "empty.csv:1:1: error: the file is empty; expected a line of names such as time,lips.upper and a "
            "line for each time\n"
            "empty.yaml:1:1: error: the file is empty; expected a file that begins with 'mien: 1'");
}

}  // namespace
}  // namespace mien

#include <fmt/format.h>
#include <cmath>

#include "config/config_fixture.hpp"
#include "config/pose_mix.hpp"

namespace mien {
namespace {

// A data folder whose libraries are the given texts.
std::filesystem::path make_data(const std::map<std::string, std::string>& libraries) {
  const auto folder = make_test_folder("_data");
  for (const auto& [name, text] : libraries)
    write_file(folder / "configs/expressions" / (name + ".yaml"), text);
  return folder;
}

const Pose& find_pose(const Spec& spec, const std::string& name) { return find_expression(spec, name).pose; }

TEST(expressions, hold_the_numbers_of_their_areas) {
  const Spec spec = load_text("mien: 1\n");
  const Pose& smile = find_pose(spec, "smile");
  EXPECT_EQ(find_value(smile, "corner", Side::left, "up"), 0.95);
  EXPECT_EQ(find_value(smile, "corner", Side::right, "up"), 0.95);
  EXPECT_EQ(find_value(smile, "lips", Side::none, "lower"), -0.3);
  EXPECT_EQ(find_value(smile, "chin", Side::none, "down"), 0);
  EXPECT_EQ(find_value(find_pose(spec, "tezuka/smile"), "corner", Side::left, "up"), 0.4);
}

TEST(expressions, wink_with_the_characters_own_left_eye) {
  const Spec spec = load_text("mien: 1\n");
  EXPECT_EQ(find_value(find_pose(spec, "wink"), "lid", Side::left, "upper"), -1);
  EXPECT_EQ(find_value(find_pose(spec, "wink"), "lid", Side::right, "upper"), 0);
}

TEST(expressions, are_looked_up_in_the_file_then_in_its_library_then_in_the_everyday_ones) {
  const Spec own = load_text("mien: 1\nexpressions: {smile: {chin: {up: 0.5}}}\n");
  EXPECT_EQ(find_expression(own, "smile").library, "");
  EXPECT_EQ(find_expression(own, "mien/smile").library, "mien");
  EXPECT_EQ(own.expressions.front().name, "smile");
  const Spec tezuka = load_text("mien: 1\nlibrary: tezuka\n");
  EXPECT_EQ(find_expression(tezuka, "smile").library, "tezuka");
  EXPECT_EQ(find_expression(tezuka, "disgust").library, "mien");
  EXPECT_EQ(find_expression(tezuka, "a").library, "mouths");
  EXPECT_EQ(find_expression(tezuka, "wink").library, "extras");
  EXPECT_EQ(find_expression(tezuka, "doubt_left").library, "tezuka");
}

TEST(expressions, that_are_unknown_are_answered_with_the_nearest) {
  const Spec spec = load_text("mien: 1\nexpressions: {sly: {from: smile}}\n");
  const auto message = [&](const std::string& name) {
    try {
      return find_expression(spec, name).name;
    } catch (const InputError& error) {
      return format_error(error);
    }
  };
  EXPECT_EQ(message("smlie"), "error: unknown expression 'smlie'; did you mean 'smile'?");
  EXPECT_EQ(message("slyy"), "error: unknown expression 'slyy'; did you mean 'sly'?");
  EXPECT_EQ(message("doubt_right"),
            "error: unknown expression 'doubt_right'; did you mean 'tezuka/doubt_right'?");
  EXPECT_EQ(message("tezka/smile"), "error: unknown library 'tezka'; did you mean 'tezuka'?");
  EXPECT_EQ(message("/sly"),
            "error: unknown library ''; known: candide, compound, emfacs, extras, mien, mouths, muscles, "
            "parke, tezuka");
  EXPECT_EQ(message("tezuka/smlie"),
            "error: unknown expression 'tezuka/smlie'; did you mean 'tezuka/smile'?");
  EXPECT_EQ(message("mouths/smile"),
            "error: unknown expression 'mouths/smile'; known in mouths: A, B, C, D, E, F, G, H, X, a, e, i, "
            "neutral, o, u");
}

TEST(expressions, of_ones_own_start_from_another_and_change_areas) {
  const Spec spec = load_text(R"(mien: 1
expressions:
  slier: {from: sly, strength: 0.5, lips: {press: 1}}
  sly: {from: smile, brow.left: {up: 0.7}}
)");
  const Pose& sly = find_pose(spec, "sly");
  EXPECT_EQ(find_value(sly, "brow", Side::left, "up"), 0.7);
  EXPECT_EQ(find_value(sly, "brow", Side::right, "up"), 0.18);
  EXPECT_EQ(find_value(sly, "corner", Side::left, "up"), 0.95);
  const Pose& slier = find_pose(spec, "slier");
  EXPECT_EQ(find_value(slier, "brow", Side::left, "up"), 0.35);
  EXPECT_DOUBLE_EQ(find_value(slier, "corner", Side::left, "up"), 0.95 * std::pow(0.5, 0.7));  // its growth
  EXPECT_EQ(find_value(slier, "lips", Side::none, "press"), 1);
}

TEST(expressions, let_a_sided_key_override_a_plural_one_in_any_order) {
  for (const std::string areas : {"brow.left: {up: 0.7}, brows: {up: 0.5, out: 0.1}",
                                  "brows: {up: 0.5, out: 0.1}, brow.left: {up: 0.7}"}) {
    const Spec spec = load_text("mien: 1\nclip: {keys: [{at: 0s, areas: {" + areas + "}}]}\n");
    const Pose& pose = spec.clip.keys[0].pose;
    EXPECT_EQ(find_value(pose, "brow", Side::left, "up"), 0.7);
    EXPECT_EQ(find_value(pose, "brow", Side::right, "up"), 0.5);
    EXPECT_EQ(find_value(pose, "brow", Side::left, "out"), 0.1);
  }
}

TEST(expressions, chain_as_long_as_an_author_likes) {
  std::string text = "mien: 1\nexpressions:\n";
  for (int i = 0; i < 20000; ++i) text += fmt::format("  e{}: {{from: e{}}}\n", i, i + 1);
  const Spec spec = load_text(text + "  e20000: {chin: {down: 0.5}}\n");
  EXPECT_EQ(find_value(find_pose(spec, "e0"), "chin", Side::none, "down"), 0.5);
}

TEST(expressions, in_a_key_are_mixed_then_weakened_then_overridden_then_held) {
  const Spec spec = load_text(R"(mien: 1
expressions:
  a1: {chin: {down: 0.8}, corners: {up: 0.5}, lips: {upper: -1}}
  a2: {chin: {down: 0.8}, corners: {up: -0.5}, lips: {upper: -1}}
clip:
  keys:
    - {at: 0s, express: {a1: 1, a2: 0.5}, strength: 0.5, areas: {corner.left: {up: 1}}}
    - {at: 1s, express: {a1: 1, a2: 0.5}}
)");
  const Pose& pose = spec.clip.keys[0].pose;
  EXPECT_DOUBLE_EQ(find_value(pose, "chin", Side::none, "down"), 0.6);
  EXPECT_EQ(find_value(pose, "corner", Side::left, "up"), 1);
  EXPECT_EQ(find_value(pose, "corner", Side::right, "up"), 0.125);
  EXPECT_EQ(spec.clip.keys[0].label, "(a1 1 + a2 0.5) 0.5");
  EXPECT_EQ(find_value(spec.clip.keys[1].pose, "chin", Side::none, "down"), 1);
  EXPECT_EQ(find_value(spec.clip.keys[1].pose, "lips", Side::none, "upper"), -1);
}

TEST(pose_mix, closes_a_lid_once) {
  const std::size_t upper = *find_move(Area::lid, Side::left, "upper");
  const std::size_t brow = *find_move(Area::brow, Side::left, "up");
  Pose a, b;
  a.values[upper] = a.values[brow] = -0.6;
  b.values[upper] = b.values[brow] = -0.5;
  const Pose both = mix_poses({{1, a}, {1, b}});
  EXPECT_EQ(both.values[upper], -0.6);
  EXPECT_EQ(both.values[brow], -1.1);
  b.values[upper] = 0.4;
  EXPECT_DOUBLE_EQ(mix_poses({{1, a}, {0.5, b}}).values[upper], -0.4);
  EXPECT_EQ(mix_poses({}), Pose{});
}

TEST(libraries, are_sorted_by_library_and_name_and_each_has_a_neutral_face) {
  const auto all = load_expression_libraries(kData / "configs/expressions");
  std::map<std::string, int> neutral;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0) {
      EXPECT_LT(std::tie(all[i - 1].library, all[i - 1].name), std::tie(all[i].library, all[i].name));
    }
    neutral[all[i].library] += all[i].name == "neutral" && all[i].pose == Pose{};
  }
  EXPECT_EQ(neutral, (std::map<std::string, int>{{"candide", 1},
                                                 {"compound", 1},
                                                 {"emfacs", 1},
                                                 {"extras", 1},
                                                 {"mien", 1},
                                                 {"mouths", 1},
                                                 {"muscles", 1},
                                                 {"parke", 1},
                                                 {"tezuka", 1}}));
}

TEST(libraries, may_start_from_one_another) {
  const auto data =
      make_data({{"b", "mien: 1\nlibrary: b\nexpressions: {two: {from: one}, one: {chin: {up: 1}}}\n"},
                 {"a", "mien: 1\nlibrary: a\nexpressions: {far: {from: b/two}}\n"}});
  const auto all = load_expression_libraries(data / "configs/expressions");
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].name, "far");
  EXPECT_EQ(find_value(all[0].pose, "chin", Side::none, "up"), 1);
}

TEST(libraries, say_in_one_line_where_they_are_from) {
  const auto data = make_data({{"a", "mien: 1\nlibrary: a\nsource: Aye, 1990\nexpressions: {}\n"},
                               {"b", "mien: 1\nlibrary: b\nexpressions: {}\n"}});
  EXPECT_EQ(load_library_sources(data / "configs/expressions"),
            (std::map<std::string, std::string>{{"a", "Aye, 1990"}, {"b", ""}}));
  const auto wrong = make_data({{"a", "mien: 1\nlibrary: a\nsource: [1]\nexpressions: {}\n"}});
  EXPECT_NE(
      find_text_mistakes("mien: 1\n", wrong).find("a.yaml:3:9: error: 'source' is a list; expected one line"),
      std::string::npos)
      << find_text_mistakes("mien: 1\n", wrong);
}

TEST(libraries, are_judged_as_the_files_of_authors_are) {
  const auto data =
      make_data({{"a", "mien: 1\nlibrary: b\nexpressions: {x: {brows: {upp: 1}}, y: {from: z}}\n"},
                 {"b", "title: x\n"},
                 {"c", "- 1\n"},
                 {"d", "mien: 1\nlibrary: d\nexpressions: [\n"}});
  EXPECT_EQ(find_text_mistakes("mien: 1\n", data),
            R"(a.yaml:2:10: error: library 'b' stands in another file's name; expected 'a'
  library: b
           ^
a.yaml:3:27: error: unknown move 'upp' in 'expressions.x.brows'; did you mean 'up'?
  expressions: {x: {brows: {upp: 1}}, y: {from: z}}
                            ^
a.yaml:3:47: error: unknown expression 'z'; did you mean 'x'?
  expressions: {x: {brows: {upp: 1}}, y: {from: z}}
                                                ^
b.yaml:1:1: error: unknown key 'title'; known: mien, library, source, rules, expressions
  title: x
  ^
b.yaml:1:1: error: 'mien: 1' is missing; expected it as the first line
  title: x
  ^
b.yaml:1:1: error: the file has no 'library'; expected the file's name, 'b'
  title: x
  ^
b.yaml:1:1: error: the file has no 'expressions'; expected a mapping of names to areas
  title: x
  ^
c.yaml:1:1: error: the file is a list; expected a mapping that begins with 'mien: 1'
  - 1
  ^
d.yaml:3:14: error: '[' is never closed; expected ']'
  expressions: [
               ^)");
}

TEST(libraries, that_are_missing_are_not_the_inputs_fault) {
  try {
    load_expression_libraries("/nowhere/expressions");
    FAIL();
  } catch (const RunError& error) {
    EXPECT_STREQ(error.what(), "cannot read /nowhere/expressions: No such file or directory");
  }
}

}  // namespace
}  // namespace mien

// Files that a head names: found from the file that names them, mixed within limits.
#include "config/head_files.hpp"

#include <fmt/format.h>

#include "config/config_fixture.hpp"

namespace mien {
namespace {

void write_head(const std::filesystem::path& file, const std::string& head) {
  write_file(file, "mien: 1\nhead: " + head + "\n");
}

TEST(head_files, are_found_from_the_folder_of_the_file_that_names_them) {
  const auto folder = make_test_folder();
  write_file(folder / "parts/half.OBJ", "");
  write_head(folder / "inner/a.yaml", "{mesh: ../parts/half.OBJ}");
  write_head(folder / "b.yaml", "{mix: {inner/a.yaml: 2, plain.yml: 6}}");
  write_head(folder / "plain.yml", "{}");
  const HeadSpec head = load_spec(folder / "b.yaml", *find_language()).head;
  ASSERT_EQ(head.mix.size(), 2u);
  EXPECT_EQ(head.mix[0].weight, 0.25);
  ASSERT_TRUE(head.mix[0].head.mesh);
  EXPECT_TRUE(std::filesystem::equivalent(head.mix[0].head.mesh->path, folder / "parts/half.OBJ"));
  EXPECT_EQ(head.mix[0].head.mesh->place.line, 2);
}

TEST(head_files, landmarks_stand_beside_the_mesh) {
  const auto folder = make_test_folder();
  EXPECT_FALSE(find_landmark_file(folder / "face.ply"));
  write_file(folder / "face.yaml", "");
  EXPECT_EQ(find_landmark_file(folder / "face.ply"), folder / "face.yaml");
  write_file(folder / "face.landmarks.yaml", "");
  EXPECT_EQ(find_landmark_file(folder / "face.ply"), folder / "face.landmarks.yaml");
}

TEST(head_files, looks_are_mixed_and_can_be_changed) {
  const auto folder = make_test_folder();
  write_head(folder / "a.yaml", "{look: {skin: \"#000000\", iris: \"#ff0000\", freckles: 1}}");
  write_head(folder / "b.yaml", "{look: {skin: \"#ffffff\", lips: \"#00ff00\"}}");
  write_head(folder / "c.yaml", "{mix: {a.yaml: 1, b.yaml: 1}, look: {iris: \"#0000ff\"}}");
  const Look look = load_spec(folder / "c.yaml", *find_language()).head.look;
  EXPECT_EQ(look.skin, glm::vec3(0.5f));
  EXPECT_EQ(look.iris, glm::vec3(0, 0, 1));
  EXPECT_EQ(look.freckles, 0.5);
  EXPECT_EQ(look.lips, glm::vec3(0, 1, 0)) << "only one head has lips of its own";
}

TEST(head_files, limits_are_mixed_and_can_be_changed) {
  const auto folder = make_test_folder();
  write_head(folder / "a.yaml", "{limits: {brow.left.up: 0.5, chin.down: 2}}");
  write_head(folder / "b.yaml", "{limits: {lips.press: 0}}");
  write_head(folder / "c.yaml", "{mix: {a.yaml: 3, b.yaml: 1}, limits: {chin.down: 0.25}}");
  EXPECT_EQ(
      load_spec(folder / "c.yaml", *find_language()).head.limits,
      (std::map<std::string, double>{{"brow.left.up", 0.625}, {"chin.down", 0.25}, {"lips.press", 0.75}}));
}

TEST(head_files, are_keys_of_a_head_that_changes) {
  const auto folder = make_test_folder();
  write_head(folder / "otto.yaml", "{age: old, features: {nose_length: 0.5}, hair: crop}");
  write_head(folder / "anna.yaml", "{character: female}");
  write_file(folder / "face.yaml",
             "mien: 1\nhead: {hair: bun, limits: {chin.down: 0.5}}\nclip:\n  head:\n    - {at: 0s}\n"
             "    - {at: 1s, file: otto.yaml}\n    - {at: 2s, file: otto.yaml, age: child}\n"
             "    - {at: 3s, mix: {otto.yaml: 1, anna.yaml: 3}}\n");
  const Spec spec = load_spec(folder / "face.yaml", *find_language());
  const std::vector<HeadKey>& keys = spec.clip.head;
  ASSERT_EQ(keys.size(), 4u);
  EXPECT_EQ(keys[1].head.age, (Mix{{"old", 1}}));
  EXPECT_EQ(keys[1].head.hair, "bun") << "cuts and limits stay those of the one who plays";
  EXPECT_EQ(keys[1].head.limits, spec.head.limits);
  EXPECT_EQ(keys[2].head.age, (Mix{{"child", 1}}));
  EXPECT_EQ(keys[2].head.features.at("nose_length"), 0.5);
  ASSERT_EQ(keys[3].head.mix.size(), 2u);
  EXPECT_EQ(keys[3].head.mix[1].weight, 0.75);
  EXPECT_EQ(spec.files.size(), 5u) << "each time that one is read";
}

TEST(head_files, heads_mix_no_circle) {
  const auto folder = make_test_folder();
  write_head(folder / "a.yaml", "{mix: {b.yaml: 1}}");
  write_head(folder / "b.yaml", "{mix: {./c.yaml: 1}}");
  write_head(folder / "c.yaml", "{mix: {../heads_mix_no_circle/b.yaml: 1}}");
  EXPECT_EQ(find_mistakes(folder / "a.yaml"),
            "c.yaml:2:14: error: heads mix each other in a circle: b.yaml mixes c.yaml mixes b.yaml; "
            "expected none\n"
            "  head: {mix: {../heads_mix_no_circle/b.yaml: 1}}\n               ^");
}

TEST(head_files, heads_are_mixed_within_limits) {
  const auto folder = make_test_folder();
  write_head(folder / "0.yaml", "{}");
  for (int i = 1; i <= kMaxMixDepth + 1; ++i)
    write_head(folder / fmt::format("{}.yaml", i), fmt::format("{{mix: {{{}.yaml: 1}}}}", i - 1));
  EXPECT_EQ(find_mistakes(folder / fmt::format("{}.yaml", kMaxMixDepth)), "");
  EXPECT_EQ(find_mistakes(folder / fmt::format("{}.yaml", kMaxMixDepth + 1)),
            "1.yaml:2:14: error: heads are mixed more than 4 deep; expected fewer\n"
            "  head: {mix: {0.yaml: 1}}\n               ^");

  std::string many = "{mix: {0.yaml: 1";
  for (int i = 1; i <= kMaxMixedHeads; ++i) {
    write_head(folder / fmt::format("m{}.yaml", i), "{}");
    if (i == kMaxMixedHeads) write_head(folder / "most.yaml", many + "}}");
    many += fmt::format(", m{}.yaml: 1", i);
  }
  write_head(folder / "many.yaml", many + "}}");
  EXPECT_EQ(find_mistakes(folder / "most.yaml"), "");
  EXPECT_NE(find_mistakes(folder / "many.yaml").find("more than 24 heads are mixed; expected fewer"),
            std::string::npos);
}

TEST(sculpt, strokes_lose_their_side) {
  const HeadSpec head =
      load_text(
          "mien: 1\nhead: {sculpt: [{at: ch_r, move: [1mm, -0.2cm, 3], radius: 3cm}, {at: chin, move: [0, 0, "
          "1]}]}\n")
          .head;
  ASSERT_EQ(head.sculpt.size(), 2u);
  EXPECT_EQ(head.sculpt[0].at, "ch");
  EXPECT_EQ(head.sculpt[0].move_mm, glm::dvec3(1, -2, 3));
  EXPECT_EQ(head.sculpt[0].radius_mm, 30);
  EXPECT_EQ(head.sculpt[1].radius_mm, 20);
}

TEST(head_files, different_scans_are_few) {
  const auto folder = make_test_folder();
  std::string mix, twice;
  for (int i = 0; i < 4; ++i) {
    write_file(folder / fmt::format("s{}.ply", i), "");
    write_file(folder / fmt::format("s{}.yaml", i), "");
    write_head(folder / fmt::format("m{}.yml", i), fmt::format("{{scan: s{}.ply}}", i));
    write_head(folder / fmt::format("n{}.yml", i), "{scan: s0.ply}");
    mix += fmt::format("m{}.yml: 1, ", i);
    twice += fmt::format("n{}.yml: 1, ", i);
  }
  write_head(folder / "main.yml", "{mix: {" + mix + "}}");
  EXPECT_EQ(find_mistakes(folder / "main.yml"),
            "m3.yml:2:14: error: more than 3 different scans; expected fewer\n"
            "  head: {scan: s3.ply}\n"
            "               ^");
  write_head(folder / "main.yml", "{mix: {" + twice + "}}");
  EXPECT_EQ(find_mistakes(folder / "main.yml"), "") << "one scan is wrapped once";
}

TEST(head_files, keys_of_a_head_and_strokes_are_few) {
  std::string keys = "mien: 1\nclip:\n  head:\n", strokes = "mien: 1\nhead:\n  sculpt:\n";
  for (int i = 0; i < 31; ++i) keys += fmt::format("    - {{at: {}s, age: child}}\n", i);
  for (int i = 0; i < 201; ++i) strokes += "    - {at: chin, move: [0, -1mm, 0]}\n";
  EXPECT_EQ(find_text_mistakes(keys),
            "test.yaml:34:7: error: more than 30 keys of 'clip.head'; expected fewer\n"
            "      - {at: 30s, age: child}\n"
            "        ^");
  EXPECT_EQ(find_text_mistakes(strokes),
            "test.yaml:204:7: error: more than 200 strokes of 'sculpt'; expected fewer\n"
            "      - {at: chin, move: [0, -1mm, 0]}\n"
            "        ^");
}

}  // namespace
}  // namespace mien

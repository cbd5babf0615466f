#include <algorithm>

#include "config/config_fixture.hpp"
#include "config/head_words.hpp"
#include "config/words.hpp"

namespace mien {
namespace {

TEST(load_spec, gives_every_default_for_one_line) {
  const Spec spec = load_text("mien: 1\n");
  EXPECT_EQ(spec.name, "test");
  EXPECT_EQ(spec.title, "");
  EXPECT_EQ(spec.library, "mien");
  EXPECT_EQ(spec.head.age, (Mix{{"adult", 1.0}}));
  EXPECT_EQ(spec.head.skull, (Mix{{"average", 1.0}}));
  EXPECT_EQ(spec.head.character, 0);
  EXPECT_FALSE(spec.head.look.lips.has_value());
  EXPECT_EQ(spec.clip.fps, 24);
  EXPECT_EQ(spec.clip.draw, 1);
  ASSERT_EQ(spec.clip.keys.size(), 1u);
  EXPECT_EQ(spec.clip.keys[0].at_s, 0);
  EXPECT_EQ(spec.clip.keys[0].pose, Pose{});
  EXPECT_EQ(spec.clip.keys[0].label, "neutral");
  ASSERT_EQ(spec.clip.camera.size(), 1u);
  EXPECT_EQ(spec.clip.camera[0].distance, 1);
  ASSERT_EQ(spec.clip.turn.size(), 1u);
  EXPECT_EQ(spec.clip.blink.per_minute, 0);
  EXPECT_EQ(count_frames(spec.clip), 1);
  EXPECT_EQ(spec.render.width_px, 480);
  EXPECT_EQ(spec.render.height_px, 600);
  EXPECT_EQ(spec.render.quality, Quality::good);
  EXPECT_EQ(spec.render.background, "studio");
  EXPECT_TRUE(spec.busts.empty());
}

TEST(load_spec, reads_the_head) {
  const HeadSpec head = load_text(R"(mien: 1
head:
  age: {child: 1, adult: 3}
  skull: square
  character: female
  guides: {eye_line: 0.49, hairline: .8}
  look: {skin: "#ff0080", lips: "#000000", iris: "#FFFFFF", brow: "#102030"}
)")
                            .head;
  EXPECT_EQ(head.age, (Mix{{"adult", 0.75}, {"child", 0.25}}));
  EXPECT_EQ(head.skull, (Mix{{"square", 1.0}}));
  EXPECT_EQ(head.character, -1);
  EXPECT_EQ(head.guides, (std::map<std::string, double>{{"eye_line", 0.49}, {"hairline", 0.8}}));
  EXPECT_FLOAT_EQ(head.look.skin.r, 1);
  EXPECT_FLOAT_EQ(head.look.skin.g, 0);
  EXPECT_FLOAT_EQ(head.look.skin.b, 128.0f / 255);
  EXPECT_EQ(head.look.lips.value(), glm::vec3(0));
  EXPECT_EQ(head.look.iris, glm::vec3(1));
  EXPECT_FLOAT_EQ(head.look.brow.g, 32.0f / 255);
  EXPECT_EQ(load_text("mien: 1\nhead: {character: male}\n").head.character, 1);
  EXPECT_EQ(load_text("mien: 1\nhead: {character: -0.25}\n").head.character, -0.25);
}

TEST(load_spec, reads_the_clip) {
  const ClipSpec clip = load_text(R"(mien: 1
clip:
  blinks: [2s, 12f]
  blink: {per_minute: 15, seed: 7}
  camera: [{at: 0s, angle: 10deg, height: 5, distance: 2}, {at: 1s, angle: -20deg, ease: hold}]
  turn: [{at: 500ms, turn: 20deg, nod: -10, tilt: +5deg, ease: linear}, {at: 1, nod: 1}]
  keys: [{at: 0}, {at: 36f, express: smile, ease: out}, {at: 4s, express: neutral, ease: in}]
  draw: twos
  fps: 12
)")
                            .clip;
  EXPECT_EQ(clip.fps, 12);
  EXPECT_EQ(clip.draw, 2);
  EXPECT_EQ(clip.blinks_s, (std::vector<double>{1, 2}));
  EXPECT_EQ(clip.blink.per_minute, 15);
  EXPECT_EQ(clip.blink.seed, 7u);
  ASSERT_EQ(clip.camera.size(), 2u);
  EXPECT_EQ(clip.camera[0].angle_deg, 10);
  EXPECT_EQ(clip.camera[1].angle_deg, -20);
  EXPECT_EQ(clip.camera[1].height_deg, 5);
  EXPECT_EQ(clip.camera[1].distance, 2);
  EXPECT_EQ(clip.camera[1].ease, Easing::hold);
  ASSERT_EQ(clip.turn.size(), 2u);
  EXPECT_EQ(clip.turn[0].at_s, 0.5);
  EXPECT_EQ(clip.turn[0].ease, Easing::linear);
  EXPECT_EQ(clip.turn[1].turn_deg, 20);
  EXPECT_EQ(clip.turn[1].nod_deg, 1);
  EXPECT_EQ(clip.turn[1].tilt_deg, 5);
  EXPECT_EQ(clip.turn[1].ease, Easing::in_out);
  ASSERT_EQ(clip.keys.size(), 3u);
  EXPECT_EQ(clip.keys[1].at_s, 3);
  EXPECT_EQ(clip.keys[1].ease, Easing::out);
}

TEST(load_spec, reads_render_and_busts) {
  const Spec spec = load_text(R"(mien: 1
title: "It's: \"fine\""
render: {size: 8192x16, quality: best, background: dark}
busts: [{}, {express: laugh, height: 12cm}, {express: {smile: 0.5, fear: 0.2}, strength: 0.5, height: 30}]
)");
  EXPECT_EQ(spec.title, "It's: \"fine\"");
  EXPECT_EQ(spec.render.width_px, 8192);
  EXPECT_EQ(spec.render.height_px, 16);
  EXPECT_EQ(spec.render.quality, Quality::best);
  EXPECT_EQ(spec.render.background, "dark");
  ASSERT_EQ(spec.busts.size(), 3u);
  EXPECT_EQ(spec.busts[0].expression.name, "neutral");
  EXPECT_EQ(spec.busts[0].height_mm, 80);
  EXPECT_EQ(spec.busts[1].expression.name, "laugh");
  EXPECT_EQ(spec.busts[1].expression.library, "mien");
  EXPECT_EQ(spec.busts[1].height_mm, 120);
  EXPECT_EQ(spec.busts[2].expression.name, "smile_fear");
  EXPECT_EQ(spec.busts[2].height_mm, 30);
}

TEST(load_spec, reads_the_colours_of_ink) {
  const InkColours plain = load_text("mien: 1\n").render.ink;
  EXPECT_EQ(plain.line, InkColours{}.line);
  EXPECT_FALSE(plain.shade);
  EXPECT_FALSE(plain.blush);
  const InkColours own =
      load_text("mien: 1\nrender: {ink: {line: \"#0000ff\", shade: \"#8080c0\", teeth: \"#ffff00\"}}\n")
          .render.ink;
  EXPECT_EQ(own.line, glm::vec3(0, 0, 1));
  EXPECT_EQ(own.bone, glm::vec3(1, 1, 0));
  ASSERT_TRUE(own.shade);
  EXPECT_NEAR(own.shade->b, 192 / 255.0, 1e-6);
  EXPECT_EQ(own.cavity, plain.cavity);
}

TEST(load_spec, writes_the_names_of_a_set_on_its_bases) {
  std::vector<std::string> labels;
  for (const BustSpec& bust : load_text("mien: 1\nbusts: {all: tezuka}\n").busts)
    labels.push_back(bust.label);
  EXPECT_THAT(labels, testing::IsSupersetOf({"neutral", "laugh", "doubt L", "doubt R"}));
  for (const BustSpec& bust : load_text("mien: 1\nbusts: {all: tezuka, base: none}\n").busts)
    EXPECT_EQ(bust.label, "");
}

TEST(load_spec, ends_a_clip_with_its_last_key_or_as_told) {
  EXPECT_EQ(load_text("mien: 1\nclip: {keys: [{at: 0s}, {at: 3s}]}\n").clip.length_s, 3);
  EXPECT_EQ(load_text("mien: 1\nclip: {turn: [{at: 2s}], camera: [{at: 4s}]}\n").clip.length_s, 4);
  EXPECT_EQ(load_text("mien: 1\nclip: {length: 36f, keys: [{at: 0s}, {at: 3s}]}\n").clip.length_s, 1.5);
}

TEST(load_spec, counts_frames_up_to_but_without_the_last_moment) {
  ClipSpec clip;
  for (const auto& [length_s, frames] :
       std::map<double, int>{{0, 1}, {0.01, 1}, {3, 72}, {2.4, 58}, {1.0 / 24, 1}}) {
    clip.length_s = length_s;
    EXPECT_EQ(count_frames(clip), frames) << length_s;
  }
}

TEST(load_spec, allows_as_many_frames_as_the_limit) {
  EXPECT_EQ(count_frames(load_text("mien: 1\nclip: {length: 100000f}\n").clip), kMaxFrames);
  EXPECT_EQ(count_frames(load_text("mien: 1\nclip: {fps: 7, length: 100000f}\n").clip), kMaxFrames);
}

TEST(load_spec, repeats_what_an_alias_names) {
  const Spec spec = load_text(R"(mien: 1
clip:
  keys:
    - {at: 0s, areas: &look {eyes: {side: 0.5}}}
    - {at: &end 2s, areas: *look}
  length: *end
)");
  EXPECT_EQ(spec.clip.keys[1].pose, spec.clip.keys[0].pose);
  EXPECT_EQ(spec.clip.length_s, 2);
}

TEST(load_spec, names_the_output_by_the_file) {
  const auto folder = make_test_folder();
  const std::map<std::string, std::string> names{{"hello.yaml", "hello"},
                                                 {"a b.v2.yaml", "a_b_v2"},
                                                 {"-rf.yaml", "_rf"},
                                                 {".yaml", "_yaml"},
                                                 {"caf\xc3\xa9.yml", "caf_"},
                                                 {"..yaml", "_"},
                                                 {"$(reboot).yaml", "__reboot_"},
                                                 {"plain", "plain"}};
  for (const auto& [file, name] : names) {
    write_file(folder / file, "mien: 1\n");
    EXPECT_EQ(load_spec(folder / file, *find_language()).name, name) << file;
  }
}

TEST(load_spec, takes_any_usual_line_ends_and_a_byte_order_mark) {
  EXPECT_EQ(load_text("\xEF\xBB\xBFmien: 1\r\ntitle: one\r\n").title, "one");
  EXPECT_EQ(load_text("mien: 1\rtitle: one\r").title, "one");
  EXPECT_EQ(load_text("%YAML 1.2\n---\nmien: 1\ntitle:\tone\n...\n").title, "one");
}

TEST(load_spec, loads_every_example_and_the_starter) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kData / "configs")) {
    if (entry.path().extension() != ".yaml") continue;
    ++count;
    EXPECT_EQ(find_mistakes(entry.path()), "");
  }
  EXPECT_GE(count, 8);
  const std::string starter = read_file(kData / "templates/new.yaml");
  EXPECT_EQ(load_text(fill_template(starter, {{"name", "mine"}}, "new.yaml")).title, "mine");
}

TEST(load_spec, says_hello_in_48_drawings) {
  const Spec spec = load_spec(kData / "configs/hello.yaml", *find_language());
  EXPECT_EQ(count_frames(spec.clip), 96);
  EXPECT_EQ(spec.clip.draw, 2);
  EXPECT_EQ(spec.render.width_px, 480);
  EXPECT_EQ(spec.render.height_px, 600);
  EXPECT_EQ(spec.clip.keys.front().pose, spec.clip.keys.back().pose);
  ASSERT_EQ(spec.busts.size(), 1u);
  EXPECT_EQ(spec.busts[0].expression.name, "laugh");
}

TEST(load_spec, a_named_skin_brings_its_colours_and_what_is_said_stands_above_them) {
  Findings findings;
  const auto looks = load_head_words(kData, findings).looks;
  ASSERT_EQ(looks.size(), 5u);
  for (std::size_t i = 1; i < looks.size(); ++i)
    EXPECT_LT(looks[i].second.skin.y, looks[i - 1].second.skin.y) << looks[i].first;  // from light to dark
  const Look deep = load_text("mien: 1\nhead: {look: {iris: \"#ffffff\", skin: deep}}\n").head.look;
  EXPECT_EQ(deep.skin, looks.back().second.skin);
  EXPECT_EQ(deep.hair, looks.back().second.hair);
  EXPECT_EQ(deep.iris, glm::vec3(1));
}

TEST(load_spec, spots_of_the_skin_are_dials) {
  EXPECT_EQ(load_text("mien: 1\n").head.look.freckles, 0);
  const Look look = load_text("mien: 1\nhead: {look: {freckles: 0.6, age_spots: 0.3}}\n").head.look;
  EXPECT_EQ(look.freckles, 0.6);
  EXPECT_EQ(look.age_spots, 0.3);
  const auto folder = make_test_folder();
  write_file(folder / "bad.yaml", "mien: 1\nhead: {look: {freckles: 1.5}}\n");
  EXPECT_THAT(find_mistakes(folder / "bad.yaml", kData),
              testing::HasSubstr(
                  "bad.yaml:2:25: error: 'head.look.freckles' is '1.5'; expected a number from 0 to 1"));
}

TEST(load_spec, hair_and_brows_grey_with_age_where_the_author_gave_no_colour) {
  const auto look_at_age = [](const char* head) {
    const HeadSpec spec = load_text(fmt::format("mien: 1\nhead: {}\n", head)).head;
    return compute_aged_look(spec.look, spec.age);
  };
  const auto find_chroma = [](const glm::vec3& srgb) {
    return std::max({srgb.r, srgb.g, srgb.b}) - std::min({srgb.r, srgb.g, srgb.b});
  };
  const Look adult = look_at_age("{age: adult}"), half = look_at_age("{age: {adult: 0.5, old: 0.5}}"),
             old = look_at_age("{age: old}");
  EXPECT_EQ(adult.hair, Look{}.hair);
  EXPECT_EQ(adult.brow, Look{}.brow);
  EXPECT_GT(half.hair.g, adult.hair.g + 0.1f);
  EXPECT_GT(old.hair.g, half.hair.g + 0.1f);
  EXPECT_GT(old.brow.g, half.brow.g + 0.05f);
  EXPECT_LT(find_chroma(old.hair), 0.5f * find_chroma(adult.hair));
  // What is given stays; a named hair brings its brows, a skin's own hair was not given.
  EXPECT_EQ(look_at_age("{age: old, look: {hair: red}}").hair, look_at_age("{look: {hair: red}}").hair);
  EXPECT_EQ(look_at_age("{age: old, look: {hair: red}}").brow, look_at_age("{look: {hair: red}}").brow);
  EXPECT_EQ(look_at_age("{age: old, look: {brow: \"#203040\"}}").brow, glm::vec3(32, 48, 64) / 255.0f);
  EXPECT_EQ(look_at_age("{age: old, look: {brow: \"#203040\"}}").hair, old.hair);
  EXPECT_GT(look_at_age("{age: old, look: {skin: deep}}").hair.g, 0.4f);
  EXPECT_GT(look_at_age("{age: old, random: 7}").hair.g, look_at_age("{random: 7}").hair.g + 0.1f);
}

TEST(load_spec, age_spots_come_with_age_where_the_author_said_nothing_of_them) {
  const auto count = [](const std::string& head) {
    const Spec spec = load_text("mien: 1\nhead: {" + head + "}\n");
    return compute_aged_look(spec.head.look, spec.head.age).age_spots;
  };
  const double old = count("age: old");
  EXPECT_GT(old, 0.3);
  EXPECT_EQ(count("age: adult"), 0);
  EXPECT_NEAR(count("age: {adult: 0.5, old: 0.5}"), old / 2, 1e-9);
  EXPECT_EQ(count("age: old, look: {age_spots: 0}"), 0);
  EXPECT_EQ(count("age: old, look: {age_spots: 0.1, skin: deep}"), 0.1);
  EXPECT_EQ(count("age: old, look: {skin: porcelain}"), old);
}

TEST(load_spec, a_named_hair_brings_its_brows_and_a_beard_stands_beside_a_named_skin) {
  Findings findings;
  const auto colours = load_head_words(kData, findings).hair_colours;
  const auto grey = std::ranges::find(colours, "grey", [](const auto& named) { return named.first; });
  ASSERT_NE(grey, colours.end());
  const Look look = load_text("mien: 1\nhead: {look: {beard: short, hair: grey, skin: deep}}\n").head.look;
  EXPECT_EQ(look.hair, grey->second.hair);
  EXPECT_EQ(look.brow, grey->second.brow);
  EXPECT_EQ(look.beard, "short");
  const Look own = load_text("mien: 1\nhead: {look: {hair: grey, brow: \"#000000\"}}\n").head.look;
  EXPECT_EQ(own.brow, glm::vec3(0));
}

TEST(load_spec, knows_the_features_of_the_data) {
  const auto folder = make_test_folder();
  std::filesystem::create_directories(folder / "configs");
  std::filesystem::copy(kData / "configs/expressions", folder / "configs/expressions");
  std::filesystem::create_directories(folder / "templates");
  std::filesystem::copy(kData / "templates/speech", folder / "templates/speech");
  write_file(folder / "templates/head/features.yaml",
             "features:\n  nose_length: {mm: 3}\n  mouth_width: {mm: 5}\n");
  write_file(folder / "good.yaml", "mien: 1\nhead: {features: {nose_length: 0.3, mouth_width: -1}}\n");
  EXPECT_EQ(load_spec(folder / "good.yaml", *find_language(folder)).head.features,
            (std::map<std::string, double>{{"mouth_width", -1}, {"nose_length", 0.3}}));
  write_file(folder / "bad.yaml", "mien: 1\nhead: {features: {nose_lenght: 0.3, ears: 1, mouth_width: 2}}\n");
  EXPECT_EQ(
      find_mistakes(folder / "bad.yaml", folder),
      R"(bad.yaml:2:19: error: unknown feature 'nose_lenght' in 'head.features'; did you mean 'nose_length'?
  head: {features: {nose_lenght: 0.3, ears: 1, mouth_width: 2}}
                    ^
bad.yaml:2:37: error: unknown feature 'ears' in 'head.features'; known: nose_length, mouth_width
  head: {features: {nose_lenght: 0.3, ears: 1, mouth_width: 2}}
                                      ^
bad.yaml:2:59: error: 'head.features.mouth_width' is '2'; expected a number from -1 to 1
  head: {features: {nose_lenght: 0.3, ears: 1, mouth_width: 2}}
                                                            ^)");
  std::filesystem::remove(folder / "templates/head/features.yaml");
  EXPECT_EQ(find_mistakes(folder / "good.yaml", folder).substr(0, 87),
            "good.yaml:2:19: error: unknown feature 'nose_length' in 'head.features'; none is known ");
}

TEST(load_spec, takes_limits_of_the_head_by_side_or_both) {
  for (const std::string order : {"brow.left.up: 0.8, brows.up: 1.2", "brows.up: 1.2, brow.left.up: 0.8"}) {
    const Spec spec = load_text("mien: 1\nhead: {limits: {" + order + ", chin.down: 0}}\n");
    EXPECT_EQ(spec.head.limits, (std::map<std::string, double>{
                                    {"brow.left.up", 0.8}, {"brow.right.up", 1.2}, {"chin.down", 0}}));
  }
}

}  // namespace
}  // namespace mien

// What a drawing is made from tells its picture: no two that differ may share it.
#include "clip/known_drawings.hpp"

#include <gtest/gtest.h>

#include "config/config_fixture.hpp"
#include "render/scratch.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

// The words of a file that can be put in another's place.
constexpr const char* kFile = R"(mien: 1
title: Known
head: {age: adult}
expressions: {mine: {lips: {upper: 0.3}}}
clip:
  fps: 8
  length: 0.5s
  blinks: [0.125s]
  camera: [{at: 0s, angle: 10}]
  light: [{at: 0s, set: studio}]
  background: [{at: 0s, show: studio}]
  keys:
    - {at: 0s, express: neutral}
    - {at: 0.25s, express: mine}
render: {size: 24x30, quality: draft}
)";

// Each puts one thing in the place of another; what moves, and nothing else, may leave some drawings alike.
constexpr std::pair<const char*, const char*> kEdits[] = {
    {"title: Known", "title: Other"},
    {"age: adult", "age: child"},
    {"age: adult", "age: adult, skull: {square: 0.5}"},
    {"age: adult", "age: adult, character: 1"},
    {"age: adult", "age: adult, features: {nose_width: 0.5}"},
    {"age: adult", "age: adult, look: {skin: \"#805030\"}"},
    {"age: adult", "age: adult, look: {iris: \"#204010\"}"},
    {"age: adult", "age: adult, hair: crop"},
    {"age: adult", "age: adult, look: {beard: short}"},
    {"age: adult", "age: adult, limits: {lids.upper: 0.5}"},
    {"age: adult", "age: adult, random: 3"},
    {"age: adult", "age: adult, design: comic"},
    {"upper: 0.3", "upper: 0.5"},
    {"at: 0.25s", "at: 0.375s"},
    {"blinks: [0.125s]", "blinks: [0.25s]"},
    {"angle: 10", "angle: 10, height: 5"},
    {"angle: 10", "angle: 10, lens: 50"},
    {"angle: 10", "angle: 10, look_at: nose_tip"},
    {"set: studio", "set: candle"},
    {"set: studio", "set: studio, angle: 30"},
    {"show: studio", "show: dark"},
    {"show: studio", "show: \"#203040\""},
    {"24x30", "30x24"},
    {"quality: draft", "quality: good"},
    {"quality: draft", "quality: draft, style: plaster"},
    {"quality: draft", "quality: draft, style: ink"},
    {"quality: draft", "quality: draft, style: ink, line: 2"},
    {"length: 0.5s", "length: 0.5s\n  head: [{at: 0s}, {at: 0.5s, age: child}]"},
};

TEST(known_drawings, share_an_origin_only_with_what_is_the_same_picture) {
  std::map<std::string, std::string> key_of, text_of;  // by origin
  std::size_t drawings = 0, shared = 0;
  const auto take = [&](const std::string& text) {
    Clip clip = build_clip(load_text(text));
    plan_drawings(clip);
    const Cast cast = build_cast(clip, shipped().heads);
    SceneRun run(clip, cast, shipped(), 1);
    const std::vector<std::string> origins = list_origins(run);
    ASSERT_EQ(origins.size(), clip.plan.drawings.size());
    for (std::size_t i = 0; i < origins.size(); ++i) {
      ++drawings;
      const std::string key = compute_scene_key(run, i, 0);
      const auto [found, is_new] = key_of.emplace(origins[i], key);
      text_of.emplace(origins[i], text);
      EXPECT_EQ(found->second, key) << text << "\nand\n" << text_of[origins[i]];
      shared += is_new ? 0 : 1;
    }
  };
  take(kFile);
  for (const auto& [before, after] : kEdits) {
    std::string text = kFile;
    text.replace(text.find(before), std::string(before).size(), after);
    take(text);
  }
  EXPECT_GT(drawings, 80u);
  EXPECT_GT(shared, 4u) << "another title makes no other drawing, and a moved key leaves some";
}

TEST(known_drawings, are_read_back_and_forgotten_with_their_pictures) {
  const Scratch scratch;
  const PictureStore store{scratch.path / "store"};
  const std::string a(16, 'a'), b(16, 'b'), c(16, 'c');
  EXPECT_TRUE(read_known_drawings(store).empty());
  write_known_drawings(store, {{a, b}, {b, c}}, {b});
  EXPECT_EQ(read_known_drawings(store), (KnownDrawings{{a, b}})) << "c has no picture and is not in use";
  write_file(store.picture(c), "a picture");
  write_known_drawings(store, {{a, b}, {b, c}}, {});
  EXPECT_EQ(read_known_drawings(store), (KnownDrawings{{b, c}}));
  const std::string whole = read_file(store.folder / kKnownDrawings);
  write_file(store.folder / kKnownDrawings,
             "damaged\n" + a + " ../../etc/passwd\n" + whole + b + " " + a + "\n" + a);
  EXPECT_EQ(read_known_drawings(store), (KnownDrawings{{b, c}})) << "of a damaged one what is whole";
  // One byte that is another hexadecimal digit would name another's picture.
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
    write_file(store.folder / kKnownDrawings, damaged);
    EXPECT_TRUE(read_known_drawings(store).empty()) << at;
  }
  Cleaned cleaned;
  clean_store(store, cleaned);
  EXPECT_FALSE(std::filesystem::exists(store.folder));
  write_file(store.folder, "no folder");
  EXPECT_NO_THROW(write_known_drawings(store, {{a, b}}, {b}));
}

}  // namespace
}  // namespace mien

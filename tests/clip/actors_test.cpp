// Several on one stage: whose parts are whose, and the same bytes from any number of threads.
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "clip/scenes.hpp"
#include "config/config_fixture.hpp"
#include "frames/place.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

constexpr const char* kTwo = R"(mien: 1
actors:
  ann:
    head: {age: infant}
    place: {at: [-120mm, 0, 0], turn: 25deg}
    clip:
      head: [{at: 0s}, {at: 0.1s, age: child}]
  bob:
    place: {at: [120mm, 30mm, 0], turn: -25deg}
    clip: {keys: [{at: 0s}, {at: 0.1s, express: smile}]}
clip: {fps: 30, length: 0.1s}
)";

Clip plan_two(const std::filesystem::path& folder) {
  Options options;
  options.file = folder / "two.yaml";
  options.output = folder / "out";
  write_file(options.file, kTwo);
  return plan_clip(options, *shipped().stock.language);
}

std::string read_scenes(const std::filesystem::path& folder) {
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "out/scenes"))
    if (entry.path().extension() != ".ini") files.insert(entry.path());  // that one names its folder
  std::string all;
  for (const auto& file : files) all += file.filename().string() + "\n" + read_file(file);
  return all;
}

TEST(actors, scenes_are_the_same_from_any_number_of_threads) {
  std::vector<std::string> scenes;
  std::vector<std::vector<std::string>> keys;
  for (const int jobs : {1, 4}) {
    const auto folder = make_test_folder(std::to_string(jobs));
    const Clip clip = plan_two(folder);
    keys.push_back(write_scenes(clip, build_cast(clip, shipped().heads), shipped(), jobs, [](int) {}));
    scenes.push_back(read_scenes(folder));
  }
  EXPECT_EQ(keys[0], keys[1]);
  EXPECT_EQ(std::set(keys[0].begin(), keys[0].end()).size(), 3u)
      << "a head that changed makes another picture";
  EXPECT_EQ(scenes[0], scenes[1]);
}

// What a kept frame is told by.
TEST(scenes, have_another_key_where_another_picture_is_asked_for) {
  const auto list_keys = [](const std::string& head, const std::string& face, const std::string& render) {
    const auto folder = make_test_folder();
    Options options;
    options.file = folder / "one.yaml";
    options.output = folder / "out";
    write_file(options.file, "mien: 1\nhead: {" + head + "}\nclip: {keys: [{at: 0s, express: " + face +
                                 "}]}\nrender: {" + render + "}\n");
    const Clip clip = plan_clip(options, *shipped().stock.language);
    return write_scenes(clip, build_cast(clip, shipped().heads), shipped(), 1, [](int) {});
  };
  const std::string look = "look: {skin: \"#d0a080\"}", size = "size: 48x60, quality: draft";
  const std::vector<std::string> first = list_keys(look, "smile", size);
  ASSERT_EQ(first.size(), 1u);
  EXPECT_EQ(list_keys(look, "smile", size), first);
  EXPECT_NE(list_keys(look, "smile", "size: 96x120, quality: draft"), first) << "of the same shape";
  EXPECT_NE(list_keys(look, "smile", "size: 48x60, quality: good"), first);
  EXPECT_NE(list_keys(look, "smile", size + ", background: dark"), first);
  EXPECT_NE(list_keys(look, "anger", size), first);
  EXPECT_NE(list_keys("look: {skin: \"#d0a081\"}", "smile", size), first);
  // Of a head that changes, what the frames' own text does not say.
  const auto growing = [&](const std::string& skin) {
    return list_keys(
        look, "smile}], length: 0.1s, head: [{at: 0s}, {at: 0.1s, look: {skin: \"" + skin + "\"}", size);
  };
  EXPECT_NE(growing("#808080").back(), growing("#808090").back());
}

TEST(actors, parts_do_not_collide_and_stand_in_their_places) {
  const auto folder = make_test_folder();
  const Clip clip = plan_two(folder);
  const Cast cast = build_cast(clip, shipped().heads);
  write_scenes(clip, cast, shipped(), 1, [](int) {});
  const std::string include = read_file(folder / "out/scenes/head.inc"),
                    heads = read_file(folder / "out/scenes/h0001.inc"),
                    frame = read_file(folder / "out/scenes/f0001.pov");
  EXPECT_NE(include.find("#macro surface_of_skin_of_bob()"), std::string::npos);
  EXPECT_EQ(include.find("_of_ann"), std::string::npos) << "her head changes";
  EXPECT_NE(heads.find("#macro surface_of_skin_of_ann()"), std::string::npos);
  EXPECT_EQ(heads.find("_of_bob"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder / "out/scenes/h0003.inc"));
  for (const char* word : {"#include \"h0001.inc\"", "surface_of_skin_of_ann()", "surface_of_skin_of_bob()",
                           "part_eye_left_of_ann", "part_eye_left_of_bob"})
    EXPECT_NE(frame.find(word), std::string::npos) << word;

  // Each eye is moved by a matrix, whose tenth number is the shift along x.
  const auto find_x_mm = [&](const std::string& part) {
    std::istringstream in(frame.substr(frame.find("matrix <", frame.find(part)) + 8));
    std::string number;
    for (int i = 0; i < 10; ++i) std::getline(in, number, ',');
    return std::stod(number);
  };
  EXPECT_LT(find_x_mm("part_eye_left_of_ann"), -60);
  EXPECT_GT(find_x_mm("part_eye_left_of_bob"), 60);

  ASSERT_EQ(cast.figures.size(), 2u);
  ASSERT_NE(cast.figures[1], nullptr);
  const Figure& bob = *cast.figures[1];
  DeformBuffers buffers;
  Drawing drawing;
  deform_figure(bob, {}, {}, buffers, drawing);
  place_drawing(find_place(clip.actors[1].place), drawing);
  const Box skin = compute_bounds(drawing.parts.front().positions);
  EXPECT_NEAR((skin.low.x + skin.high.x) / 2, 120, 40);
  EXPECT_NEAR(skin.high.y, compute_bounds(bob.head.skin.positions).high.y + 30, 1e-3);
}

TEST(actors, are_all_framed) {
  const Clip clip = plan_two(make_test_folder());
  const Cast cast = build_cast(clip, shipped().heads);
  const CameraView view = compute_view(cast.framing, {}, {}, clip.spec.render);
  EXPECT_GT(view.frame_width_mm, 380) << "two heads, 240 mm from middle to middle";
  Options options;
  EXPECT_THROW(find_actor(clip, options), InputError);
  options.actor = "bob";
  EXPECT_EQ(find_actor(clip, options).name, "bob");
  options.actor = "bib";
  try {
    find_actor(clip, options);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(format_error(error), "error: --actor: unknown actor 'bib'; did you mean 'bob'?");
  }
}

}  // namespace
}  // namespace mien

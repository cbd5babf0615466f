#include "clip/figure_store.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/text.hpp"

namespace mien {
namespace {

namespace fs = std::filesystem;

TEST(figure_store, another_head_or_colour_is_another_key) {
  std::vector<HeadSpec> heads(9);
  heads[1].age = {{"child", 1.0}};
  heads[2].hair = "bob";
  heads[3].limits["brow.left.up"] = 0.5;
  heads[4].sculpt.push_back({"prn", {0, 0, 1}, 20});
  heads[5].look.is_brow_given = true;
  heads[6].look.freckles = 0.5;
  heads[7].character = 1;
  heads[8].features["nose_length"] = 0.3;
  std::set<std::string> keys;
  for (const HeadSpec& head : heads) keys.insert(compute_figure_key(head, {}, ""));
  RenderSpec ink, blue;
  ink.style = blue.style = Style::ink;
  blue.ink.line = {0, 0, 1};
  for (const RenderSpec& render : {ink, blue}) keys.insert(compute_figure_key({}, render, ""));
  keys.insert(compute_figure_key({}, {}, "ann"));
  EXPECT_EQ(keys.size(), heads.size() + 3);
  EXPECT_EQ(compute_figure_key(heads[4], ink, "ann"), compute_figure_key(heads[4], ink, "ann"));
}

TEST(figure_store, a_scan_or_its_landmarks_written_anew_is_another_key) {
  const fs::path folder = fs::path(testing::TempDir()) / "figure_store";
  fs::remove_all(folder);
  HeadSpec head;
  head.scan = FileReference{folder / "face.obj", {}};
  std::set<std::string> keys{compute_figure_key(head, {}, "")};  // not there yet
  for (const char* name : {"face.obj", "face.yaml", "face.obj", "face.yaml"}) {
    const fs::path file = folder / name;
    write_file(file, std::string(keys.size(), '#'));
    keys.insert(compute_figure_key(head, {}, ""));
  }
  EXPECT_EQ(keys.size(), 5u);
}

TEST(figure_store, keeps_the_ones_used_last) {
  FigureStore store;
  store.most = 2;
  int built = 0;
  const auto take = [&](const char* key) {
    return take_figure(store, key, [&] {
      ++built;
      return std::make_shared<const DrawnFigure>();
    });
  };
  const FigurePointer a = take("a");
  take("b");
  EXPECT_EQ(take("a"), a);
  take("c");  // b goes
  EXPECT_EQ(take("a"), a);
  EXPECT_EQ(built, 3);
  take("b");
  EXPECT_EQ(built, 4);
}

}  // namespace
}  // namespace mien

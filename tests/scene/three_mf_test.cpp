// 3MF packages: the same bytes every time, read by others as what they are.
#include "scene/three_mf.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "core/error.hpp"
#include "core/text.hpp"
#include "scene/mesh_files.hpp"
#include "scene/stl.hpp"
#include "solids.hpp"

namespace mien {
namespace {

using testing::HasSubstr;

std::vector<PrintObject> list_objects() {
  return {
      {"box", build_box({0, 0, 0}, {10, 10, 20}), {{"skin", {1, 0.5f, 0}, 0, 8}, {"eye", {0, 0, 1}, 8, 4}}},
      {"ball <&> \"x\"", build_ball({30, 5, 10}, 10, 12), {}}};
}

TEST(three_mf, is_the_same_and_says_unit_title_and_colours) {
  const std::string one = build_3mf("A & B", list_objects());
  EXPECT_EQ(one, build_3mf("A & B", list_objects()));
  EXPECT_THAT(one, HasSubstr("unit=\"millimeter\""));
  EXPECT_THAT(one, HasSubstr("<metadata name=\"Title\">A &#38; B</metadata>"));
  EXPECT_THAT(one, HasSubstr("<base name=\"skin\" displaycolor=\"#FF8000\"/>"));
  EXPECT_THAT(one, HasSubstr("name=\"ball &#60;&#38;&#62; &#34;x&#34;\""));
  EXPECT_THAT(one, HasSubstr("pid=\"1\" p1=\"1\""));
}

TEST(three_mf, odd_text_is_no_markup) {
  const std::string odd = build_3mf("</metadata>\n\xFF\xED\xA0\x80\xF0\x9F\x98\x80", list_objects());
  EXPECT_THAT(odd, HasSubstr(">&#60;/metadata&#62; ????\xF0\x9F\x98\x80</metadata>"));
}

TEST(three_mf, a_slicer_reads_it) {
  if (std::system("command -v prusa-slicer >/dev/null") != 0) GTEST_SKIP() << "prusa-slicer is not installed";
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "mien_3mf";
  write_file(folder / "two.3mf", build_3mf("two", list_objects()));
  const std::string command =
      fmt::format("cd '{}' && prusa-slicer --info two.3mf >info 2>&1", folder.string());
  EXPECT_EQ(std::system(command.c_str()), 0) << read_file(folder / "info");
  const std::string info = read_file(folder / "info");
  EXPECT_THAT(info, HasSubstr("manifold = yes"));
  EXPECT_THAT(info, HasSubstr("size_z = 20.0"));
  EXPECT_THAT(info, Not(HasSubstr("manifold = no")));
}

TEST(three_mf, no_number_no_file) {
  std::vector<PrintObject> objects = list_objects();
  objects[0].mesh.positions[3].y = NAN;
  EXPECT_THROW(build_3mf("x", objects), RunError);
}

TEST(binary_stl, is_read_back_as_it_was) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "mien_3mf";
  write_file(folder / "ball.stl", build_binary_stl(build_ball({30, 5, 10}, 10, 12), "a\nball"));
  const StlFacts facts = check_stl(folder / "ball.stl");
  EXPECT_EQ(facts.parts, 1u);
  EXPECT_EQ(facts.open_edges, 0u);
  EXPECT_NEAR(facts.volume_mm3, compute_volume_mm3(build_ball({30, 5, 10}, 10, 12)), 0.01);
}

}  // namespace
}  // namespace mien

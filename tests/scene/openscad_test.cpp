#include "scene/openscad.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "core/error.hpp"
#include "core/text.hpp"
#include "places.hpp"
#include "render/process.hpp"
#include "render/scratch.hpp"
#include "solids.hpp"

namespace mien {
namespace {

using testing::HasSubstr;

const std::filesystem::path kTemplates = std::filesystem::path(source_folder()) / "templates";

bool has_program(const char* name) {
  return std::system(fmt::format("command -v {} >/dev/null 2>&1", name).c_str()) == 0;
}

// A box 12.6 high with a ball through its front: what a bust is to OpenSCAD, in small.
BustPrint build_small_bust() {
  BustPrint bust;
  bust.title = "A small one";
  bust.height_mm = 20;
  bust.base_height_mm = 8;
  bust.base_radius_mm = 10;
  bust.foot_mm = 2;
  bust.foot_radius_mm = 4;
  bust.solids.push_back({"skin", build_box({-5, -4, 0}, {5, 4, 12.6f})});
  bust.solids.push_back({"eye_left", build_ball({2, -4, 8}, 2, 10)});
  return bust;
}

std::string fail_to_build(const BustPrint& bust) {
  try {
    build_openscad_bust(bust, kTemplates);
  } catch (const RunError& e) {
    return e.what();
  }
  return "nothing was thrown";
}

// OpenSCAD's STL of `source`, and what it said.
struct Printed {
  ProcessResult result;
  StlFacts facts;
};

Printed print_source(const Scratch& scratch, const std::string& source, std::vector<std::string> more = {}) {
  write_file(scratch.path / "bust.scad", source);
  std::vector<std::string> command =
      list_openscad_command(scratch.path / "bust.scad", scratch.path / "bust.stl");
  command.insert(command.end() - 1, more.begin(), more.end());
  Printed printed;
  printed.result = run_process(command, scratch.path);
  if (printed.result.exit_code == 0) printed.facts = check_stl(scratch.path / "bust.stl");
  return printed;
}

TEST(openscad, prints_one_closed_part_as_high_as_asked) {
  if (!has_program("openscad")) GTEST_SKIP() << "openscad is not installed";
  const Scratch scratch;
  const BustPrint bust = build_small_bust();
  const Printed printed = print_source(scratch, build_openscad_bust(bust, kTemplates));
  EXPECT_EQ(printed.result.exit_code, 0) << printed.result.output;
  EXPECT_EQ(find_openscad_complaint(printed.result.output), "");
  EXPECT_NO_THROW(verify_print(bust, printed.facts, "bust"));
  EXPECT_FLOAT_EQ(printed.facts.box.low.x, -10);  // the base
  EXPECT_FLOAT_EQ(printed.facts.box.high.z, 20);

  if (has_program("prusa-slicer")) {
    const ProcessResult slicer = run_process({"prusa-slicer", "--info", "bust.stl"}, scratch.path);
    EXPECT_THAT(slicer.output, HasSubstr("manifold = yes"));
    EXPECT_THAT(slicer.output, HasSubstr("number_of_parts =  1"));
  }
  if (has_program("admesh")) {
    const ProcessResult admesh = run_process({"admesh", "bust.stl"}, scratch.path);
    EXPECT_THAT(admesh.output, HasSubstr("Total disconnected facets        :     0"));
    EXPECT_THAT(admesh.output, HasSubstr("Facets reversed       :     0"));
  }
}

TEST(openscad, keeps_its_word_when_the_customizer_changes_it) {
  if (!has_program("openscad")) GTEST_SKIP() << "openscad is not installed";
  const Scratch scratch;
  const std::string source = build_openscad_bust(build_small_bust(), kTemplates);
  const Printed higher = print_source(scratch, source, {"-D", "height_mm=50", "-D", "base_height_mm=12"});
  EXPECT_FLOAT_EQ(higher.facts.box.high.z, 50);
  EXPECT_EQ(higher.facts.parts, 1U);
  const Printed bare = print_source(scratch, source, {"-D", "base=false"});
  EXPECT_FLOAT_EQ(bare.facts.box.low.z, 0);
  EXPECT_FLOAT_EQ(bare.facts.box.high.z, 20);
  EXPECT_EQ(bare.facts.parts, 1U);
  EXPECT_EQ(bare.facts.open_edges, 0U);
  const Printed none = print_source(scratch, source, {"-D", "height_mm=0"});
  EXPECT_EQ(none.result.exit_code, 1);
  EXPECT_THAT(find_openscad_complaint(none.result.output), HasSubstr("height_mm must be above 0"));
}

TEST(openscad, notices_a_solid_that_openscad_dropped) {
  if (!has_program("openscad")) GTEST_SKIP() << "openscad is not installed";
  const Scratch scratch;
  std::string source = build_openscad_bust(build_small_bust(), kTemplates);
  const std::size_t face = source.find("[0,2,1],");  // the first of the skin, clockwise
  ASSERT_NE(face, std::string::npos);
  source.erase(face, 8);
  const Printed printed = print_source(scratch, source);
  EXPECT_THAT(find_openscad_complaint(printed.result.output), HasSubstr("mesh is not closed"));
}

TEST(openscad, faces_run_clockwise_and_end_with_their_solid) {
  const std::string source = build_openscad_bust(build_small_bust(), kTemplates);
  const std::string skin =
      source.substr(source.find("module skin()"), 200);  // short, so that a failure can be read
  EXPECT_THAT(skin, HasSubstr("polyhedron(convexity = 12,\n  points = [\n    [-5,-4,0], [-5,4,0], [5,4,0],"));
  EXPECT_THAT(skin, HasSubstr("faces = [\n    [0,2,1], [0,3,2],"));  // {0, 1, 2}, {0, 2, 3} turned round
  EXPECT_NE(source.find("  place() skin();\n  place() eye_left();\n"), std::string::npos);
  EXPECT_NE(source.find("height_mm = 20; // [20:1:400]"), std::string::npos);
  EXPECT_TRUE(source == build_openscad_bust(build_small_bust(), kTemplates));
}

TEST(openscad, refuses_what_openscad_would_not_tell) {
  BustPrint bust = build_small_bust();
  bust.solids[1].mesh.triangles.pop_back();
  EXPECT_EQ(fail_to_build(bust), "solid 'eye_left' has 3 open edges; OpenSCAD would drop it");
  bust = build_small_bust();
  for (Triangle& t : bust.solids[0].mesh.triangles) std::swap(t[1], t[2]);
  EXPECT_EQ(fail_to_build(bust), "solid 'skin' is inside out");
  bust = build_small_bust();
  bust.solids[0].mesh = {};
  EXPECT_EQ(fail_to_build(bust), "solid 'skin' is empty");
  for (const char* name : {"", "Skin", "1st", "cube(9);", "sk in"}) {
    bust = build_small_bust();
    bust.solids[0].name = name;
    EXPECT_EQ(fail_to_build(bust), fmt::format("solid name '{}' is not a lower-case identifier", name));
  }
}

TEST(openscad, title_is_never_code) {
  BustPrint bust = build_small_bust();
  bust.title = "x\ncube(99);\r*/ cube(98); /* [Tab] */ {{modules}} \\ \"é";
  const std::string source = build_openscad_bust(bust, kTemplates);
  EXPECT_EQ(source.substr(0, source.find('\n')), "// x cube(99);    cube(98);    [Tab]      modules     \"é");
  bust.title.assign(10000, 'a');
  EXPECT_EQ(build_openscad_bust(bust, kTemplates).find('\n'), 3U + 120);
  bust.title.assign(119, 'a');  // the cut falls into a letter of two bytes
  bust.title += "é";
  EXPECT_EQ(build_openscad_bust(bust, kTemplates).substr(0, 123), "// " + std::string(119, 'a') + "\n");
}

TEST(openscad, welds_at_the_written_decimals) {
  BustPrint bust = build_small_bust();
  Mesh& skin = bust.solids[0].mesh;
  // A crack at corner 7, narrower than the decimals.
  skin.positions.push_back(skin.positions[7] + glm::vec3(1e-6f, 0, 0));
  for (Triangle& t : skin.triangles)
    for (std::uint32_t& v : t)
      if (v == 7 && t != Triangle{4, 5, 7}) v = 8;
  EXPECT_TRUE(build_openscad_bust(bust, kTemplates) == build_openscad_bust(build_small_bust(), kTemplates));
}

TEST(openscad, finds_the_complaint_in_what_openscad_said) {
  EXPECT_EQ(find_openscad_complaint(""), "");
  EXPECT_EQ(find_openscad_complaint("Geometries in cache: 1\n   Simple:        yes\n"), "");
  EXPECT_EQ(
      find_openscad_complaint("Compiling\nWARNING: Ignoring unknown module 'x' in file a.scad, line 3\nmore"),
      "WARNING: Ignoring unknown module 'x' in file a.scad, line 3");
  EXPECT_EQ(find_openscad_complaint("ERROR: The given mesh is not closed!"),
            "ERROR: The given mesh is not closed!");
  EXPECT_EQ(find_openscad_complaint("Current top level object is empty.\n"),
            "Current top level object is empty.");
}

TEST(openscad, verifies_parts_height_and_volume) {
  const BustPrint bust = build_small_bust();
  StlFacts good{.triangles = 100,
                .parts = 1,
                .open_edges = 0,
                .volume_mm3 = 2000,
                .box = {{-10, -10, 0}, {10, 10, 20}}};
  const auto complain = [&](const StlFacts& facts) -> std::string {
    try {
      verify_print(bust, facts, "bust_x.stl");
    } catch (const RunError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(complain(good), "");
  StlFacts bad = good;
  bad.parts = 2;
  EXPECT_EQ(complain(bad), "bust_x.stl is not one closed part: 100 triangles, 2 parts, 0 open edges");
  bad = good;
  bad.open_edges = 4;
  EXPECT_EQ(complain(bad), "bust_x.stl is not one closed part: 100 triangles, 1 parts, 4 open edges");
  EXPECT_EQ(complain({}), "bust_x.stl is not one closed part: 0 triangles, 0 parts, 0 open edges");
  bad = good;
  bad.box.high.z = 8;  // the base alone
  EXPECT_EQ(complain(bad), "bust_x.stl reaches from 0 to 8 mm; 0 to 20 mm were asked for");
  bad = good;
  bad.volume_mm3 = -2000;
  EXPECT_EQ(complain(bad),
            "bust_x.stl holds -2000 mm3; between 1008 and 3553.4 were expected: a solid was lost or turned");
}

}  // namespace
}  // namespace mien

// OpenSCAD sources: what stands in them, and what is refused.
#include "scene/openscad.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "scene/openscad_check.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

using testing::HasSubstr;
using testing::Not;

// A four-sided tower, open below, with grids that are not looked at.
PosableBust build_small_bust() {
  PosableBust bust;
  bust.title = "A small one";
  bust.expression = "smile";
  bust.rest = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 3}};
  bust.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  bust.foot = {3, 2, 1, 0};
  bust.states = {{{4}, {{0, 0, 0.5f}}}, {{}, {}}, {{}, {}}};
  for (const char* area : {"chin", "eye.left", "eye.right"}) {
    BustMove move;
    move.area = area;
    move.move = move.area == "chin" ? "down" : "up";
    move.meaning = "a move";
    move.values = {1};
    bust.moves.push_back(move);
  }
  bust.expressions = {{"smile", {0.5, 0, 0}, 1, 0, {}}, {"my own; cube(9)", {0, 0, 0}, 2, 0, {}}};
  for (BustGrid* grid : {&bust.eyes[0].grid, &bust.eyes[1].grid, &bust.mouth.grid}) {
    grid->upper = grid->lower = {0, 1};
    grid->first = 5;
    grid->rows = 1;
  }
  return bust;
}

std::string find_line(const std::string& text, const std::string& begin) {
  const std::size_t at = text.find("\n" + begin);
  return at == text.npos ? "" : text.substr(at + 1, text.find('\n', at + 1) - at - 1);
}

TEST(openscad, writes_vertices_with_what_moves_them_and_turned_faces) {
  const std::string source = build_openscad_bust(build_small_bust(), shipped_stock().templates);
  EXPECT_THAT(source, HasSubstr("[[-1,-1,0]], [[1,-1,0]], [[1,1,0]], [[-1,1,0]], [[0,0,3],[0],[[0,0,0.5]]]"));
  EXPECT_THAT(source, HasSubstr("triangles = [\n  [0,4,1], [1,4,2], [2,4,3], [3,4,0]]"));
  EXPECT_EQ(find_line(source, "chin_down ="), "chin_down = 0; // [-1:0.05:1]");
  EXPECT_EQ(find_line(source, "height_mm ="), "height_mm = 80; // [20:1:400]");
}

TEST(openscad, text_of_authors_is_never_code) {
  PosableBust bust = build_small_bust();
  bust.title = "x\ncube(99);\r*/ cube(98); /* [Tab] */ {{modules}} \\ \"é";
  const std::string source = build_openscad_bust(bust, shipped_stock().templates);
  EXPECT_EQ(source.substr(0, source.find('\n')), "// x cube(99);    cube(98);    [Tab]      modules     \"é");
  EXPECT_THAT(source, Not(HasSubstr("cube(9)")));
  EXPECT_EQ(find_line(source, "expression ="), "expression = \"smile\"; // [smile, my_own__cube_9_]");
  bust.title.assign(10000, 'a');
  EXPECT_EQ(build_openscad_bust(bust, shipped_stock().templates).find('\n'), 3U + 120);
  bust.title.assign(119, 'a');  // the cut falls into a letter of two bytes
  bust.title += "é";
  EXPECT_EQ(build_openscad_bust(bust, shipped_stock().templates).substr(0, 123),
            "// " + std::string(119, 'a') + "\n");
}

TEST(openscad, every_expression_has_a_name_of_its_own) {
  PosableBust bust = build_small_bust();
  bust.expressions = {
      {"1.2s", {0, 0, 0}, 1, 0, {}}, {"1;2s", {0, 0, 0}, 2, 0, {}}, {"", {0, 0, 0}, 1, 0, {}}};
  bust.expression = "1;2s";
  const std::string source = build_openscad_bust(bust, shipped_stock().templates);
  EXPECT_EQ(find_line(source, "expression ="), "expression = \"1_2s_2\"; // [1_2s, 1_2s_2, own]");
  bust.expression = "unknown";
  EXPECT_THROW(build_openscad_bust(bust, shipped_stock().templates), RunError);
}

TEST(openscad, refuses_an_open_bust) {
  PosableBust bust = build_small_bust();
  bust.triangles.pop_back();
  try {
    build_openscad_bust(bust, shipped_stock().templates);
    FAIL();
  } catch (const RunError& e) {
    EXPECT_STREQ(e.what(), "the bust is not closed: 3 open edges");
  }
}

TEST(openscad, hollow_is_always_offered) {
  PosableBust bust = build_small_bust();
  EXPECT_EQ(find_line(build_openscad_bust(bust, shipped_stock().templates), "hollow ="), "hollow = false;");
  bust.cavity.directions = {{1, 0}, {0, -1}};
  bust.cavity.heights_mm = {0, 1.5};
  bust.cavity.middles_mm = {0, 0.25};
  bust.cavity.walls = {{2, 1.4, {1, 0.5, 0.125, 0}}};
  bust.is_hollow = true;
  const std::string source = build_openscad_bust(bust, shipped_stock().templates);
  EXPECT_EQ(find_line(source, "hollow ="), "hollow = true;");
  EXPECT_EQ(find_line(source, "wall_mm ="), "wall_mm = 2; // [0.8:0.1:10]");
  EXPECT_EQ(find_line(source, "drain_mm ="), "drain_mm = 4; // [0:0.5:12]");
  EXPECT_THAT(source,
              HasSubstr("cavity_ways = [\n  [1, 0], [0, -1]];\ncavity_rows = [\n  [0, 0], [1.5, 0.25]];\n"
                        "cavities = [\n  [2, 1.4, [\n  [1,0.5],\n  [0.13,0]]]];\n"));
}

TEST(openscad, hears_every_complaint) {
  EXPECT_EQ(find_openscad_complaint("Geometries in cache: 1\nFacets: 12\n"), "");
  for (const char* line : {"WARNING: Ignoring unknown module 'x'", "ERROR: Parser error", "DEPRECATED: x",
                           "Can't open input file 'a.scad'!", "Current top level object is empty."})
    EXPECT_EQ(find_openscad_complaint(std::string("Compiling\n") + line + "\nmore\n"), line);
}

TEST(openscad, a_print_that_is_not_what_was_meant_is_refused) {
  StlFacts meant;
  meant.triangles = 10;
  meant.parts = 1;
  meant.volume_mm3 = 1000;
  meant.box = {{0, 0, 0}, {10, 10, 80}};
  const auto complain = [&](const StlFacts& facts) -> std::string {
    try {
      verify_print(meant, facts, "a.stl");
    } catch (const RunError& e) {
      return e.what();
    }
    return "";
  };
  StlFacts facts = meant;
  facts.volume_mm3 = 1009;
  EXPECT_EQ(complain(facts), "");
  facts.volume_mm3 = 1011;
  EXPECT_EQ(complain(facts), "a.stl holds 1011 mm3; 1000 were meant");
  facts = meant;
  facts.box.high.z = 79.9f;
  EXPECT_EQ(complain(facts), "a.stl reaches from 0 to 79.9 mm along z; 0 to 80 mm were meant");
  facts = meant;
  facts.parts = 2;
  facts.open_edges = 3;
  EXPECT_EQ(complain(facts), "a.stl is not one closed part: 10 triangles, 2 parts, 3 open edges");
}

}  // namespace
}  // namespace mien

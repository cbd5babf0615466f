// Labels: readable, cut to what fits, and never anything but letters.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "core/crossings.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "places.hpp"
#include "print/base.hpp"
#include "print/shapes.hpp"
#include "scene/openscad_numbers.hpp"
#include "scene/stl.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

const Letters& letters() {
  static const Letters loaded =
      build_letters(find_template(shipped_stock().templates, "openscad/letters.csv"));
  return loaded;
}

Base build_base(BaseShape shape, const std::string& label, double height = 8, double radius = 15) {
  Base base;
  base.shape = shape;
  base.height_mm = height;
  base.radius_mm = radius;
  base.label = label;
  return base;
}

TEST(glyphs, every_letter_is_within_its_box_and_joined) {
  for (const char32_t c : std::u32string(U"ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.,-+'!?&/:_() "))
    EXPECT_TRUE(letters().glyphs.contains(c)) << std::uint32_t(c);
  for (const auto& [code, glyph] : letters().glyphs)
    for (const Stroke& stroke : glyph.strokes)
      for (const glm::dvec2& p : stroke) {
        EXPECT_GE(p.x, 0) << char(code);
        EXPECT_LE(p.x, glyph.width) << char(code);
        EXPECT_GE(p.y, 0) << char(code);
        EXPECT_LE(p.y, 6) << char(code);
      }
}

TEST(glyphs, text_is_cut_to_what_fits) {
  const Label fits = set_label(letters(), "laugh", 4, 3, 40);
  EXPECT_FALSE(fits.is_cut);
  EXPECT_EQ(fits.text, "laugh");
  EXPECT_EQ(fits.size_mm, 4);
  EXPECT_GE(fits.pen_mm, 0.8);
  const Label smaller = set_label(letters(), "surprise", 6, 3, 30);
  EXPECT_FALSE(smaller.is_cut);
  EXPECT_LT(smaller.size_mm, 6);
  EXPECT_LE(smaller.width_mm, 30);
  const Label cut = set_label(letters(), std::string(10000, 'x'), 4, 3, 30);
  EXPECT_TRUE(cut.is_cut);
  EXPECT_LE(cut.width_mm, 30);
  EXPECT_GT(cut.text.size(), 4u);
  EXPECT_LT(cut.text.size(), 20u);
  const Label none = set_label(letters(), "x", 2, 3, 30);
  EXPECT_TRUE(none.is_cut);
  EXPECT_TRUE(none.strokes.empty());
}

TEST(glyphs, whatever_is_written_is_letters_or_boxes) {
  EXPECT_EQ(set_label(letters(), "a\nb\t", 4, 3, 40).text, "a b");
  const Label odd = set_label(letters(), "\"\xF0\x9F\x98\x80\xFF\\", 4, 3, 60);  // quote, emoji, no UTF-8
  EXPECT_EQ(odd.strokes.size(), 4 * letters().box.strokes.size());
  EXPECT_TRUE(set_label(letters(), "", 4, 3, 60).strokes.empty());
  EXPECT_FALSE(set_label(letters(), "", 4, 3, 60).is_cut);
  EXPECT_TRUE(set_label(letters(), "   ", 4, 3, 60).strokes.empty());
}

TEST(label, is_raised_from_the_front_of_every_base) {
  for (const BaseShape shape : {BaseShape::round, BaseShape::square, BaseShape::plinth})
    for (const char* text : {"LAUGH", "i", "surprise & joy, no. 1"}) {
      Mesh mesh = build_ball_on_neck(14, 8, 8, 6, 48, 0.9f), plain = mesh;
      const Loop foot = find_boundary_loops(mesh.triangles).front();
      append_base(plain, foot, build_base(shape, ""));
      append_base(mesh, foot, build_base(shape, text), letters());
      const std::string what = fmt::format("{} {}", int(shape), text);
      EXPECT_EQ(count_open_edges(mesh.triangles), 0u) << what;
      EXPECT_EQ(split_pieces(mesh).size(), 1u) << what;
      EXPECT_EQ(find_crossings(mesh.positions, mesh.triangles).size(), 0u) << what;
      const double added = compute_volume_mm3(mesh) - compute_volume_mm3(plain);
      const Label label = fit_label(build_base(shape, text), list_points(mesh, foot), letters());
      double length = 0;
      for (const Stroke& stroke : label.strokes)
        for (std::size_t i = 0; i + 1 < stroke.size(); ++i) length += glm::distance(stroke[i], stroke[i + 1]);
      // Strokes overlap where they meet, and have round ends.
      EXPECT_GT(added, 0.6 * 0.8 * length * label.pen_mm) << what;
      EXPECT_LT(added, 1.4 * 0.8 * (length + double(label.strokes.size()) * label.pen_mm) * label.pen_mm)
          << what;
      EXPECT_NEAR(compute_bounds(mesh.positions).low.y, compute_bounds(plain.positions).low.y - 0.8, 0.1)
          << what;
      EXPECT_LT(mesh.triangles.size() - plain.triangles.size(), 7000u) << what;
    }
}

TEST(label, a_base_too_low_has_none) {
  Mesh mesh = build_ball_on_neck(14, 8, 3, 6);
  const Loop foot = find_boundary_loops(mesh.triangles).front();
  const Base base = build_base(BaseShape::round, "LAUGH", 3);
  const Label label = fit_label(base, list_points(mesh, foot), letters());
  EXPECT_TRUE(label.is_cut);
  EXPECT_TRUE(label.strokes.empty());
  append_base(mesh, foot, base, letters());
  EXPECT_EQ(count_open_edges(mesh.triangles), 0u);
}

// A base alone, closed above: of OpenSCAD's making and of ours.
TEST(label, openscad_makes_it_of_the_same_letters) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "mien_label";
  ScadValues values = list_scad_base();
  values["letters"] = build_openscad_letters(letters());
  const std::string functions = fill_template(shipped_stock().templates, "openscad/base.scad", values);
  const Mesh open = build_ball_on_neck(14, 8, 8, 6);
  const Loop foot = find_boundary_loops(open.triangles).front();
  std::string points;
  for (const std::uint32_t v : foot)
    points += fmt::format("[{}, {}, 8],", format_number(open.positions[v].x, 6),
                          format_number(open.positions[v].y, 6));
  for (const auto& [shape, name] :
       {std::pair{BaseShape::round, "round"}, std::pair{BaseShape::square, "square"},
        std::pair{BaseShape::plinth, "plinth"}})
    for (const auto& [text, quoted] :
         {std::pair{"Laugh no. 1", "Laugh no. 1"},
          std::pair{"a\"];cube(50);[\xF0\x9F\x98\x80 \\", "a\\\"];cube(50);[\xF0\x9F\x98\x80 \\\\"},
          std::pair{"XXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXX",
                    "XXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXX"}}) {
      write_file(folder / "label.scad",
                 functions +
                     fmt::format("foot = [{}];\nrings = concat([foot], base_rings(foot, \"{}\", 8, 15));\n",
                                 points, name) +
                     fmt::format(
                         "n = len(foot);\nfunction ring(k) = [for (i = [0:n - 1]) k * n + i];\n"
                         "points = [for (r = rings) each r];\nfront = len(rings) - 3;\n"
                         "made = label_band(\"{}\", 0, 0.8, 0.2, points, ring(front), ring(front + 1), "
                         "len(points));\n"
                         "polyhedron(concat(points, made[0]), concat(made[1], [[for (i = [0:n - 1]) i]],\n"
                         "  [for (k = [0:len(rings) - 2]) if (k != front) each band(ring(k), ring(k + 1))],\n"
                         "  [[for (i = [n - 1:-1:0]) (len(rings) - 1) * n + i]]));\n",
                         quoted));
      const std::string command = fmt::format(
          "cd '{}' && openscad --hardwarnings -o label.stl label.scad >log 2>&1 && ! grep -E 'WARNING|ERROR' "
          "log",
          folder.string());
      ASSERT_EQ(std::system(command.c_str()), 0) << read_file(folder / "log");
      Mesh ours;
      for (const std::uint32_t v : foot) ours.positions.push_back(open.positions[v]);
      Loop loop;
      for (std::uint32_t i = 0; i < foot.size(); ++i) loop.push_back(i);
      append_fan_cap(ours, {loop.rbegin(), loop.rend()}, {0, 0, 8});
      append_base(ours, loop, build_base(shape, text), letters());
      const StlFacts facts = check_stl(folder / "label.stl");
      EXPECT_EQ(facts.open_edges, 0u) << name << text;
      EXPECT_EQ(facts.parts, 1u) << name << text;
      EXPECT_NEAR(facts.volume_mm3, compute_volume_mm3(ours), 0.001 * compute_volume_mm3(ours))
          << name << text;
      const Box box = compute_bounds(ours.positions);
      EXPECT_LT(glm::distance(facts.box.low, box.low), 0.03) << name << text;
      EXPECT_LT(glm::distance(facts.box.high, box.high), 0.03) << name << text;
    }
}

TEST(label, without_letters_is_our_own_mistake) {
  Mesh mesh = build_ball_on_neck(14, 8, 8, 6);
  const Loop foot = find_boundary_loops(mesh.triangles).front();
  EXPECT_THROW(append_base(mesh, foot, build_base(BaseShape::round, "LAUGH")), RunError);
}

}  // namespace
}  // namespace mien

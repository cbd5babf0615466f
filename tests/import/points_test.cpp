// Files of points as text, and slices among them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

#include "core/error.hpp"
#include "core/text.hpp"
#include "fuzz_rounds.hpp"
#include "import/polygons.hpp"
#include "import/slices.hpp"

namespace mien {
namespace {

namespace fs = std::filesystem;

Polygons load_text(const std::string& name, const std::string& text) {
  const fs::path file = fs::path(testing::TempDir()) / "mien_points" / name;
  write_file(file, text);
  return load_polygons(file, Faces::optional);
}

// What is said of the text; empty if it is read.
std::string find_fault(const std::string& text, const std::string& name = "a.xyz") {
  try {
    load_text(name, text);
  } catch (const InputError& e) {
    Diagnostic diagnostic = e.diagnostics.at(0);
    diagnostic.place.file = fs::path(diagnostic.place.file).filename();
    return format_diagnostic(diagnostic);
  }
  return "";
}

const std::vector<glm::dvec3> kTwo{{1, 2.5, -3}, {4, 5, 6}};

TEST(points, are_read_as_many_programs_write_them) {
  for (const auto& [name, text] : std::vector<std::pair<const char*, const char*>>{
           {"a.xyz", "1 2.5 -3\n4 5 6\n"},
           {"a.XYZ", "  1\t2.5   -3 255 0 0 \r\n\r\n4 5 6 1 1 1"},
           {"a.csv", "1,2.5,-3\n4,5,6\n"},
           {"a.csv", "x;y;z;label\n1;2.5;-3;tip of the nose\n4;5;6;\n"},
           {"a.csv", "\"id\",\"X (mm)\",\"Z (mm)\",\"Y (mm)\"\n7,1,-3,2.5\n8,4,6,5\n"},
           {"a.asc", "# a head\n//X Y Z R G B\n1 2.5 -3 9 9 9 # here\n4 5 6 9 9 9\n"},
           {"a.asc", "# the points x y z of Anna\n1 2.5 -3\n// again\n4 5 6\n"},
           {"a.pts", "2\n1 2.5 -3 -1024 200 200 200\n4 5 6 7 8 9 10\n"},
           {"a.pts", "1\n1 2.5 -3\n\n1\n4 5 6\n"}}) {
    const Polygons cloud = load_text(name, text);
    EXPECT_EQ(cloud.positions, kTwo) << text;
    EXPECT_TRUE(cloud.normals.empty());
    EXPECT_EQ(cloud.face_count(), 0u);
    EXPECT_FALSE(cloud.is_made);
  }
  EXPECT_EQ(load_text("a.xyz", "# one\n\n1 2 3\n\n4 5 6\n").lines, (std::vector<std::uint32_t>{3, 5}));
}

TEST(points, have_normals_where_a_heading_says_so) {
  for (const char* text :
       {"x,y,z,nx,ny,nz\n1,2.5,-3,0,0,1\n4,5,6,0,-1,0\n", "//X Y Z Nx Ny Nz\n1 2.5 -3 0 0 1\n4 5 6 0 -1 0\n",
        "normal_z normal_x normal_y x y z\n1 0 0 1 2.5 -3\n0 0 -1 4 5 6\n"}) {
    const Polygons cloud = load_text("a.csv", text);
    EXPECT_EQ(cloud.positions, kTwo);
    EXPECT_EQ(cloud.normals, (std::vector<glm::dvec3>{{0, 0, 1}, {0, -1, 0}})) << text;
  }
  EXPECT_TRUE(load_text("a.xyz", "1 2.5 -3 0 0 1\n4 5 6 0 -1 0\n").normals.empty()) << "it may be a colour";
}

TEST(points, tells_what_is_wrong_and_in_which_line) {
  const std::string far = " is no coordinate; expected a number from -1000000 to 1000000";
  EXPECT_EQ(find_fault("1 2 3\n4 5 x\n"), "a.xyz:2: error: 'x'" + far);
  EXPECT_EQ(find_fault("1 2 3\n4 5 nan\n"), "a.xyz:2: error: 'nan'" + far);
  EXPECT_EQ(find_fault("1 2 3\n4 5 1e7\n"), "a.xyz:2: error: '1e7'" + far);
  EXPECT_EQ(find_fault("1,2,\n"), "a.xyz:1: error: ''" + far);
  EXPECT_EQ(find_fault("1,5;2,5;3,5\n"),
            "a.xyz:1: error: no point; expected lines of X Y Z, or first a heading that names x, y and z");
  EXPECT_EQ(find_fault("12\nwater\nO 0 0 0\n"),
            "a.xyz:2: error: no point; expected lines of X Y Z, or first a heading that names x, y and z");
  EXPECT_EQ(find_fault("root:x:hidden\n"),
            "a.xyz:1: error: no point; expected lines of X Y Z, or first a heading that names x, y and z");
  EXPECT_EQ(find_fault("1 2 3\n4 5\n"), "a.xyz:2: error: a point of 2 numbers; expected X Y Z");
  EXPECT_EQ(find_fault("1 2 3\n4\n"), "a.xyz:2: error: a point of 1 number; expected X Y Z");
  EXPECT_EQ(find_fault("id,x,y,z\n1,2,3\n"),
            "a.xyz:2: error: a point of 3 numbers; expected 4 columns at least, as the heading has them");
  EXPECT_EQ(find_fault("3\n1 2 3\n4 5 6\n", "a.pts"), "a.pts:1: error: says 3 points; 2 follow");
  EXPECT_EQ(find_fault("1\n1 2 3\n2\n4 5 6\n", "a.pts"), "a.pts:3: error: says 2 points; 1 follow");
  EXPECT_EQ(find_fault("# nothing\n"),
            "a.xyz: error: has no points; expected a surface or a cloud of points");
  std::string wide = "1,2,3";
  for (int i = 0; i < 1000; ++i) wide += ",1";
  EXPECT_EQ(find_fault(wide), "a.xyz:1: error: more than 1000 numbers; expected X Y Z");
}

// A ball's circles of latitude, `way` apart, in pieces of `points`.
std::vector<Slice> cut_ball(double way, int points) {
  std::vector<Slice> slices;
  for (double height = -100 + way / 2; height < 100; height += way) {
    const double out = std::sqrt(100 * 100 - height * height);
    Slice& slice = slices.emplace_back();
    for (int i = 0; i < points; ++i) {
      const double angle = glm::radians(360.0 * i / points);
      slice.emplace_back(out * std::cos(angle), out * std::sin(angle), height);
    }
  }
  return slices;
}

std::string write_slices(const std::vector<Slice>& slices, const std::string& before,
                         const std::string& behind) {
  std::string text;
  for (const Slice& slice : slices) {
    text += before;
    for (const glm::dvec3& p : slice) text += fmt::format("{:.4f} {:.4f} {:.4f}\n", p.x, p.y, p.z);
    text += behind;
  }
  return text;
}

// Below the latitude of 60 degrees: the widest gap, by points thrown at the ball, and the furthest point off
// it.
std::pair<double, double> measure_ball(const Polygons& cloud) {
  std::mt19937 random(4);
  std::normal_distribution<double> normal(0, 1);
  double widest = 0, off = 0;
  for (int i = 0; i < 500; ++i) {
    const glm::dvec3 at = 100.0 * glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    if (std::abs(at.z) > 86) continue;
    double least = 1e9;
    for (const glm::dvec3& p : cloud.positions) least = std::min(least, glm::distance(p, at));
    widest = std::max(widest, least);
  }
  for (const glm::dvec3& p : cloud.positions)
    if (std::abs(p.z) < 86) off = std::max(off, std::abs(glm::length(p) - 100));
  return {widest, off};
}

TEST(slices, are_filled_to_a_cloud_whatever_their_order) {
  std::vector<Slice> slices = cut_ball(8, 90);
  const std::string in_order = write_slices(slices, "", "\n");
  std::shuffle(slices.begin(), slices.end(), std::mt19937(5));
  for (Slice& slice : slices)  // each begins elsewhere and runs either way
    std::rotate(slice.begin(), slice.begin() + static_cast<std::ptrdiff_t>(slice.size() / 3), slice.end());
  std::ranges::reverse(slices[3]);
  for (const std::string& text :
       {in_order, write_slices(slices, "Slice 3.5\n", ""), write_slices(slices, "contour\n\n", "\n\n")}) {
    const Polygons cloud = load_text("a.asc", text);
    EXPECT_EQ(cloud.slices, 25u);
    EXPECT_TRUE(cloud.is_made);
    EXPECT_TRUE(cloud.lines.empty());
    const auto [widest, off] = measure_ball(cloud);
    EXPECT_LT(widest, 3.5) << "points a third of the way between slices apart";
    EXPECT_LT(off, 0.2) << "chords would lie twice as deep";
  }
}

// The way from the last point of a line to its first is one of its steps.
TEST(slices, close_where_they_began) {
  std::vector<Slice> slices = cut_ball(8, 24);
  const Polygons closed = load_text("a.asc", write_slices(slices, "slice\n", ""));
  for (Slice& slice : slices) slice.resize(18);
  const Polygons open = load_text("a.asc", write_slices(slices, "slice\n", ""));
  const auto count_beside_seam = [](const Polygons& cloud) {  // between the last point and the first
    return std::ranges::count_if(cloud.positions, [](const glm::dvec3& p) {
      const double angle = glm::degrees(std::atan2(p.y, p.x));
      return angle > -14 && angle < -1;
    });
  };
  EXPECT_GT(count_beside_seam(closed), 200);
  EXPECT_EQ(count_beside_seam(open), 0);
}

// Meridians lie in no parallel planes: each is beside the one before it, and the last beside the first.
TEST(slices, led_around_the_head_come_back_to_the_first) {
  std::vector<Slice> slices;
  for (int i = 0; i < 72; ++i) {
    const double angle = glm::radians(5.0 * i);
    Slice& slice = slices.emplace_back();
    for (int j = -85; j <= 85; j += 2) {
      const double up = glm::radians(double(j));
      slice.emplace_back(100 * std::cos(up) * std::cos(angle), 100 * std::cos(up) * std::sin(angle),
                         100 * std::sin(up));
    }
  }
  const auto [widest, off] = measure_ball(load_text("a.xyz", write_slices(slices, "", "\n")));
  EXPECT_LT(widest, 3.5);
  EXPECT_LT(off, 0.3);
}

// A stray digit, and a hole that nobody saw into.
TEST(slices, are_not_drawn_over_leaps) {
  std::vector<Slice> slices = cut_ball(8, 90);
  slices[4][7].x = 900'000;
  slices[5][9].z = -900'000;
  for (Slice& slice : slices) slice.resize(60);
  const Polygons cloud = load_text("a.xyz", write_slices(slices, "", "\n"));
  for (const glm::dvec3& p : cloud.positions) {
    const bool is_pole = std::abs(p.z) > 86;
    EXPECT_LT(std::abs(glm::length(p) - 100), is_pole ? 5 : 0.6);
  }
  EXPECT_GT(cloud.positions.size(), 10'000u);
}

// Two arms: each is joined with itself, and nothing fills the room between them.
TEST(slices, of_several_lines_join_what_is_nearest) {
  std::vector<Slice> slices;
  for (int height = 0; height < 60; height += 4)
    for (const double middle : {-50.0, 50.0}) {
      Slice& slice = slices.emplace_back();
      for (int i = 0; i < 60; ++i) {
        const double angle = glm::radians(6.0 * i);
        slice.emplace_back(middle + 20 * std::cos(angle), 20 * std::sin(angle), height);
      }
    }
  const Polygons cloud = load_text("a.xyz", write_slices(slices, "", "\n"));
  EXPECT_EQ(cloud.slices, 30u);
  for (const glm::dvec3& p : cloud.positions)
    EXPECT_NEAR(glm::length(glm::dvec2(std::abs(p.x) - 50, p.y)), 20, 0.2);
}

TEST(slices, blank_lines_alone_make_no_slices) {
  std::mt19937 random(6);
  std::normal_distribution<double> normal(0, 1);
  std::string text;
  for (int i = 0; i < 900; ++i) {
    const glm::dvec3 p = 100.0 * glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    text += fmt::format("{:.3f} {:.3f} {:.3f}\n{}", p.x, p.y, p.z, i % 100 == 99 ? "\n" : "");
  }
  const Polygons cloud = load_text("a.xyz", text);
  EXPECT_EQ(cloud.slices, 0u);
  EXPECT_EQ(cloud.positions.size(), 900u);
}

TEST(slices, may_be_lines_of_an_obj) {
  std::string whole, steps;
  std::size_t count = 0;
  for (const Slice& slice : cut_ball(8, 90)) {
    for (const glm::dvec3& p : slice) whole += fmt::format("v {:.4f} {:.4f} {:.4f}\n", p.x, p.y, p.z);
    steps = whole;
    count += slice.size();
  }
  for (std::size_t i = 0; i < count; i += 90) {
    whole += "l";
    for (std::size_t j = 0; j < 90; ++j) whole += fmt::format(" {}/1", i + j + 1);
    whole += fmt::format(" {}\n", i + 1);
    for (std::size_t j = 0; j < 90; ++j)  // in no order, and either way
      steps += fmt::format("l {} {}\n", i + 1 + (j * 7 + j % 2) % 90, i + 1 + (j * 7 + 1 - j % 2) % 90);
  }
  for (const std::string& text : {whole, steps}) {
    const Polygons cloud = load_text("a.obj", text);
    EXPECT_EQ(cloud.slices, 25u);
    EXPECT_TRUE(cloud.is_made);
    EXPECT_LT(measure_ball(cloud).first, 3.5);
  }
  const Polygons mesh = load_text("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\nf 1 2 3\nl 9\n");
  EXPECT_EQ(mesh.face_count(), 1u) << "beside faces, lines are not asked";
  EXPECT_EQ(mesh.positions.size(), 3u);
  EXPECT_EQ(find_fault("v 0 0 0\nl 1\n", "a.obj"), "a.obj:2: error: a line of 1 point; expected 2 at least");
  EXPECT_EQ(find_fault("v 0 0 0\nl 1 3\n", "a.obj"),
            "a.obj:2: error: a line names point 3; expected numbers from 1 to 1");
  EXPECT_EQ(find_fault("v 0 0 0\nl 1 x\n", "a.obj"),
            "a.obj:2: error: 'x' names no point; expected a number from 1, as in f 1 2 3 4");
}

TEST(slices, chains_go_on_where_just_two_lines_end) {
  using Lines = std::vector<std::vector<std::uint32_t>>;
  EXPECT_EQ(chain_lines({{1, 2}, {3, 2}, {3, 4}}), (Lines{{1, 2, 3, 4}}));
  EXPECT_EQ(chain_lines({{2, 3}, {1, 2}, {3, 4, 5}}), (Lines{{1, 2, 3, 4, 5}}));
  EXPECT_EQ(chain_lines({{1, 2}, {2, 3}, {3, 1}}), (Lines{{1, 2, 3, 1}}));
  EXPECT_EQ(chain_lines({{1, 2}, {2, 3}, {2, 4}}), (Lines{{1, 2}, {2, 3}, {2, 4}}));
  EXPECT_EQ(chain_lines({{1, 2, 3, 1}, {5, 6}}), (Lines{{1, 2, 3, 1}, {5, 6}}));
}

TEST(slices, refuses_more_than_anybody_cuts) {
  std::string text;
  for (int i = 0; i <= 20'000; ++i) text += "slice\n1 2 3\n";
  EXPECT_EQ(find_fault(text), "a.xyz: error: more than 20000 slices; expected fewer");
}

// The worst that the limits allow takes a moment.
TEST(slices, scribbles_are_survived) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  for (const int slices : {1, 2, 200, 19'000}) {
    std::string text;
    for (int i = 0; i < slices; ++i) {
      text += "slice\n";
      for (int j = 0; j < 100'000 / slices; ++j)
        text += fmt::format("{:.5f} {:.5f} {:.5f}\n", share(random), share(random), share(random));
    }
    EXPECT_LT(load_text("a.xyz", text).positions.size(), kMaxGeometryPoints);
  }
  EXPECT_EQ(load_text("a.xyz", "slice\n1 1 1\n1 1 1\nslice\n1 1 1\n").positions.size(), 2u);
}

TEST(points, survives_broken_files) {
  std::mt19937 random(find_fuzz_seed(13));
  const std::array whole{std::string("x,y,z,nx,ny,nz\n1,2.5,-3,0,0,1\n4,5,6,0,-1,0\n"),
                         std::string("2\n1 2.5 -3 -1024 200 200 200\n4 5 6 7 8 9 10\n"),
                         write_slices(cut_ball(40, 9), "slice\n", "\n"),
                         write_slices(cut_ball(40, 9), "", "\n")};
  const std::array names{"a.csv", "a.pts", "a.xyz", "a.asc"};
  for (int round = 0; round < count_fuzz_rounds(200); ++round) {
    std::string text = whole[static_cast<std::size_t>(round) % whole.size()];
    if (round % 3 == 0) text.resize(random() % text.size());
    for (std::size_t i = random() % 4; i > 0 && !text.empty(); --i)
      text[random() % text.size()] = "0159-.,;e# \n/xn\0\x80"[random() % 17];
    if (!find_fault(text, names[static_cast<std::size_t>(round) % names.size()]).empty()) continue;
    for (const glm::dvec3& p : load_text("a.xyz", text).positions)
      for (int axis = 0; axis < 3; ++axis) ASSERT_LE(std::abs(p[axis]), kMaxCoordinate) << text;
  }
}

}  // namespace
}  // namespace mien

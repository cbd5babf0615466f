// Surfaces with control points: what they are made into, and what is said of those that cannot be.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <unsupported/Eigen/Splines>

#include "core/error.hpp"
#include "core/text.hpp"
#include "fuzz_rounds.hpp"
#include "import/mesh_faults.hpp"
#include "import/polygons.hpp"
#include "import/spline.hpp"

namespace mien {
namespace {

namespace fs = std::filesystem;

Polygons load_text(const std::string& text, Faces faces = Faces::needed) {
  const fs::path file = fs::path(testing::TempDir()) / "mien_surfaces" / "a.obj";
  write_file(file, text);
  return load_polygons(file, faces);
}

// What is said of the text; empty if it is read.
std::string find_fault(const std::string& text) {
  try {
    load_text(text);
  } catch (const InputError& e) {
    Diagnostic diagnostic = e.diagnostics.at(0);
    diagnostic.place.file = fs::path(diagnostic.place.file).filename();
    return format_diagnostic(diagnostic);
  }
  return "";
}

std::string list_faults(const Polygons& mesh) {
  std::string text;
  for (const MeshFault& fault : find_mesh_faults(mesh).faults) text += fault.message + "\n";
  return text;
}

using Net = std::vector<glm::dvec4>;  // places and weights, u runs fastest

// Nine points of a circle in quarters, and five of half a circle, as rational curves of degree 2.
std::vector<glm::dvec3> list_arc(std::size_t count, double first_deg) {
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = glm::radians(first_deg + 45.0 * static_cast<double>(i));
    const double out = i % 2 == 0 ? 1 : std::sqrt(2.0);
    points.emplace_back(out * std::cos(angle), out * std::sin(angle), i % 2 == 0 ? 1 : std::sqrt(0.5));
  }
  return points;
}

glm::dvec4 find_ball_point(std::size_t i, std::size_t j) {
  static const std::vector<glm::dvec3> circle = list_arc(9, 0), half = list_arc(5, -90);
  return {100 * half[j].x * circle[i].x, 100 * half[j].x * circle[i].y, 100 * half[j].y,
          circle[i].z * half[j].z};
}

std::string write_points(const Net& net) {
  std::string text;
  for (const glm::dvec4& p : net) text += fmt::format("v {:.9g} {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z, p.w);
  return text;
}

// A ball of radius 100 as one patch, whose two sides are one line and whose ends are one point each.
std::string build_ball() {
  Net net;
  std::string numbers;
  for (std::size_t j = 0; j < 5; ++j)
    for (std::size_t i = 0; i < 9; ++i) {
      net.push_back(find_ball_point(i, j));
      numbers += fmt::format(" {}", net.size());
    }
  return write_points(net) + "cstype rat bspline\ndeg 2 2\nsurf 0 4 0 2" + numbers +
         "\nparm u 0 0 0 1 1 2 2 3 3 4 4 4\nparm v 0 0 0 1 1 2 2 2\nend\n";
}

// The same ball as eight patches, each with points of its own, along either axis, facing either way.
std::string build_octants() {
  std::string text;
  for (std::size_t q = 0; q < 4; ++q)
    for (std::size_t h = 0; h < 2; ++h) {
      Net net;
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 3; ++i) {
          const std::size_t a = (q + h) % 3 == 0 ? 2 - i : i;
          net.push_back((q + h) % 3 == 1 ? find_ball_point(2 * q + j, 2 * h + i)
                                         : find_ball_point(2 * q + a, 2 * h + j));
        }
      const bool is_spline = q % 2 == 0;
      const std::string knots = is_spline ? "3 3 3 5 5 5" : "3 5";
      text += write_points(net) + fmt::format("cstype rat {}\n", is_spline ? "bspline" : "bezier") +
              "deg 2 2\nsurf 3 5 3 5 -9 -8 -7 -6 -5 -4 -3 -2 -1\nparm u " + knots + "\nparm v " + knots +
              "\nend\n";
    }
  return text;
}

// A ring whose patches share one net of points; knots without repeats, so that borders run between points.
std::string build_ring(int across, int along) {
  std::string text;
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < across; ++i) {
      const double a = glm::radians(360.0 * i / across), b = glm::radians(360.0 * j / along);
      text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", (100 + 40 * std::cos(b)) * std::cos(a),
                          (100 + 40 * std::cos(b)) * std::sin(a), 40 * std::sin(b));
    }
  text += "cstype bspline\ndeg 3 3\n";
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < across; ++i) {
      text += "surf 0 1 0 1";
      for (int l = 0; l < 4; ++l) {
        text += " \\\n ";
        for (int k = 0; k < 4; ++k) {
          const int number = (j + l) % along * across + (i + k) % across + 1;
          text += fmt::format(" {0}/{0}/{0}", number);
        }
      }
      text += "\nparm u -3 -2 -1 0 1 2 3 4\nparm v -3 -2 -1 0 1 2 3 4\nend\n";
    }
  return text;
}

TEST(spline, is_the_curve_that_another_library_has) {
  std::mt19937 random(find_fuzz_seed(11));
  std::uniform_real_distribution<double> share(0, 1);
  for (int round = 0; round < 200; ++round) {
    SplineAxis axis;
    axis.degree = 1 + static_cast<int>(random() % 7);
    const std::size_t points = static_cast<std::size_t>(axis.degree) + 1 + random() % 6;
    axis.knots = {0};
    while (axis.knots.size() < points + static_cast<std::size_t>(axis.degree) + 1)
      axis.knots.push_back(axis.knots.back() + (random() % 4 == 0 ? 0 : share(random)));
    const double low = find_first_place(axis), high = find_last_place(axis);
    if (high - low < 0.05) continue;
    const auto spans = list_spans(axis, low, high);
    Eigen::VectorXd values(static_cast<Eigen::Index>(points));
    for (auto& value : values) value = share(random);
    const Eigen::Map<const Eigen::VectorXd> knots(axis.knots.data(),
                                                  static_cast<Eigen::Index>(axis.knots.size()));
    const Eigen::Spline<double, 1> other(knots.transpose(), values.transpose());
    const int steps = 3;
    const std::vector<SplineRow> rows = build_spline_rows(axis, spans, low, high, steps);
    ASSERT_EQ(rows.size(), spans.size() * steps + 1);
    for (std::size_t r = 0; r + 1 < rows.size(); ++r) {
      const std::size_t span = spans[r / steps];
      const double at = axis.knots[span] +
                        (axis.knots[span + 1] - axis.knots[span]) * static_cast<double>(r % steps) / steps;
      if (at <= axis.knots.front()) continue;  // there it takes the first span for one with a length
      double sum = 0, all = 0;
      for (std::size_t i = 0; i <= static_cast<std::size_t>(axis.degree); ++i) {
        EXPECT_GE(rows[r].shares[i], 0);
        all += rows[r].shares[i];
        sum += rows[r].shares[i] * values(static_cast<Eigen::Index>(rows[r].first + i));
      }
      EXPECT_NEAR(all, 1, 1e-12);
      EXPECT_NEAR(sum, other(at)(0), 1e-9) << round << " at " << at;
    }
  }
}

TEST(spline, bezier_curves_share_their_ends) {
  const SplineAxis axis = build_bezier_axis(3, {0, 1, 5});
  EXPECT_EQ(axis.knots, (std::vector<double>{0, 0, 0, 0, 1, 1, 1, 5, 5, 5, 5}));
  EXPECT_EQ(axis.point_count(), 7u);
  const auto rows = build_spline_rows(axis, list_spans(axis, 0, 5), 0, 5, 2);
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[2].first, 3u);
  EXPECT_NEAR(rows[2].shares[0], 1, 1e-15) << "the point in the middle is on the curve";
  for (const std::size_t i : {0u, 3u}) EXPECT_NEAR(rows[3].shares[i], 1.0 / 8, 1e-15) << "Bernstein's";
  for (const std::size_t i : {1u, 2u}) EXPECT_NEAR(rows[3].shares[i], 3.0 / 8, 1e-15);
}

TEST(obj_surfaces, a_ball_of_weights_is_round_and_closed) {
  for (const std::string& text : {build_ball(), build_octants()}) {
    const Polygons mesh = load_text(text);
    EXPECT_TRUE(mesh.is_made);
    EXPECT_EQ(list_faults(mesh), "");
    EXPECT_EQ(find_mesh_faults(mesh).rims, 0u);
    const double size = glm::distance(glm::dvec3(-100), glm::dvec3(100));
    for (const glm::dvec3& p : mesh.positions) EXPECT_NEAR(glm::length(p), 100, 1e-6);
    double volume = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      glm::dvec3 middle(0);
      for (std::uint32_t i = mesh.first[f]; i < mesh.first[f + 1]; ++i)
        middle += mesh.positions[mesh.corners[i]] / double(mesh.first[f + 1] - mesh.first[f]);
      EXPECT_GT(glm::length(middle), 100 - 2.0 / 4000 * size);
      for (std::uint32_t i = mesh.first[f] + 2; i < mesh.first[f + 1]; ++i)
        volume += glm::dot(mesh.positions[mesh.corners[mesh.first[f]]],
                           glm::cross(mesh.positions[mesh.corners[i - 1]], mesh.positions[mesh.corners[i]])) /
                  6;
    }
    EXPECT_NEAR(std::abs(volume) / (4e6 / 3 * M_PI), 1, 0.005) << "all face one way";
    EXPECT_LT(mesh.positions.size(), 20000u);
  }
  EXPECT_EQ(load_text(build_ball()).surfaces, 1u);
  EXPECT_EQ(load_text(build_octants()).surfaces, 8u);
}

TEST(obj_surfaces, patches_of_one_net_are_one_surface) {
  const Polygons mesh = load_text(build_ring(12, 8));
  EXPECT_EQ(mesh.surfaces, 96u);
  const MeshReport report = find_mesh_faults(mesh);
  EXPECT_EQ(list_faults(mesh), "");
  EXPECT_EQ(report.rims, 0u);
  EXPECT_EQ(report.pieces, 1u);
  // Quads all over: two edges each, and a ring has as many points as it has quads.
  EXPECT_EQ(mesh.corners.size(), 4 * mesh.face_count());
  EXPECT_EQ(mesh.positions.size(), mesh.face_count());
  // In steps from patch to patch, the same number along a row of them.
  EXPECT_EQ(mesh.face_count() % 96, 0u);
}

// One bends, the other does not: they have as many points where they meet.
TEST(obj_surfaces, neighbours_agree_how_finely_they_meet) {
  const std::string text =
      "v 0 0 0\nv 50 0 0\nv 50 0 50\nv 0 50 0\nv 50 50 0\nv 50 50 50\nv 0 90 0\nv 50 90 0\nv 50 90 50\n"
      "cstype bezier\ndeg 2 1\nsurf 0 1 0 1 1 2 3 4 5 6\nparm u 0 1\nparm v 0 1\nend\n"
      "surf 0 1 0 1 4 5 6 7 8 9\nparm u 0 1\nparm v 0 1\nend\n"
      "v -50 0 0\nv -50 50 0\ndeg 1 1\nsurf 0 1 0 1 10 1 11 4\nparm u 0 1\nparm v 0 1\nend\n";
  const Polygons mesh = load_text(text);
  EXPECT_EQ(list_faults(mesh), "");
  const MeshReport report = find_mesh_faults(mesh);
  EXPECT_EQ(report.pieces, 1u);
  EXPECT_EQ(report.rims, 1u);
  const std::size_t steps = (mesh.face_count() - 1) / 2;
  EXPECT_GT(steps, 4u);
  EXPECT_EQ(mesh.face_count(), 2 * steps + 1) << "a flat one stays one polygon";
  EXPECT_EQ(mesh.positions.size(), 3 * (steps + 1) + 2);
}

const std::string kNet = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
const std::string kFlat =
    kNet + "cstype bspline\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\nparm u 0 0 1 1\nparm v 0 0 1 1\nend\n";

TEST(obj_surfaces, what_is_flat_is_one_polygon_and_control_points_are_no_points) {
  const Polygons mesh = load_text(kFlat);
  EXPECT_EQ(mesh.positions, (std::vector<glm::dvec3>{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}}));
  EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 2, 3, 1})) << "counter-clockwise, u to the right";
  EXPECT_EQ(mesh.lines, (std::vector<std::uint32_t>{7, 7, 7, 7}));
  const Polygons both = load_text(kFlat + "v 5 0 0\nv 6 0 0\nv 5 1 0\nf 5 6 7\n");
  EXPECT_EQ(both.face_count(), 2u);
  EXPECT_EQ(both.positions.size(), 7u);
  EXPECT_EQ(both.positions[0], glm::dvec3(5, 0, 0));
  EXPECT_EQ(both.lines[0], 11u);
  EXPECT_EQ(load_text(kNet + "f 1 2 4 3\n").is_made, false);
}

TEST(obj_surfaces, a_part_of_the_axes_is_a_part_of_the_surface) {
  const Polygons mesh = load_text(kNet +
                                  "cstype bezier\ndeg 1 1\nsurf 0.25 0.5 -0.0000001 1 1 2 3 4\nparm u 0 1\n"
                                  "parm v 0 1\nend\n");
  ASSERT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.positions[0], glm::dvec3(0.25, 0, 0));
  EXPECT_EQ(mesh.positions[3], glm::dvec3(0.5, 1, 0));
}

TEST(obj_surfaces, what_belongs_to_other_programs_is_passed) {
  const std::string curves =
      "vp 0 0\nvp 1 1\nshadow_obj a.obj\ncstype bmatrix\nbmat u 1 0 \\\n  0 1\nstep 1 1\ndeg 2\n"
      "curv2 1 2\nparm u 0 1\nend\ncstype taylor\ncurv 0 1 1 2 3\nparm u 0 1\nend\n";
  std::string text = kFlat;
  text.insert(text.find("cstype"), curves);
  text.insert(text.find("end\n", text.find("surf")), "ctech cparm 2\nstech cparma 2 2\nscrv 0 1 1\nsp 1\n");
  const Polygons mesh = load_text(text + "con 1 0 1 1 1 0 1 1\n");
  EXPECT_EQ(mesh.face_count(), 1u);
  EXPECT_TRUE(mesh.warnings.empty());
}

TEST(obj_surfaces, what_is_trimmed_is_taken_whole_and_told) {
  std::string text = kFlat;
  text.insert(text.rfind("end\n"), "trim 0 1 1\ntrim 0 1 2\nhole 0 1 3\n");
  const Polygons mesh = load_text(text + "surf 0 1 0 1 1 2 3 4\nparm u 0 0 1 1\nparm v 0 0 1 1\nend\n");
  ASSERT_EQ(mesh.warnings.size(), 1u);
  EXPECT_EQ(mesh.warnings[0].place.line, 10);
  EXPECT_EQ(mesh.warnings[0].message,
            "1 of 2 surfaces has 'trim' or 'hole': taken whole, with what these cut away");
  EXPECT_TRUE(mesh.warnings[0].is_warning);
}

std::string build_surface(const std::string& kind, const std::string& degrees, const std::string& surface,
                          const std::string& knots) {
  return kNet + "cstype " + kind + "\ndeg " + degrees + "\nsurf " + surface + "\n" + knots + "end\n";
}

TEST(obj_surfaces, tells_what_is_wrong_and_in_which_line) {
  const std::string knots = "parm u 0 0 1 1\nparm v 0 0 1 1\n";
  EXPECT_EQ(find_fault(build_surface("bspline", "1 1", "0 1 0 1 1 2 3 4", knots)), "");
  EXPECT_EQ(find_fault(kNet + "cstype nurbs\n"),
            "a.obj:5: error: unknown cstype 'nurbs'; expected bspline or bezier, or rat and one of them");
  EXPECT_EQ(find_fault(kNet + "cstype rat\n"),
            "a.obj:5: error: unknown cstype ''; expected bspline or bezier, or rat and one of them");
  EXPECT_EQ(find_fault(build_surface("rat taylor", "1 1", "0 1 0 1 1 2 3 4", knots)),
            "a.obj:7: error: a surface of cstype 'taylor'; expected bspline or bezier");
  EXPECT_EQ(find_fault(kNet + "deg 1 1\nsurf 0 1 0 1 1 2 3 4\n"),
            "a.obj:6: error: a surface before any 'cstype'; expected cstype bspline or cstype bezier first");
  EXPECT_EQ(find_fault(kNet + "deg 99 1\n"),
            "a.obj:5: error: the degree is '99'; expected a whole number from 1 to 24");
  EXPECT_EQ(find_fault(kNet + "deg 0 1\n"),
            "a.obj:5: error: the degree is '0'; expected a whole number from 1 to 24");
  EXPECT_EQ(find_fault(kNet + "deg\n"), "a.obj:5: error: expected deg and one or two degrees, as in deg 3 3");
  EXPECT_EQ(find_fault(build_surface("bezier", "1", "0 1 0 1 1 2 3 4", knots)),
            "a.obj:7: error: a surface without two degrees; expected deg U V before it, as in deg 3 3");
  EXPECT_EQ(find_fault(build_surface("bezier", "1 1", "0 1 0 1 1 2 3", knots)),
            "a.obj:7: error: a surface of too few words; expected surf U0 U1 V0 V1 and 4 control points at "
            "least");
  EXPECT_EQ(find_fault(build_surface("bezier", "1 1", "0 nan 0 1 1 2 3 4", knots)),
            "a.obj:7: error: 'nan' is no parameter; expected a number from -1e9 to 1e9");
  EXPECT_EQ(find_fault(build_surface("bspline", "1 1", "0 1 0 1 1 2 3 4", "parm u 0 0 1 1e10\n")),
            "a.obj:8: error: '1e10' is no parameter; expected a number from -1e9 to 1e9");
  EXPECT_EQ(find_fault(build_surface("bspline", "1 1", "0 1 0 1 1 2 3 4", "parm u 0 1 0.5 1\n")),
            "a.obj:8: error: 'parm u' falls from 1 to 0.5; expected numbers that rise");
  EXPECT_EQ(find_fault(build_surface("bspline", "1 1", "0 1 0 1 1 2 3 4", knots + "parm u 0 0 1 1\n")),
            "a.obj:10: error: the surface has 'parm u' twice; expected it once");
  EXPECT_EQ(find_fault(build_surface("bspline", "1 1", "0 1 0 1 1 2 3 4", "parm w 0 0 1 1\n")),
            "a.obj:8: error: expected parm u or parm v, and numbers");
  EXPECT_EQ(find_fault(kNet + "parm u 0 1\n"),
            "a.obj:5: error: 'parm' outside of a surface; expected it between 'surf' and 'end'");
  EXPECT_EQ(find_fault(kNet + "trim 0 1 1\n"),
            "a.obj:5: error: 'trim' outside of a surface; expected it between 'surf' and 'end'");
  EXPECT_EQ(find_fault(build_surface("bspline", "1 1", "0 1 0 1 1 2 3 4", "parm u 0 0 1 1\n")),
            "a.obj:7: error: 'parm v' of the surface has 0 numbers; expected 4 at least for degree 1");
  EXPECT_EQ(find_fault(build_surface("bezier", "1 1", "0 1 0 1 1 2 3 4", "parm u 0\n")),
            "a.obj:7: error: 'parm u' of the surface has 1 number; expected 2 at least for degree 1");
  EXPECT_EQ(
      find_fault(build_surface("bspline", "1 1", "0 1 0 1 1 2 3 4 1", knots)),
      "a.obj:7: error: a surface of 5 control points; expected 4, 2 by 2, as its degrees and its 'parm' have "
      "it");
  EXPECT_EQ(
      find_fault(build_surface("bspline", "1 1", "0 2 0 1 1 2 3 4", knots)),
      "a.obj:7: error: the surface goes from u = 0 to 2; expected a part of 0 to 1, where its 'parm u' makes "
      "one");
  EXPECT_EQ(
      find_fault(build_surface("bspline", "1 1", "0 1 1 0 1 2 3 4", knots)),
      "a.obj:7: error: the surface goes from v = 1 to 0; expected a part of 0 to 1, where its 'parm v' makes "
      "one");
  EXPECT_EQ(find_fault(build_surface("bspline", "1 1", "0 1 0 1 1 2 3 9", knots)),
            "a.obj:7: error: a surface names point 9; expected numbers from 1 to 4");
  EXPECT_EQ(find_fault(build_surface("bspline", "1 1", "0 1 0 1 1 2 3 0", knots)),
            "a.obj:7: error: a surface names point 0; expected numbers from 1");
  EXPECT_EQ(find_fault(build_surface("bspline", "1 1", "0 1 0 1 1 1 1 1", knots)),
            "a.obj:7: error: all control points lie in one place; expected a surface");
  const std::string open = kNet + "cstype bspline\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\n";
  const std::string no_end =
      "a.obj:7: error: the surface has no 'end'; expected surf, parm u, parm v and end";
  EXPECT_EQ(find_fault(open), no_end);
  EXPECT_EQ(find_fault(open + "surf 0 1 0 1 1 2 3 4\n"), no_end);
  EXPECT_EQ(find_fault(open + "curv 0 1 1 2\n"), no_end);
  EXPECT_EQ(find_fault(kNet + "cstype bezier\ndeg 1\ncurv 0 1 1 2\nparm u 0 1\nend\n"),
            "a.obj:7: error: a curve, and the file has no surface; expected surf, f or, for slices, l");
  for (const auto& [word, shown] : {std::pair{"0", "0"}, {"-1", "-1"}, {"x", "nan"}, {"1e7", "1e+07"}}) {
    const std::string text =
        fmt::format("v 0 0 0 {}\n", word) +
        build_surface("rat bezier", "1 1", "0 1 0 1 1 3 4 5", "parm u 0 1\nparm v 0 1\n");
    EXPECT_EQ(find_fault(text),
              fmt::format(
                  "a.obj:8: error: the surface's point 1 has the weight {}; expected a number from 0.000001 "
                  "to 1000000",
                  shown));
    std::string plain = text;
    plain.erase(plain.find("rat "), 4);
    EXPECT_EQ(find_fault(plain), "") << "weights are those of rational surfaces";
  }
}

TEST(obj_surfaces, refuses_more_than_it_can_hold) {
  std::string text = kNet + "cstype bspline\ndeg 1 1\nsurf 0 1 0 1";
  for (int i = 0; i < 500'001; ++i) text += " 1";
  EXPECT_EQ(find_fault(text), "a.obj:7: error: more than 500000 control points; expected fewer");
  EXPECT_EQ(find_fault(kNet + "f " + std::string(16'000'000, '1') + "\n"),
            "a.obj:5: error: a line of 16000002 bytes; expected 16000000 at most");
  std::string endless = kNet + "f";
  for (int i = 0; i < 900'000; ++i) endless += " 1 1 1 1 1 1 1 1 1 \\\n";
  EXPECT_EQ(find_fault(endless),
            "a.obj:5: error: a line that goes on for more than 8000000 words; expected fewer");
}

// A surface that folds in each of a million spans is looked at, and is not what holds the others up.
TEST(obj_surfaces, a_wild_surface_is_made_as_finely_as_there_is_room_for) {
  std::mt19937 random(2);
  constexpr int kSide = 300;
  std::string text, numbers, knots;
  for (int i = 0; i < kSide * kSide; ++i) {
    text += fmt::format("v {} {} {}\n", i % kSide, i / kSide, random() % 50);
    numbers += fmt::format(" {}", i + 1);
  }
  for (int i = -3; i <= kSide; ++i) knots += fmt::format(" {}", i);
  text += fmt::format("cstype bspline\ndeg 3 3\nsurf 0 {0} 0 {0}{1}\nparm u{2}\nparm v{2}\nend\n", kSide - 3,
                      numbers, knots);
  const Polygons mesh = load_text(text);
  EXPECT_GT(mesh.positions.size(), 80'000u);
  EXPECT_LT(mesh.positions.size(), 500'000u);
}

// Words exchanged, doubled and left out, numbers made up: told or made into finite polygons.
TEST(obj_surfaces, survives_broken_files) {
  std::mt19937 random(find_fuzz_seed(12));
  const std::array whole{build_ball(), build_octants(), build_ring(4, 3), kFlat};
  const std::array numbers{"0",   "-1", "1e9", "-1e300", "nan",     "1",
                           "0.5", "3",  "24",  "inf",    "2000000", "1e-300"};
  for (int round = 0; round < count_fuzz_rounds(400); ++round) {
    std::string text = whole[static_cast<std::size_t>(round) % whole.size()];
    for (std::size_t i = 1 + random() % 4; i > 0; --i) {
      const std::size_t begin = text.find_first_not_of(" \n", random() % text.size());
      if (begin == text.npos) continue;
      const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
      switch (random() % 4) {
        case 0:
          text.replace(begin, end - begin, numbers[random() % numbers.size()]);
          break;
        case 1:
          text.erase(begin, end - begin);
          break;
        case 2:
          text.insert(begin, text.substr(begin, end - begin) + " ");
          break;
        default:
          text[begin] = static_cast<char>(random());
      }
    }
    if (round % 5 == 0) text.resize(random() % text.size());
    if (!find_fault(text).empty()) continue;
    const Polygons mesh = load_text(text);
    for (const std::uint32_t corner : mesh.corners) ASSERT_LT(corner, mesh.positions.size());
    for (const glm::dvec3& p : mesh.positions)
      for (int axis = 0; axis < 3; ++axis) ASSERT_LE(std::abs(p[axis]), kMaxCoordinate * 1.000001) << text;
  }
}

}  // namespace
}  // namespace mien

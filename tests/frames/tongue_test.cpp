// The tongue in its mouth: it goes where the mouth is open, and through nothing.
#include "frames/tongue.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "config/load_spec.hpp"
#include "frames/figure.hpp"
#include "frames/pose_soundness.hpp"
#include "places.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

struct NamedHead {
  std::string name;
  Figure figure;
};

const std::vector<NamedHead>& heads() {
  static const std::vector<NamedHead> all = [] {
    std::vector<NamedHead> made;
    for (const char* age : {"adult", "child", "infant", "old"}) {
      HeadSpec spec;
      spec.age = {{age, 1.0}};
      made.push_back({age, build_figure(shipped().heads, spec)});
    }
    const std::filesystem::path folder = source_folder();
    made.push_back(
        {"scan", build_figure(shipped().heads,
                              load_spec(folder / "configs/scan.yaml", *shipped().stock.language).head)});
    return made;
  }();
  return all;
}

Pose build_pose(double open, double out, double up) {
  Pose pose;
  pose.values[*find_move(Area::chin, Side::none, "down")] = open;
  pose.values[*find_move(Area::tongue, Side::none, "out")] = out;
  pose.values[*find_move(Area::tongue, Side::none, "up")] = up;
  return pose;
}

// A part's vertices as they are drawn.
std::vector<glm::vec3> place(const Figure& figure, const Drawing& drawing, std::string_view name) {
  for (std::size_t i = 0; i < figure.model.parts.size(); ++i) {
    const Part& part = figure.model.parts[i];
    if (part.name != name) continue;
    if (!is_carried(part, drawing.parts[i])) return drawing.parts[i].positions;
    std::vector<glm::vec3> places;
    for (const glm::vec3& p : part.rest.positions)
      places.emplace_back(drawing.parts[i].world_from_rest * glm::vec4(p, 1));
    return places;
  }
  return {};
}

struct Drawn {
  DeformBuffers buffers = {};
  Drawing drawing = {};
  glm::vec3 tip{0};

  void pose(const Figure& figure, const Pose& asked) {
    deform_figure(figure, asked, TurnKey{}, buffers, drawing);
    tip = place(figure, drawing, "tongue").back();
  }
};

TEST(tongue, rests_with_the_jaw_as_one_thing_until_it_is_asked) {
  Drawn drawn;
  for (const auto& [name, figure] : heads()) {
    drawn.pose(figure, build_pose(0.7, 0.5, 0.2));
    drawn.pose(figure, build_pose(0.7, 0, 0));
    EXPECT_TRUE(drawn.drawing.parts[figure.tongue.part].positions.empty()) << name;
    const glm::vec3 rest = drawn.tip;
    drawn.pose(figure, build_pose(0.7, 1e-4, 1e-4));
    EXPECT_FALSE(drawn.drawing.parts[figure.tongue.part].positions.empty()) << name;
    EXPECT_LT(glm::distance(drawn.tip, rest), 0.02) << name << ": it must not jump";
  }
}

TEST(tongue, stays_in_a_shut_mouth) {
  Drawn drawn;
  for (const auto& [name, figure] : heads()) {
    drawn.pose(figure, build_pose(0, 1, 0));
    float front = -1e9f;
    for (const glm::vec3& p : place(figure, drawn.drawing, "teeth_upper"))
      if (std::abs(p.x) < 3) front = std::max(front, p.z);
    for (const glm::vec3& p : place(figure, drawn.drawing, "gum_upper"))
      if (std::abs(p.x) < 3) front = std::max(front, p.z);
    EXPECT_LT(drawn.tip.z, front) << name;
  }
}

TEST(tongue, comes_out_of_an_open_mouth_as_far_as_its_limit) {
  Drawn drawn;
  for (const auto& [name, figure] : heads()) {
    drawn.pose(figure, build_pose(0.7, 0, 0));
    const glm::vec3 rest = drawn.tip;
    double before = 0;
    for (const double out : {0.25, 0.5, 0.75, 1.0}) {
      drawn.pose(figure, build_pose(0.7, out, 0));
      const double way = glm::distance(drawn.tip, rest);
      EXPECT_GT(way, before + 0.1 * figure.face.tongue_out_mm) << name;
      before = way;
    }
    EXPECT_NEAR(before, figure.face.tongue_out_mm, 0.35 * figure.face.tongue_out_mm) << name;
    const glm::vec3 lip = drawn.drawing.parts[0].positions[figure.head.cage.index.find("M2_12")->second];
    EXPECT_GT(drawn.tip.z, lip.z + 6 * figure.tongue.scale) << name << ": it is seen before the lip";
  }
}

TEST(tongue, lifts_its_tip_to_the_ridge_behind_the_upper_teeth) {
  Drawn drawn;
  for (const auto& [name, figure] : heads()) {
    drawn.pose(figure, build_pose(0.3, 0, 1));
    float edge = 1e9f, back = 1e9f;
    for (const char* part : {"teeth_upper", "gum_upper"})
      for (const glm::vec3& p : place(figure, drawn.drawing, part))
        if (std::abs(p.x) < 3) edge = std::min(edge, p.y);
    for (const char* part : {"teeth_upper", "gum_upper"})
      for (const glm::vec3& p : place(figure, drawn.drawing, part))
        if (std::abs(p.x) < 3 && p.y < edge + 3) back = std::max(back, p.z);
    EXPECT_GT(drawn.tip.y, edge) << name;
    EXPECT_LT(drawn.tip.z, back + 9) << name;
  }
}

// Neither through lips nor through teeth, however far the jaw is open and whatever the lips do.
TEST(tongue, goes_through_nothing) {
  DeformBuffers buffers;
  Drawing drawing;
  for (const auto& [name, figure] : heads()) {
    const PoseProbe probe = build_pose_probe(figure);
    for (const double open : {0.0, 0.1, 0.2, 0.4, 1.0})
      for (const double out : {0.3, 1.0})
        for (const double up : {0.0, 0.5, 1.0})
          for (const char* lips : {"rest", "round", "smile", "press", "sneer"}) {
            Pose pose = build_pose(open, out, up);
            const auto set = [&](Area area, const char* move, double value) {
              for (const Side side : {Side::none, Side::left, Side::right})
                if (const auto found = find_move(area, side, move)) pose.values[*found] = value;
            };
            if (std::string_view(lips) == "round") set(Area::corner, "out", -1);
            if (std::string_view(lips) == "smile")
              set(Area::corner, "out", 0.8), set(Area::corner, "up", 0.9);
            if (std::string_view(lips) == "press") set(Area::lips, "press", 1);
            if (std::string_view(lips) == "sneer") set(Area::lips, "upper", 1), set(Area::lips, "lower", -1);
            const PoseFindings found = measure_pose(probe, pose, buffers, drawing);
            for (std::size_t check = 0; check < kPoseCheckCount; ++check)
              if (std::string_view(kPoseChecks[check].name) == "tongue through") {
                EXPECT_LE(found[check].value, 0)
                    << name << ": open " << open << ", out " << out << ", up " << up << ", " << lips;
              }
          }
  }
}

// The crown of a front tooth has nothing of the tongue in it.
TEST(tongue, keeps_off_the_teeth) {
  Drawn drawn;
  for (const auto& [name, figure] : heads())
    for (const double open : {0.12, 0.25, 0.6})
      for (const double out : {0.0, 0.4, 1.0})
        for (const double up : {0.0, 0.6, 1.0}) {
          drawn.pose(figure, build_pose(open, out, up));
          const std::vector<glm::vec3> tongue = place(figure, drawn.drawing, "tongue");
          for (const bool is_upper : {true, false}) {
            const std::vector<glm::vec3> teeth =
                place(figure, drawn.drawing, is_upper ? "teeth_upper" : "teeth_lower");
            for (const glm::vec3& p : tongue) {
              if (p.z < figure.tongue.tip.z) continue;
              for (const glm::vec3& t : teeth) {
                if (std::abs(t.x - p.x) > 0.5f || std::abs(t.z - p.z) > 0.4f) continue;
                EXPECT_GT(is_upper ? t.y - p.y : p.y - t.y, -0.3)
                    << name << ", open " << open << ", out " << out << ", up " << up << ", upper "
                    << is_upper;
              }
            }
          }
        }
}

}  // namespace
}  // namespace mien

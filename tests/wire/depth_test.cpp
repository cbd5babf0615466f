// Hidden lines against a depth picture, which is made another way: by filling triangles.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "fuzz_rounds.hpp"
#include "poses.hpp"
#include "sheet/wire_head.hpp"
#include "shipped.hpp"
#include "wire/drawing.hpp"

namespace mien {
namespace {

constexpr double kInfinite = 1e30;

struct DepthPicture {
  PictureSize size;
  std::vector<double> mm;  // of the nearest surface in the middle of each pixel
};

void fill_triangle(const WireCamera& camera, const std::array<glm::dvec3, 3>& corners, DepthPicture& depth) {
  std::array<glm::dvec2, 3> px;
  std::array<double, 3> mm{};
  for (std::size_t i = 0; i < 3; ++i) {
    px[i] = find_paper_place(camera, corners[i]);
    mm[i] = compute_depth_mm(camera, corners[i]);
  }
  const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
  const double area = cross(px[1] - px[0], px[2] - px[0]);
  if (area == 0) return;
  const glm::dvec2 low = glm::min(glm::min(px[0], px[1]), px[2]),
                   high = glm::max(glm::max(px[0], px[1]), px[2]);
  for (int y = std::max(0, static_cast<int>(low.y - 0.5));
       y < std::min(depth.size.height_px, static_cast<int>(high.y + 1)); ++y)
    for (int x = std::max(0, static_cast<int>(low.x - 0.5));
         x < std::min(depth.size.width_px, static_cast<int>(high.x + 1)); ++x) {
      const glm::dvec2 p(x + 0.5, y + 0.5);
      const std::array<double, 3> share{cross(px[1] - p, px[2] - p) / area,
                                        cross(px[2] - p, px[0] - p) / area,
                                        cross(px[0] - p, px[1] - p) / area};
      if (std::ranges::min(share) < 0) continue;
      double here = 0;
      for (std::size_t i = 0; i < 3; ++i) here += share[i] * (camera.is_orthographic ? mm[i] : 1 / mm[i]);
      if (!camera.is_orthographic) here = 1 / here;
      double& nearest = depth.mm[static_cast<std::size_t>(y * depth.size.width_px + x)];
      nearest = std::min(nearest, here);
    }
}

DepthPicture build_depth(const WireModel& model, const WireCamera& camera) {
  DepthPicture depth{camera.size, {}};
  depth.mm.assign(static_cast<std::size_t>(camera.size.width_px * camera.size.height_px), kInfinite);
  for (const WireSolid& solid : model.solids)
    for (const Triangle& t : solid.triangles)
      fill_triangle(camera,
                    {glm::dvec3(solid.positions[t[0]]), glm::dvec3(solid.positions[t[1]]),
                     glm::dvec3(solid.positions[t[2]])},
                    depth);
  return depth;
}

// How far before a place lies what the pixels around it show, mm: of the nine the least and the most, and in
// its own.
struct Before {
  double least_mm = kInfinite, most_mm = -kInfinite, own_mm = 0;
  bool is_in_picture = true;
};

Before find_before(const DepthPicture& depth, const WireCamera& camera, const glm::dvec3& place) {
  const glm::dvec2 px = find_paper_place(camera, place);
  const double own_mm = compute_depth_mm(camera, place);
  Before before;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      const int left = static_cast<int>(std::floor(px.x)) + x, top = static_cast<int>(std::floor(px.y)) + y;
      if (left < 0 || top < 0 || left >= depth.size.width_px || top >= depth.size.height_px) {
        before.is_in_picture = false;
        continue;
      }
      const double mm = own_mm - depth.mm[static_cast<std::size_t>(top * depth.size.width_px + left)];
      before.least_mm = std::min(before.least_mm, mm);
      before.most_mm = std::max(before.most_mm, mm);
      if (x == 0 && y == 0) before.own_mm = mm;
    }
  return before;
}

struct Judged {
  double drawn_px = 0, wrongly_drawn_px = 0, wrongly_hidden_px = 0;
};

// What is drawn is wrong if all nine pixels agree that something lies further before it than this. What is
// left out is wrong if nothing does, and nothing lies before it in its own pixel either; of hairs, which are
// thinner than a pixel, the picture cannot tell.
constexpr double kTolerance_mm = 0.5;

Judged judge(const WireModel& model, const WireCamera& seen_by, const WireCamera& camera) {
  const WireStage stage(model.solids);
  const DepthPicture depth = build_depth(model, camera);
  Judged judged;
  for (const WireLine& line : list_wire_lines(model, seen_by))
    for (std::size_t i = 0; i + 1 < line.points.size() && !line.is_before_all; ++i) {
      const glm::dvec3 from(line.points[i]), to(line.points[i + 1]);
      const double px = glm::distance(find_paper_place(camera, from), find_paper_place(camera, to));
      const int count = std::max(1, static_cast<int>(std::ceil(px / 1.5)));
      const auto seen = find_seen(stage, seen_by, from, to, kWireStep_px);
      for (int k = 0; k < count; ++k) {
        const double share = (k + 0.5) / count;
        const bool is_drawn =
            std::ranges::any_of(seen, [&](const auto& part) { return part[0] <= share && share <= part[1]; });
        const Before before = find_before(depth, camera, glm::mix(from, to, share));
        if (!before.is_in_picture) continue;
        if (is_drawn) judged.drawn_px += px / count;
        if (is_drawn && before.least_mm > kTolerance_mm) judged.wrongly_drawn_px += px / count;
        if (!is_drawn && before.most_mm < kTolerance_mm && before.own_mm < kSeenLift_mm &&
            line.pen != Pen::hair)
          judged.wrongly_hidden_px += px / count;
      }
    }
  return judged;
}

// MIEN_FUZZ_ROUNDS=50 asks it of as many views as docs/sheets.md tells of.
TEST(wire_depth, hidden_lines_of_random_faces_agree_with_a_depth_picture) {
  std::mt19937 random(find_fuzz_seed(56));
  const int rounds = std::min(count_fuzz_rounds(4), 50);
  double worst_drawn = 0, worst_hidden = 0;
  for (int round = 0; round < rounds; ++round) {
    HeadSpec spec;
    spec.age = {{kAges[static_cast<std::size_t>(round) % kAges.size()], 1.0}};
    const Figure figure = build_figure(shipped().heads, spec);
    const Pose pose = round % 2 == 0 ? Pose{} : build_random_pose(random);
    WireOptions wanted;
    wanted.has_guides = round % 3 == 0;
    wanted.has_cage = round % 5 == 4;
    WireModel model;
    append_wire_head(figure, {pose, {}, glm::dmat4(1)}, wanted, model);
    CameraView view;
    view.is_orthographic = round % 2 == 1;
    view.angle_deg = std::uniform_real_distribution<double>(-180, 180)(random);
    view.height_deg = std::uniform_real_distribution<double>(-50, 50)(random);
    const Judged judged =
        judge(model, build_wire_camera(view, {500, 600}), build_wire_camera(view, {1500, 1800}));
    ASSERT_GT(judged.drawn_px, 10000);
    const double drawn = judged.wrongly_drawn_px / judged.drawn_px,
                 hidden = judged.wrongly_hidden_px / judged.drawn_px;
    EXPECT_LT(drawn, 0.005) << round << ": angle " << view.angle_deg << ", height " << view.height_deg;
    EXPECT_LT(hidden, 0.005) << round << ": angle " << view.angle_deg << ", height " << view.height_deg;
    worst_drawn = std::max(worst_drawn, drawn);
    worst_hidden = std::max(worst_hidden, hidden);
  }
  RecordProperty("worst_drawn_percent", fmt::format("{:.3f}", 100 * worst_drawn));
  RecordProperty("worst_hidden_percent", fmt::format("{:.3f}", 100 * worst_hidden));
}

TEST(wire_depth, the_judge_finds_lines_that_are_all_drawn) {
  WireModel model;
  append_wire_head(build_figure(shipped().heads, {}), {}, {}, model);
  CameraView view;
  const WireCamera camera = build_wire_camera(view, {400, 480});
  WireModel transparent = model;
  for (WireSolid& solid : transparent.solids) solid.triangles.clear();
  const WireStage nothing(transparent.solids);
  const DepthPicture depth = build_depth(model, camera);
  double wrong_px = 0, all_px = 0;
  for (const WireLine& line : model.lines) {
    const glm::dvec3 from(line.points[0]), to(line.points[1]);
    const double px = glm::distance(find_paper_place(camera, from), find_paper_place(camera, to));
    EXPECT_EQ(find_seen(nothing, camera, from, to, kWireStep_px).size(), 1u);
    all_px += px;
    if (find_before(depth, camera, glm::mix(from, to, 0.5)).least_mm > kTolerance_mm) wrong_px += px;
  }
  EXPECT_GT(wrong_px / all_px, 0.25) << "a quarter of a head's lines at least are behind it";
}

}  // namespace
}  // namespace mien

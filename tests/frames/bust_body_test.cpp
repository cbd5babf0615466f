// Busts as one body: closed but for the foot, the same triangles in every pose, and a source that can pose
// them.
#include "frames/bust_body.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "config/load_spec.hpp"
#include "core/crossings.hpp"
#include "frames/bust_controls.hpp"
#include "places.hpp"
#include "poses.hpp"
#include "print/solid_tree.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

const Figure& adult() {
  static const Figure figure = build_figure(shipped().heads, HeadSpec{});
  return figure;
}

const BustBody& adult_body() {
  static const BustBody body = build_bust_body(adult(), {});
  return body;
}

// A pose of one or more moves; sided ones on both sides.
Pose build_pose(std::initializer_list<std::tuple<std::string_view, std::string_view, double>> moves) {
  Pose pose;
  for (const auto& [area, move, value] : moves)
    for (std::size_t i = 0; i < kMoveCount; ++i)
      if (kMoves[i].area == area && kMoves[i].move == move) pose.values[i] = value;
  return pose;
}

// Closed by a fan under the foot.
Mesh build_closed(const BustBody& body, std::vector<glm::vec3> positions) {
  Mesh mesh{std::move(positions), {}, body.triangles};
  append_fan_cap(mesh, body.foot, compute_loop_centre(mesh.positions, body.foot));
  return mesh;
}

TEST(bust_body, is_one_closed_surface_that_stands_on_its_foot) {
  const BustBody& body = adult_body();
  EXPECT_LE(body.triangles.size(), 15000U);
  const std::vector<Loop> loops = find_boundary_loops(body.triangles);
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_EQ(std::set<std::uint32_t>(loops[0].begin(), loops[0].end()),
            std::set<std::uint32_t>(body.foot.begin(), body.foot.end()));
  const Mesh mesh = build_closed(body, place_bust(body, adult(), Pose{}));
  EXPECT_EQ(count_open_edges(mesh.triangles), 0U);
  EXPECT_EQ(split_pieces(mesh).size(), 1U);
  const Box box = compute_bounds(mesh.positions);
  EXPECT_NEAR(box.low.z, 0, 1e-4);
  EXPECT_NEAR(box.high.z, 72, 0.02);
  for (const std::uint32_t v : body.foot) EXPECT_NEAR(mesh.positions[v].z, 0, 1e-4);
}

TEST(bust_body, keeps_its_volume_and_its_numbers_in_any_pose) {
  std::mt19937 random(61);
  const BustBody& body = adult_body();
  const double rest = compute_volume_mm3(build_closed(body, place_bust(body, adult(), Pose{})));
  for (int i = 0; i < 12; ++i) {
    const Mesh mesh = build_closed(body, place_bust(body, adult(), build_random_pose(random)));
    for (const glm::vec3& p : mesh.positions)
      ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    EXPECT_NEAR(compute_volume_mm3(mesh) / rest, 1, 0.05) << i;
  }
}

TEST(bust_body, stands_flat_where_no_base_is_asked_for) {
  BustSize size;
  size.stand = Stand::flat;
  size.figure_mm = 80;
  const BustBody body = build_bust_body(adult(), size);
  const std::vector<glm::vec3> flat = place_bust(body, adult(), Pose{});
  const Box box = compute_bounds(flat);
  EXPECT_NEAR(box.low.z, 0, 1e-4);
  EXPECT_NEAR(box.high.z, 80, 0.02);
  float breadth = 0;
  for (const std::uint32_t v : body.foot) breadth = std::max(breadth, std::abs(flat[v].x));
  EXPECT_GT(breadth, 0.2f * 80);
  // On a foot the same body reaches further down.
  EXPECT_LT(compute_bounds(place_bust(body, adult(), Pose{}, Stand::foot)).low.z, -2);
}

// The narrowest place of a slit in height, on the way from `at` in it to the front.
double find_narrowest_mm(const Mesh& mesh, glm::dvec3 at) {
  constexpr double kStep_mm = 0.05, kOutside_mm = 2;
  const SurfaceTree tree = build_solid_tree(mesh);
  double narrowest = 1e9;
  for (int step = 0; step < 100; ++step, at.y -= kStep_mm) {
    const double up = find_hit(tree, at, {0, 0, 1}, 0, 20).distance;
    const double down = find_hit(tree, at, {0, 0, -1}, 0, 20).distance;
    if (up + down > kOutside_mm) break;
    narrowest = std::min(narrowest, up + down);
    at.z += (up - down) / 2;
  }
  return narrowest;
}

TEST(bust_body, shut_lids_and_lips_leave_a_line_that_prints) {
  const BustBody& body = adult_body();
  const Pose pose = build_pose({{"lid", "upper", -1}, {"lips", "press", 1}, {"chin", "up", 1}});
  const std::vector<glm::vec3> shut = place_bust(body, adult(), pose);
  const Mesh mesh = build_closed(body, shut);
  for (const Patch* patch : {&body.eyes[0], &body.eyes[1], &body.mouth}) {
    const std::size_t middle = patch->upper.size() / 2;
    const glm::dvec3 up(shut[patch->upper[middle]]), low(shut[patch->lower[middle]]);
    // Lips gape behind the place where they meet: the line is as wide as its narrowest place, as it is asked
    // for: 0.3 mm of the lips, 0.37 of the lids, which curve.
    const double narrowest = find_narrowest_mm(mesh, 0.5 * (up + low) - glm::dvec3(0, 0.01, 0));
    EXPECT_GT(narrowest, 0.29) << (patch == &body.mouth ? "mouth" : "eye");
    EXPECT_LT(narrowest, 0.4) << (patch == &body.mouth ? "mouth" : "eye");
    for (std::size_t i = 1; i + 1 < patch->upper.size(); ++i)
      EXPECT_GT(shut[patch->upper[i]].z, shut[patch->lower[i]].z) << i;
  }
}

TEST(bust_body, eyes_are_carved_where_they_look) {
  const BustBody& body = adult_body();
  const auto find_deepest = [&](double side) {
    const auto positions =
        place_bust(body, adult(), build_pose({{"eye", "side", side}, {"lid", "upper", 1}}));
    const Patch& eye = body.eyes[0];
    const glm::vec3 centre = (body.carved[0].centre - body.origin) * body.print_per_head;
    const glm::vec3 middle(centre.x, -centre.z, centre.y);
    glm::vec3 deepest = positions[eye.first];
    for (std::uint32_t i = 0; i < eye.vertex_count(); ++i)
      if (glm::distance(positions[eye.first + i], middle) < glm::distance(deepest, middle))
        deepest = positions[eye.first + i];
    return deepest;
  };
  EXPECT_GT(find_deepest(1).x, find_deepest(0).x + 0.5f);
  EXPECT_LT(find_deepest(-1).x, find_deepest(0).x - 0.5f);
  Pose apart;
  apart.values[*find_move(Area::eye, Side::left, "side")] = 0.5;
  apart.values[*find_move(Area::eye, Side::right, "side")] = -0.5;
  const auto eyes = compute_carved_eyes(body, adult(), apart);
  EXPECT_GT(eyes[0].gaze.x, 0.1f);
  EXPECT_LT(eyes[1].gaze.x, -0.1f);
}

TEST(bust_body, an_open_mouth_shows_teeth) {
  const BustBody& body = adult_body();
  const Pose pose = build_pose({{"chin", "down", 0.8}, {"lips", "upper", 0.7}});
  const CarvedMouth mouth = compute_carved_mouth(body, adult(), pose);
  CarvedMouth toothless = mouth;
  for (ToothRow* row : {&toothless.upper, &toothless.lower})
    for (int i = 0; i < kToothSamples; ++i) row->edge[i] = row->front[i] = {0, kNoTooth_mm};
  const PatchPlace place{{0, -60, 96}, {0, -90, 90}, 3.0f / kPatchRows, 3};
  EXPECT_GT(place_in_mouth(mouth, place).z, place_in_mouth(toothless, place).z + 2);
}

TEST(bust_body, is_the_same_each_time) {
  const BustBody again = build_bust_body(adult(), {});
  EXPECT_EQ(again.triangles, adult_body().triangles);
  EXPECT_EQ(place_bust(again, adult(), build_pose({{"corner", "up", 0.7}})),
            place_bust(adult_body(), adult(), build_pose({{"corner", "up", 0.7}})));
}

TEST(bust_body, other_heads_at_other_heights_are_closed) {
  HeadSpec infant;
  infant.age = {{"infant", 1.0}};
  HeadSpec square;
  square.skull = {{"square", 1.0}};
  for (const auto& [spec, height_mm] : {std::pair{infant, 40.0}, std::pair{square, 150.0}}) {
    const Figure figure = build_figure(shipped().heads, spec);
    BustSize size;
    size.whole_mm = height_mm;
    size.figure_mm = height_mm * 0.9;
    const BustBody body = build_bust_body(figure, size);
    for (const Pose& pose : {Pose{}, build_pose({{"corner", "up", 1}, {"chin", "down", 0.6}}),
                             build_pose({{"lid", "upper", -1}, {"brow", "up", -1}})}) {
      const Mesh mesh = build_closed(body, place_bust(body, figure, pose));
      EXPECT_EQ(count_open_edges(mesh.triangles), 0U);
      EXPECT_GT(compute_volume_mm3(mesh), 0);
    }
  }
}

// Drawn heads.

HeadSpec make_spec(const std::string& design) {
  HeadSpec spec;
  spec.design = {{design, 1.0}};
  return spec;
}

TEST(bust_body, of_drawn_heads_never_passes_through_itself) {
  const auto expressions =
      load_expression_libraries(std::filesystem::path(source_folder()) / "configs/expressions");
  HeadSpec woman = make_spec("comic"), child = woman, infant = make_spec("manga");
  woman.character = -1;  // her lips cross at rest before they are relaxed
  child.age = {{"child", 1.0}};
  infant.age = {{"infant", 1.0}};
  for (const HeadSpec& spec : {woman, child, infant}) {
    const Figure figure = build_figure(shipped().heads, spec, FigureUse::print);
    BustSize size;
    size.triangles = 30000;
    const BustBody body = build_bust_body(figure, size);
    for (const Expression& expression : expressions) {
      if (expression.library != "mien") continue;
      EXPECT_TRUE(find_crossings(place_bust(body, figure, expression.pose), body.triangles).empty())
          << spec.age.begin()->first << ' ' << expression.name;
    }
  }
}

TEST(bust_body, goes_through_the_lens_when_all_is_carved) {
  const Figure figure = build_figure(shipped().heads, make_spec("comic"), FigureUse::print);
  const BustBody body = build_bust_body(figure, {});
  const Pose pose = build_pose({{"eye", "side", 0.5}});
  const std::vector<glm::vec3> straight = place_straight(body, figure, pose),
                               print = place_bust(body, figure, pose);
  const auto measure = [](const std::vector<glm::vec3>& points, const Patch& patch) {
    Box box{glm::vec3(1e9f), glm::vec3(-1e9f)};
    for (std::uint32_t v = patch.first; v < patch.first + patch.vertex_count(); ++v) {
      box.low = glm::min(box.low, points[v]);
      box.high = glm::max(box.high, points[v]);
    }
    return box.high.z - box.low.z;
  };
  for (const Patch& eye : body.eyes) EXPECT_GT(measure(print, eye), 1.25 * measure(straight, eye));
  for (const std::uint32_t v : body.foot) EXPECT_EQ(print[v], straight[v]);
  EXPECT_EQ(place_bust(adult_body(), adult(), pose), place_straight(adult_body(), adult(), pose));
}

TEST(bust_relax, moves_what_crosses_and_nothing_else) {
  // A strip of a sheet, one vertex of which was pulled through it, far from a corner that stays.
  Mesh mesh;
  constexpr std::uint32_t kSide = 12;
  for (std::uint32_t y = 0; y < kSide; ++y)
    for (std::uint32_t x = 0; x < kSide; ++x)
      mesh.positions.emplace_back(float(x), float(y), 0.02f * float((x * 7 + y * 3) % 5));
  for (std::uint32_t y = 0; y + 1 < kSide; ++y)
    for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
      const std::uint32_t a = y * kSide + x;
      mesh.triangles.push_back({a, a + 1, a + kSide + 1});
      mesh.triangles.push_back({a, a + kSide + 1, a + kSide});
    }
  const std::uint32_t pulled = 3 * kSide + 3, fixed = 1 * kSide + 3;
  mesh.positions[pulled] = {5.6f, 3.3f, 0.04f};
  std::vector<bool> is_fixed(mesh.positions.size(), false);
  is_fixed[fixed] = true;
  const BustRelax relax = build_bust_relax(mesh.triangles, is_fixed);
  std::vector<glm::vec3> positions = mesh.positions;
  ASSERT_FALSE(find_crossings(positions, mesh.triangles).empty());
  relax_crossings(
      relax, mesh.triangles, [](std::vector<glm::vec3>&) {}, positions);
  EXPECT_TRUE(find_crossings(positions, mesh.triangles).empty());
  EXPECT_EQ(positions[fixed], mesh.positions[fixed]);
  for (const std::uint32_t far : {kSide * kSide - 1, kSide - 1, 11 * kSide})
    EXPECT_EQ(positions[far], mesh.positions[far]);
}

// Controls.

struct Controlled {
  PosableBust bust;
  std::vector<NamedPose> poses;
};

const Controlled& controlled() {
  static const Controlled made = [] {
    Controlled c;
    c.poses = {{"neutral", Pose{}},
               {"laugh", build_pose({{"chin", "down", 0.6},
                                     {"corner", "up", 0.9},
                                     {"corner", "out", 0.7},
                                     {"lips", "upper", 0.4},
                                     {"lid", "lower", 0.7}})},
               {"shout", build_pose({{"chin", "down", 1}, {"brow", "turn", -0.8}, {"lid", "upper", 0.6}})}};
    add_bust_controls(adult_body(), adult(), c.poses, 0.02, 0.1, c.bust);
    return c;
  }();
  return made;
}

float compute_worst_mm(const std::vector<glm::vec3>& sum, const Pose& pose) {
  const BustBody& body = adult_body();
  const std::vector<glm::vec3> truth = place_bust(body, adult(), pose);
  std::vector<bool> is_placed(truth.size(), false);
  for (const Patch* patch : {&body.eyes[0], &body.eyes[1], &body.mouth})
    std::fill_n(is_placed.begin() + patch->first, patch->vertex_count(), true);
  float worst = 0;
  for (std::size_t v = 0; v < truth.size(); ++v)
    if (!is_placed[v]) worst = std::max(worst, glm::distance(sum[v], truth[v]));
  return worst;
}

TEST(bust_controls, every_move_alone_is_the_faces_own) {
  std::mt19937 random(7);
  for (std::size_t m = 0; m < kMoveCount; ++m)
    for (int i = 0; i < 4; ++i) {
      Pose pose;
      pose.values[m] = i == 0 ? kMoves[m].high
                       : i == 1
                           ? kMoves[m].low
                           : std::uniform_real_distribution<double>(kMoves[m].low, kMoves[m].high)(random);
      const std::vector<double> values(pose.values.begin(), pose.values.end());
      EXPECT_LT(compute_worst_mm(sum_bust_states(controlled().bust, values), pose), 0.05f)
          << kMoves[m].area << ' ' << kMoves[m].move << ' ' << pose.values[m];
    }
}

TEST(bust_controls, an_expression_is_the_faces_own_with_its_state) {
  for (std::size_t i = 0; i < controlled().poses.size(); ++i) {
    const BustExpression& expression = controlled().bust.expressions[i];
    EXPECT_EQ(expression.name, controlled().poses[i].name);
    std::vector<glm::vec3> sum = sum_bust_states(controlled().bust, expression.values);
    const BustState& state = controlled().bust.states[expression.state];
    for (std::size_t k = 0; k < state.vertices.size(); ++k) sum[state.vertices[k]] += state.offsets[k];
    EXPECT_LT(compute_worst_mm(sum, controlled().poses[i].pose), 0.11f) << expression.name;
  }
}

TEST(bust_controls, neutral_has_nothing_to_add) {
  EXPECT_TRUE(controlled().bust.states[controlled().bust.expressions[0].state].vertices.empty());
}

}  // namespace
}  // namespace mien

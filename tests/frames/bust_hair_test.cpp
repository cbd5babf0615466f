// Drawn busts wear their hair: one closed body with the head, a step at its edge, still while the face moves.
#include "frames/bust_hair.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "config/load_spec.hpp"
#include "core/crossings.hpp"
#include "frames/bust_body.hpp"
#include "places.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

HeadSpec make_spec(const std::string& hair, const std::string& design = "comic",
                   const std::string& age = "") {
  HeadSpec spec;
  spec.hair = hair;
  if (!design.empty()) spec.design = {{design, 1.0}};
  if (!age.empty()) spec.age = {{age, 1.0}};
  return spec;
}

Figure make_figure(const HeadSpec& spec) { return build_figure(shipped().heads, spec, FigureUse::print); }

std::vector<Pose> list_poses() {
  std::vector<Pose> poses;
  for (const Expression& expression :
       load_expression_libraries(std::filesystem::path(source_folder()) / "configs/expressions"))
    if (expression.library == "mien" && (expression.name == "neutral" || expression.name == "laugh" ||
                                         expression.name == "surprise" || expression.name == "anger"))
      poses.push_back(expression.pose);
  return poses;
}

TEST(bust_hair, is_one_closed_body_with_the_head) {
  const std::vector<Pose> poses = list_poses();
  ASSERT_EQ(poses.size(), 4U);
  for (const HeadSpec& spec :
       {make_spec("bob"), make_spec("crop"), make_spec("curls", "manga"), make_spec("long", "manga", "child"),
        make_spec("ponytail", "comic", "infant"), make_spec("bun", "manga", "old")}) {
    const Figure figure = make_figure(spec);
    BustSize size;
    size.triangles = 40000;
    const BustBody body = build_bust_body(figure, size);
    ASSERT_TRUE(body.hair.is_on()) << spec.hair;
    const std::vector<Loop> loops = find_boundary_loops(body.triangles);
    ASSERT_EQ(loops.size(), 1U) << spec.hair;
    EXPECT_EQ(loops[0].size(), body.foot.size()) << spec.hair;
    for (const Pose& pose : poses)
      EXPECT_TRUE(find_crossings(place_bust(body, figure, pose), body.triangles).empty()) << spec.hair;
  }
}

TEST(bust_hair, is_as_high_as_asked_for_and_part_of_the_whole) {
  const Figure figure = make_figure(make_spec("curls"));
  const BustBody body = build_bust_body(figure, {});
  const std::vector<glm::vec3> print = place_bust(body, figure, Pose{});
  EXPECT_NEAR(compute_bounds(print).high.z, 72, 0.1);
  EXPECT_GT(body.kept.size() - body.first_hair, 1000U);
  for (std::uint32_t v = 0; v < body.kept.size(); ++v)
    EXPECT_EQ(v >= body.first_hair, body.kept[v] >= body.hair.first_of_mass()) << v;
}

TEST(bust_hair, is_still_while_the_face_moves) {
  const Figure figure = make_figure(make_spec("bob"));
  const BustBody body = build_bust_body(figure, {});
  const std::vector<glm::vec3> rest = place_bust(body, figure, Pose{});
  std::vector<bool> is_free(body.all_count, false);
  for (const HairMassVertex& v : body.hair.mass) is_free[v.vertex] = v.share == 0;
  for (const Pose& pose : list_poses()) {
    const std::vector<glm::vec3> print = place_bust(body, figure, pose);
    ASSERT_EQ(print.size(), rest.size());
    std::size_t count = 0, moved = 0;
    for (std::uint32_t v = body.first_hair; v < print.size(); ++v) {
      if (!is_free[body.kept[v]]) continue;
      moved += print[v] != rest[v];
      ++count;
    }
    EXPECT_GT(count, 1000U);
    EXPECT_LT(moved, count / 50);  // but for what is relaxed beside its edge
  }
}

TEST(bust_hair, covers_ears_or_leaves_them_whole) {
  const auto measure_breadth = [](const std::string& hair) {
    const Figure figure = make_figure(make_spec(hair));
    const BustBody body = build_bust_body(figure, {});
    const std::vector<HairGround> grounds = list_hair_grounds(figure.head);
    std::size_t ears = 0;
    for (const std::uint32_t v : body.kept) ears += v < grounds.size() && grounds[v] == HairGround::ear;
    return ears;
  };
  EXPECT_EQ(measure_breadth("bob"), 0U);
  EXPECT_GT(measure_breadth("crop"), 100U);
}

TEST(bust_hair, is_not_on_real_heads_nor_painted) {
  for (const HeadSpec& spec : {make_spec("bob", ""), make_spec("bob", "caricature"), make_spec("buzz")}) {
    const Figure figure = make_figure(spec);
    EXPECT_FALSE(wears_hair(figure)) << spec.hair;
    HeadSpec bald = spec;
    bald.hair = "none";
    const BustBody body = build_bust_body(figure, {}), other = build_bust_body(make_figure(bald), {});
    EXPECT_FALSE(body.hair.is_on());
    EXPECT_EQ(body.triangles, other.triangles);
    EXPECT_EQ(place_bust(body, figure, Pose{}), place_bust(other, make_figure(bald), Pose{}));
  }
}

}  // namespace
}  // namespace mien

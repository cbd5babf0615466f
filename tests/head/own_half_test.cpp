// Heads from a half that somebody else has edited.
#include "head/own_half.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/data.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "head/surface.hpp"
#include "scene/wavefront.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

const HeadStock& stock() {
  static const HeadStock stock = shipped().heads;
  return stock;
}

std::vector<glm::dvec3> half_places() { return compute_half_places(stock(), stock().adult.points); }

std::filesystem::path write_half(const std::vector<glm::dvec3>& places, const std::string& name = "half.obj",
                                 const std::vector<Quad>& quads = compute_half_quads(stock())) {
  std::string text;
  append_wavefront(text, places, quads, "half", {});
  const auto file = std::filesystem::path(testing::TempDir()) / "mien_own_half" / name;
  write_file(file, text);
  return file;
}

NeutralHead build(const std::filesystem::path& mesh) {
  HeadSpec spec;
  spec.mesh = FileReference{mesh, {}};
  return build_neutral_head(shipped().heads, spec);
}

std::string find_fault(const std::filesystem::path& mesh) {
  try {
    build(mesh);
  } catch (const InputError& e) {
    Diagnostic diagnostic = e.diagnostics.at(0);
    diagnostic.place.file = std::filesystem::path(diagnostic.place.file).filename();
    return format_diagnostic(diagnostic);
  }
  return "";
}

std::uint32_t point(const char* name) { return find_point(stock().adult, name); }

TEST(own_half, shipped_half_is_what_the_program_makes) {
  const std::string file = read_file(find_data_folder() / "templates/head/half.obj");
  const std::string made = read_file(write_half(half_places()));
  EXPECT_EQ(file.substr(file.find("o half")), made) << "./run half writes it again";
}

TEST(own_half, the_shipped_half_gives_the_shipped_head_bit_for_bit) {
  const NeutralHead plain = build_neutral_head(shipped().heads, HeadSpec{});
  const NeutralHead head = build(find_data_folder() / "templates/head/half.obj");
  EXPECT_TRUE(head.skin.positions == plain.skin.positions);
  EXPECT_EQ(head.eye.centre, plain.eye.centre);
  EXPECT_EQ(head.eye.radius_mm, plain.eye.radius_mm);
}

TEST(own_half, either_half_gives_the_same_head) {
  auto places = half_places();
  places[point("q12_C6")].z += 3;
  const NeutralHead left = build(write_half(places));
  for (glm::dvec3& p : places) p.x = -p.x;
  auto quads = compute_half_quads(stock());
  for (Quad& quad : quads) std::swap(quad[1], quad[3]);
  EXPECT_TRUE(build(write_half(places, "right.obj", quads)).skin.positions == left.skin.positions);
}

TEST(own_half, a_dragged_point_moves_the_skin_there_and_hardly_rings) {
  const NeutralHead plain = build_neutral_head(shipped().heads, HeadSpec{});
  for (const char* name : {"q12_C6", "p_tip", "s1_F1", "M6_12"}) {
    auto places = half_places();
    places[point(name)].z += 5;
    const NeutralHead head = build(write_half(places));
    const auto move = [&](std::size_t v) { return head.skin.positions[v].z - plain.skin.positions[v].z; };
    EXPECT_NEAR(move(point(name)), 5, 0.8) << name;
    for (std::size_t v = 0; v < head.skin.positions.size(); ++v) ASSERT_GT(move(v), -0.5) << name << " " << v;
  }
}

TEST(own_half, another_head_comes_back_as_it_was) {
  HeadSpec spec;
  spec.age = {{"child", 1.0}};
  spec.features = {{"nose_length", 1.0}};
  const HeadForm child = build_form(stock(), spec);
  const HeadForm back = build_own_half(stock(), write_half(compute_half_places(stock(), child.points))).form;
  EXPECT_NEAR(back.eye.radius_mm, child.eye.radius_mm, 0.02 * child.eye.radius_mm);
  EXPECT_LT(glm::distance(back.eye.centre, child.eye.centre), 0.3);
  const auto wanted = compute_half_places(stock(), child.points),
             places = compute_half_places(stock(), back.points);
  for (std::size_t i = 0; i < wanted.size(); ++i)
    EXPECT_LT(glm::distance(places[i], wanted[i]), 0.1) << stock().adult.names[i];
}

TEST(own_half, the_eyeball_follows_its_lids) {
  auto places = half_places();
  for (std::size_t i = 0; i < places.size(); ++i)
    if (has_prefix(stock().adult.names[i], "E0_") || has_prefix(stock().adult.names[i], "E1_") ||
        has_prefix(stock().adult.names[i], "E2_") || has_prefix(stock().adult.names[i], "EB_"))
      places[i] = Eye{}.centre + glm::dvec3(1, 2, 0) + 1.1 * (places[i] - Eye{}.centre);
  const NeutralHead head = build(write_half(places));
  EXPECT_NEAR(head.eye.radius_mm, 14.3, 0.15);
  EXPECT_NEAR(head.eye.centre.x, 32.5, 0.2);
  EXPECT_NEAR(head.eye.centre.y, 2, 0.2);
  for (int i = 0; i < 16; ++i)
    for (const char* ring : {"E0_", "E1_", "E2_"}) {
      const std::uint32_t v = point((ring + std::to_string(i)).c_str());
      EXPECT_GT(glm::distance(glm::dvec3(head.skin.positions[v]), head.eye.centre), head.eye.radius_mm);
    }
}

TEST(own_half, tells_a_mesh_of_other_points_what_it_needs) {
  auto quads = compute_half_quads(stock());
  quads.pop_back();
  EXPECT_EQ(
      find_fault(write_half(half_places(), "other.obj", quads)),
      fmt::format(
          "other.obj: error: {} points and {} faces are not those of the shipped half ({} and {}); "
          "expected templates/head/half.obj with its points moved, or landmarks in 'other.yaml' beside it",
          half_places().size(), quads.size(), half_places().size(), quads.size() + 1));
}

TEST(own_half, tells_what_is_no_half) {
  auto places = half_places();
  const std::size_t cheek = point("q12_C6"), middle = point("p_tip");
  places[cheek].x = -30;
  EXPECT_EQ(find_fault(write_half(places)),
            fmt::format(
                "half.obj:{}: error: not a half: point {} is at x = -30, others are at x = {:.4g}; expected "
                "all on one side of x = 0, to 0.05 mm",
                cheek + 2, cheek + 1, std::ranges::max(places, {}, &glm::dvec3::x).x));
  places = half_places();
  places[middle].x = 0.3;
  EXPECT_EQ(
      find_fault(write_half(places)),
      fmt::format(
          "half.obj:{}: error: point {} (p_tip) of the mid-plane is at x = 0.3; expected x = 0, to 0.05 "
          "mm",
          middle + 2, middle + 1));
  places[middle].x = 0.04;
  EXPECT_EQ(find_fault(write_half(places)), "");
  for (glm::dvec3& p : places) p /= 1000;
  EXPECT_EQ(find_fault(write_half(places)).substr(0, 34), "half.obj: error: the half is 0.344");
}

}  // namespace
}  // namespace mien

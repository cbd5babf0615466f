#include "sheet/comparison.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/error.hpp"
#include "core/text.hpp"
#include "sheet/face_word.hpp"
#include "sheet/proof.hpp"

namespace mien {
namespace {

TEST(sheet_comparison, distances_are_weighed_by_the_skin_around_them) {
  // Two triangles of 1 and of 3 mm^2; of the second only vertex 5 moves, by 4 mm.
  const Mesh skin{
      {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {10, 0, 0}, {12, 0, 0}, {10, 3, 0}}, {}, {{0, 1, 2}, {3, 4, 5}}};
  std::vector<glm::vec3> other = skin.positions;
  other[5].z += 4;
  const SkinDistances distances = measure_distances(skin, other);
  EXPECT_EQ(distances.mm, (std::vector<float>{0, 0, 0, 0, 0, 4}));
  EXPECT_DOUBLE_EQ(distances.mean_mm, 3.0 * 4 / 3 / 4);
  EXPECT_DOUBLE_EQ(distances.most_mm, 4);
  EXPECT_EQ(distances.most, 5u);
  EXPECT_EQ(measure_distances({}, {}).mean_mm, 0);
  EXPECT_EQ(measure_distances(skin, skin.positions).most_mm, 0);
}

TEST(sheet_comparison, a_scale_ends_at_one_two_or_five) {
  for (const auto& [most, end] : {std::pair(0.0, 1.0),
                                  {0.7, 1.0},
                                  {1.0, 1.0},
                                  {1.1, 2.0},
                                  {4.2, 5.0},
                                  {5.1, 10.0},
                                  {37.0, 50.0},
                                  {0.03, 0.05}})
    EXPECT_NEAR(find_scale_end(most), end, 1e-12) << most;
}

TEST(sheet_comparison, landmarks_that_both_have_go_from_the_first_to_the_second) {
  const auto distances = measure_landmark_distances({{"prn", {0, 0, 100}}, {"gn", {0, -100, 80}}},
                                                    {{"prn", {0, 3, 104}}, {"go_l", {}}});
  ASSERT_EQ(distances.size(), 1u);
  EXPECT_EQ(distances[0].name, "prn");
  EXPECT_EQ(distances[0].way_mm, glm::dvec3(0, 3, 4));
  EXPECT_DOUBLE_EQ(distances[0].mm, 5);
}

TEST(sheet_comparison, heat_gets_darker_all_the_way) {
  double before = 2;
  for (int i = 0; i <= 50; ++i) {
    const glm::dvec3 srgb(find_heat(i / 50.0));
    const double bright = glm::dot(srgb, glm::dvec3(0.2126, 0.7152, 0.0722));
    EXPECT_LT(bright, before);
    before = bright;
  }
  EXPECT_EQ(find_heat(-1), find_heat(0));
  EXPECT_EQ(find_heat(7), find_heat(1));
}

std::string find_wrong_word(const std::string& word) {
  try {
    take_face_word({}, word);
  } catch (const InputError& e) {
    return e.what();
  }
  return "none";
}

TEST(sheet_face_word, has_a_file_and_a_time_or_an_expression) {
  Options options;
  options.at_s = 7;
  const Options rest = take_face_word(options, "anna.yaml");
  EXPECT_EQ(rest.file, "anna.yaml");
  EXPECT_FALSE(rest.at_s || rest.express);
  const Options smile = take_face_word(options, "people/anna.yaml@mien/smile");
  EXPECT_EQ(smile.file, "people/anna.yaml");
  EXPECT_EQ(smile.express, "mien/smile");
  EXPECT_FALSE(smile.at_s);
  EXPECT_EQ(take_face_word(options, "a.yaml@1.2s").at_s, 1.2);
  EXPECT_EQ(take_face_word(options, "a.yaml@36f").at_frames, 36);
  EXPECT_FALSE(take_face_word(options, "a.yaml@36f").at_s);
  EXPECT_EQ(find_wrong_word("a.yaml@"),
            "a.yaml@: nothing stands behind the '@'; expected an expression or a time such as 1.2s");
  EXPECT_EQ(find_wrong_word("a.yaml@2x"), "a.yaml@2x: '2x' is not a time such as 1.2s, 500ms or 36f");
}

TEST(sheet_face_word, of_a_file_that_has_an_at_in_its_name_is_the_file) {
  const auto file = std::filesystem::path(testing::TempDir()) / "me@home.yaml";
  write_file(file, "mien: 1\n");
  EXPECT_EQ(take_face_word({}, file.string()).file, file);
  EXPECT_EQ(take_face_word({}, file.string() + "@smile").file, file);
  std::filesystem::remove(file);
}

TEST(sheet_proofs, a_page_has_all_inside_and_tells_what_is_not_shown) {
  const std::string page =
      build_proof_page({{"6-1", "A < B", "claimed", "measured: 1 > 2", false, {{"front", "PNG"}}},
                        {"6-2", "B", "c", "d", true, {}}});
  EXPECT_NE(page.find("1 of 2 claims are shown"), page.npos);
  EXPECT_NE(page.find("A &lt; B"), page.npos);
  EXPECT_NE(page.find("class=\"verdict unmet\">measured: 1 &gt; 2<"), page.npos);
  EXPECT_NE(page.find("src=\"data:image/png;base64,UE5H\""), page.npos);
  EXPECT_EQ(page.find("http"), page.npos) << "it opens without a network";
}

}  // namespace
}  // namespace mien

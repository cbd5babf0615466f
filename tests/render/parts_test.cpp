#include "render/parts.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "core/error.hpp"
#include "core/text.hpp"
#include "render/scratch.hpp"

namespace mien {
namespace {

TEST(parts, are_as_few_as_their_size_allows_and_nearly_equal) {
  EXPECT_EQ(share_out(48, 6, 1000), std::vector<std::size_t>(8, 6));
  EXPECT_EQ(share_out(10, 4, 1000), (std::vector<std::size_t>{4, 3, 3}));
  EXPECT_EQ(share_out(3, 100, 1000), std::vector<std::size_t>{3});
  EXPECT_EQ(share_out(0, 5, 1000), std::vector<std::size_t>{});
}

TEST(parts, are_never_more_than_allowed_and_hold_everything) {
  for (std::size_t count = 1; count < 60; ++count)
    for (std::size_t size = 1; size < 12; ++size)
      for (std::size_t most = 1; most < 9; ++most) {
        const std::vector<std::size_t> shares = share_out(count, size, most);
        EXPECT_LE(shares.size(), most);
        EXPECT_EQ(std::accumulate(shares.begin(), shares.end(), std::size_t{0}), count);
        EXPECT_LE(shares.front() - shares.back(), 1u);
        if (shares.size() < most) {
          EXPECT_LE(shares.front(), size);
        }
      }
}

TEST(parts, are_read_as_they_were_written) {
  const Scratch scratch;
  const PartPlan plan{"0123456789abcdef", 2, {{{0, 1, "aa"}, {1, 7, "bb"}}, {{0, 12, "cc"}}}};
  write_file(scratch.path / "plan.json", build_part_plan(plan));
  const PartPlan read = read_part_plan(scratch.path / "plan.json");
  EXPECT_EQ(build_part_plan(read), build_part_plan(plan));
  EXPECT_EQ(read.identity, "0123456789abcdef");
  EXPECT_EQ(read.size, 2u);
  ASSERT_EQ(read.parts.size(), 2u);
  EXPECT_EQ(read.parts[0][1].clip, 1);
  EXPECT_EQ(read.parts[0][1].frame, 7);
  EXPECT_EQ(read.parts[0][1].key, "bb");
}

TEST(parts, are_not_read_from_anything_else) {
  const Scratch scratch;
  const std::filesystem::path path = scratch.path / "plan.json";
  const auto read = [&] { read_part_plan(path); };
  EXPECT_EQ(find_message<RunError>(read), "cannot read " + path.string() + ": No such file or directory");
  for (const char* text : {"", "{}", "[1]", R"({"plan":"a","size":1,"parts":[[[0]]]})"}) {
    write_file(path, text);
    EXPECT_EQ(find_message<RunError>(read), path.string() + " is no plan of mien's") << text;
  }
}

TEST(parts, know_what_a_drawing_took_for_pictures_of_one_kind) {
  const Scratch scratch;
  const std::filesystem::path path = scratch.path / "cost.json";
  EXPECT_EQ(read_drawing_cost_s(path, "48x60 +Q9"), 0);
  write_file(path, build_drawing_cost("48x60 +Q9", 1.25));
  EXPECT_EQ(read_drawing_cost_s(path, "48x60 +Q9"), 1.25);
  EXPECT_EQ(read_drawing_cost_s(path, "96x60 +Q9"), 0);
  for (const char* text :
       {"", "[]", "{\"pictures\":\"48x60 +Q9\"}", "{\"pictures\":\"48x60 +Q9\",\"seconds\":-1}"}) {
    write_file(path, text);
    EXPECT_EQ(read_drawing_cost_s(path, "48x60 +Q9"), 0) << text;
  }
}

}  // namespace
}  // namespace mien

#include "core/data.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "places.hpp"

namespace mien {
namespace {

namespace fs = std::filesystem;

// An empty folder, with mien's data below it where `data` says.
fs::path make_place(const char* data) {
  const fs::path folder = fs::path(testing::TempDir()) / "mien_data";
  fs::remove_all(folder);
  fs::create_directories(folder / data / "templates/head");
  fs::create_directories(folder / data / "configs/expressions");
  return folder;
}

TEST(data, lie_beside_the_build_folder_of_a_checkout) {
  const fs::path folder = make_place(".");
  EXPECT_EQ(find_data_folder(folder / "build/mien"), folder);
}

TEST(data, lie_below_share_in_an_installation) {
  const fs::path folder = make_place("share/mien");
  EXPECT_EQ(find_data_folder(folder / "bin/mien"), folder / "share/mien");
}

TEST(data, beside_the_build_folder_come_first) {
  const fs::path folder = make_place(".");
  fs::create_directories(folder / "share/mien/templates/head");
  fs::create_directories(folder / "share/mien/configs/expressions");
  EXPECT_EQ(find_data_folder(folder / "bin/mien"), folder);
}

TEST(data, of_half_a_folder_are_none) {
  const fs::path folder = make_place("share/mien");
  fs::remove_all(folder / "share/mien/configs");
  EXPECT_EQ(find_data_folder(folder / "bin/mien"), source_folder());
}

TEST(data, of_a_program_elsewhere_are_the_sources) {
  EXPECT_EQ(find_data_folder("/nowhere/else/mien"), source_folder());
}

}  // namespace
}  // namespace mien

#include "head/part_numbers.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "places.hpp"

namespace mien {
namespace {

class PartNumbersFile : public testing::Test {
 protected:
  // The real file with one text replaced by another.
  std::filesystem::path write_changed(const std::string& from, const std::string& to) {
    std::ifstream in(std::filesystem::path(source_folder()) / "templates/head/parts.yaml");
    std::string text((std::istreambuf_iterator<char>(in)), {});
    const auto at = text.find(from);
    if (at != std::string::npos) text.replace(at, from.size(), to);
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "mien_parts.yaml";
    std::ofstream(file) << text;
    return file;
  }
  static std::string load_error(const std::filesystem::path& file) {
    try {
      load_part_numbers(file);
    } catch (const RunError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(PartNumbersFile, names_the_value_that_is_missing) {
  const auto file = write_changed("  limbus:", "  limbs:");
  EXPECT_EQ(load_error(file), file.string() + ": eye.limbus: a value is missing here");
}

TEST_F(PartNumbersFile, names_the_table_that_is_missing) {
  const auto file = write_changed("  tear:", "  tears:");
  EXPECT_EQ(load_error(file), file.string() + ": eye.tear: a table is missing here");
  const auto other = write_changed("mouth:", "mouths:");
  EXPECT_EQ(load_error(other), other.string() + ": mouth: a table is missing here");
}

TEST_F(PartNumbersFile, names_the_value_of_the_wrong_kind) {
  const auto file = write_changed("  corner: 24.24", "  corner: wide");
  EXPECT_EQ(load_error(file), file.string() + ": mouth.corner: not the numbers expected here");
}

TEST_F(PartNumbersFile, counts_the_stations_of_the_brow) {
  const auto file = write_changed("  station:  [0.25, ", "  station:  [");
  EXPECT_EQ(load_error(file), file.string() + ": brow.above: not as many numbers as 'station' has");
}

TEST_F(PartNumbersFile, wants_a_table_of_tables) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "mien_parts.yaml";
  std::ofstream(file) << "just a word\n";
  EXPECT_EQ(load_error(file), file.string() + ": a table is missing here");
}

}  // namespace
}  // namespace mien

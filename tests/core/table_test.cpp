// Tables: what stands in them is read, what cannot be read is told with its line.
#include "core/table.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "core/error.hpp"

namespace mien {
namespace {

std::filesystem::path write_table(const std::string& text) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "mien_table.csv";
  std::ofstream(file) << text;
  return file;
}

std::string read_error(const std::string& text) {
  const std::filesystem::path file = write_table(text);
  try {
    read_table(file, 2, true, [](const Fields& fields) -> std::string {
      return fields[1] == "wrong" ? "'wrong' is wrong" : "";
    });
  } catch (const RunError& e) {
    return std::string(e.what()).substr(file.parent_path().string().size() + 1);
  }
  return "";
}

TEST(table, skips_comments_empty_lines_and_the_heading) {
  std::string all;
  read_table(write_table("# said\nname,value\r\n\na,1\n# more\nb,\r\n"), 2, true,
             [&](const Fields& fields) -> std::string {
               all += fields[0] + "=" + fields[1] + ";";
               return {};
             });
  EXPECT_EQ(all, "a=1;b=;");
}

TEST(table, tells_the_line_of_what_is_wrong) {
  EXPECT_EQ(read_error("h,h\na,1\nb\n"), "mien_table.csv:3: 1 fields; expected 2");
  EXPECT_EQ(read_error("h,h\n\na,wrong\n"), "mien_table.csv:3: 'wrong' is wrong");
  EXPECT_THROW(read_table("no/such.csv", 2, true, [](const Fields&) { return std::string(); }), RunError);
}

TEST(table, reads_three_fields_as_a_vector) {
  glm::dvec3 v(0);
  EXPECT_EQ(parse_vector({"a", "1", "-2.5", "0"}, 1, v), "");
  EXPECT_EQ(v, glm::dvec3(1, -2.5, 0));
  EXPECT_EQ(parse_vector({"1", "two", "0"}, 0, v), "'two' is not a number");
}

TEST(table, reads_whole_numbers_only) {
  EXPECT_EQ(parse_field("-1.5"), -1.5);
  EXPECT_EQ(parse_field("1.5mm"), std::nullopt);
  EXPECT_EQ(parse_field(""), std::nullopt);
}

}  // namespace
}  // namespace mien

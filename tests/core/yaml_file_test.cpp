#include "core/yaml_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <string>

namespace mien {
namespace {

std::filesystem::path write_data(const std::string& text) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "yaml_file_test.yaml";
  std::ofstream(file) << text;
  return file;
}

std::string find_error(const std::filesystem::path& file,
                       const std::function<void(const YAML::Node&)>& read) {
  try {
    read_yaml_file(file, read);
  } catch (const RunError& e) {
    return e.what();
  }
  return "";
}

TEST(yaml_file, gives_what_is_read) {
  const auto file = write_data("a: {b: 3}\n");
  EXPECT_EQ(read_yaml_file(file, [](const YAML::Node& root) { return root["a"]["b"].as<int>(); }), 3);
}

TEST(yaml_file, tells_where_the_text_is_wrong) {
  const auto file = write_data("a: 1\nb: [1, 2\nc: 3\n");
  EXPECT_THAT(find_error(file, [](const YAML::Node&) {}), testing::StartsWith(file.string() + ":3:"));
}

TEST(yaml_file, tells_where_a_value_is_of_the_wrong_kind) {
  const auto file = write_data("a:\n  b: red\n");
  EXPECT_EQ(find_error(file, [](const YAML::Node& root) { (void)root["a"]["b"].as<double>(); }),
            file.string() + ":2:6: bad conversion");
}

TEST(yaml_file, tells_of_a_file_that_is_not_there) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "no_such.yaml";
  EXPECT_THAT(find_error(file, [](const YAML::Node&) {}),
              testing::AllOf(testing::HasSubstr("cannot read"), testing::HasSubstr(file.string())));
}

}  // namespace
}  // namespace mien

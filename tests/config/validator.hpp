// What a real JSON Schema validator (python3-jsonschema) says of YAML files against our schema.
#pragma once

#include <fmt/format.h>
#include <sys/wait.h>

#include <cstdlib>
#include <map>
#include <sstream>
#include <string>

#include "config/config_fixture.hpp"
#include "config/schema.hpp"

namespace mien {

// What a validator says of each file, by the file's name: accepted, refused or no-yaml. Empty without one.
inline std::map<std::string, std::string> judge(const Names& files) {
  const std::filesystem::path folder = make_test_folder("_schema");
  write_file(folder / "schema.json", build_schema(load_data_words(kData)));
  std::string command = fmt::format("'{}/tests/config/validate_schema.py' '{}'", kData.string(),
                                    (folder / "schema.json").string());
  for (const std::string& file : files) command += fmt::format(" '{}'", file);
  const int status = std::system(fmt::format("{} >'{}'", command, (folder / "said").string()).c_str());
  if (WIFEXITED(status) && (WEXITSTATUS(status) == 77 || WEXITSTATUS(status) == 127)) return {};
  EXPECT_EQ(status, 0);
  std::map<std::string, std::string> said;
  std::istringstream lines(read_file(folder / "said"));
  for (std::string word, name, rest; lines >> word >> name && std::getline(lines, rest);)
    said[name] = word + rest;
  EXPECT_EQ(said.size(), files.size());
  return said;
}

}  // namespace mien

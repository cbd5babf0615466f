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
  std::string list;  // a command line of so many names would be too long
  for (const std::string& file : files) list += file + "\n";
  write_file(folder / "files", list);
  const std::string command =
      fmt::format("'{}/tests/config/validate_schema.py' '{}/schema.json' <'{}/files' >'{}/said'",
                  kData.string(), folder.string(), folder.string(), folder.string());
  const int status = std::system(command.c_str());
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

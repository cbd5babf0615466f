// Data files in YAML, as yaml-cpp reads them: the one place that turns its complaints into ours.
#pragma once

#include <yaml-cpp/yaml.h>

#include <filesystem>

#include "core/error.hpp"

namespace mien {

// What yaml-cpp complains about, with its place: "FILE:LINE:COLUMN: reason"; "FILE: reason" without a place.
RunError build_yaml_error(const std::filesystem::path& file, const YAML::Exception& problem);

// The root of a data file. Throws RunError "cannot read FILE: reason" as read_file does, or as above.
YAML::Node load_yaml_file(const std::filesystem::path& file);

// What `read` makes of a data file's root; whatever yaml-cpp throws meanwhile is thrown as above.
template <typename Read>
auto read_yaml_file(const std::filesystem::path& file, const Read& read) {
  const YAML::Node root = load_yaml_file(file);
  try {
    return read(root);
  } catch (const YAML::Exception& problem) {
    throw build_yaml_error(file, problem);
  }
}

}  // namespace mien

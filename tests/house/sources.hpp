// The project's own sources as text, for the tests that watch over how they are written.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "places.hpp"

namespace mien {

struct SourceFile {
  std::string path;  // from the project's folder: "src/core/mesh.hpp"
  std::vector<std::string> lines;
};

// The C++ files below a folder of the project, by name.
inline std::vector<SourceFile> load_sources(const std::string& folder) {
  const std::filesystem::path root = source_folder();
  std::vector<SourceFile> sources;
  if (!std::filesystem::exists(root / folder)) return sources;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
    const std::filesystem::path ending = entry.path().extension();
    if (ending != ".cpp" && ending != ".hpp") continue;
    SourceFile source{std::filesystem::relative(entry.path(), root).generic_string(), {}};
    std::ifstream in(entry.path());
    for (std::string line; std::getline(in, line);) source.lines.push_back(line);
    sources.push_back(std::move(source));
  }
  std::sort(sources.begin(), sources.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  return sources;
}

}  // namespace mien

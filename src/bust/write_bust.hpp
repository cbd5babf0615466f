// The files of busts: sources, STL, 3MF, reports, previews, plates.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "bust/build_bust.hpp"
#include "core/templates.hpp"
#include "options.hpp"

namespace mien {

// Told of each file as it is complete: its kind ("stl") and its path.
using FileWritten = std::function<void(const std::string& kind, const std::filesystem::path& path)>;

// The files of one bust, each complete or absent. Throws RunError if OpenSCAD or POV-Ray fail, or if what
// OpenSCAD makes of the source is not what was meant.
void write_bust(const MadeBust& made, const std::filesystem::path& folder, const Templates& templates,
                const Options& options, const FileWritten& written);

// The names of all files that write_bust and write_plates may write of the busts with these stems.
std::vector<std::filesystem::path> list_bust_files(const std::vector<std::string>& stems, bool has_plates,
                                                   const Options& options);

// How many files write_bust writes.
int count_bust_files(const Options& options);

// plate_1.stl and so on.
void write_plates(const std::vector<Mesh>& plates, const std::filesystem::path& folder,
                  const FileWritten& written);

}  // namespace mien

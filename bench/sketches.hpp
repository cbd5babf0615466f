// What a sketch costs beside POV-Ray's draft of the same picture, and how near it comes to the good one.
#pragma once

#include <filesystem>
#include <string>

#include "timeline.hpp"

namespace mien {

// A line a figure. `program` is mien's path; `folder` is empty and may be filled.
void measure_sketches(const std::filesystem::path& data, const std::filesystem::path& folder,
                      const std::string& program, const PrintRow& print_row);

}  // namespace mien

// What a sketch costs beside POV-Ray's draft of the same picture, and how near it comes to the good one.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace mien {

// `print_row` prints a name, a value and a remark; `folder` is empty and may be filled.
void measure_sketches(
    const std::filesystem::path& data, const std::filesystem::path& folder, const std::string& program,
    const std::function<void(const std::string&, const std::string&, const std::string&)>& print_row);

}  // namespace mien

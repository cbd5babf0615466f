// Where mien's own data lie: templates/ and configs/ beside the sources, or where an installation has them.
#pragma once

#include <filesystem>

namespace mien {

// The folder that holds `templates/` and `configs/`. The first of these that has both:
//   1. the one above the program's own folder: build/mien of a checkout uses the files beside build/;
//   2. ../share/mien from the program's folder (as CMake was told): bin/mien of an installation;
//   3. the source folder the program was built from: a build folder that lies elsewhere.
// Throws RunError naming the three when none has them.
std::filesystem::path find_data_folder();

// The same for a program that lies at `program`, an absolute path.
std::filesystem::path find_data_folder(const std::filesystem::path& program);

}  // namespace mien

// Where mien's own data lie: templates/ and configs/ beside the sources, or beside an installed binary.
#pragma once

#include <filesystem>

namespace mien {

// The folder that holds `templates/` and `configs/`: the one above the program's own folder if it has them,
// else the source folder the program was built from. Throws RunError naming both when neither has them.
std::filesystem::path find_data_folder();

}  // namespace mien

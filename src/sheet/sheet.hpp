// A sheet: many pictures of heads on one page, to compare them.
#pragma once

#include <filesystem>

#include "frames/resources.hpp"
#include "options.hpp"
#include "sheet/plans.hpp"

namespace mien {

// Renders the sheet of kind `options.kind` (plans.hpp) of what `options.file` names (subject.hpp) to -o, else
// to out/NAME/sheet_KIND.png, and returns its path. --size is a cell's. The picture is complete or absent;
// throws InputError before anything is written.
std::filesystem::path write_sheet(const Options& options, const Resources& resources);

}  // namespace mien

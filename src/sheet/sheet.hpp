// A sheet: many pictures of heads on one page, to compare them.
#pragma once

#include <filesystem>
#include <vector>

#include "config/ledger.hpp"
#include "frames/resources.hpp"
#include "options.hpp"
#include "sheet/plans.hpp"

namespace mien {

// What is written, and what limits hold back of the face that --express or --at asks for.
struct SheetFiles {
  std::vector<std::filesystem::path> paths;
  std::vector<Held> held;
};

// Renders the sheet of kind `options.kind` (plans.hpp) of what `options.file` names (subject.hpp) to -o, else
// to out/NAME/sheet_KIND.png, and says so. --size is a cell's. The picture is complete or absent;
// throws InputError before anything is written.
SheetFiles write_sheet(const Options& options, const Resources& resources);

}  // namespace mien

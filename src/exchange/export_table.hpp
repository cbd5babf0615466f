// A clip as a table of numbers.
#pragma once

#include "exchange/exports.hpp"

namespace mien {

// CSV as `tracks: [{csv: FILE}]` takes it: "time" in seconds, then every move of the areas, a row a frame;
// with --targets arkit as Live Link Face writes it (export_arkit.hpp).
ExportNotes export_table(const ExportWork& work, const std::filesystem::path& path);

}  // namespace mien

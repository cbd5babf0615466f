// A clip as one mesh a frame.
#pragma once

#include "exchange/exports.hpp"

namespace mien {

// OBJ, PLY or STL by the path's ending, as `mien mesh` writes them, with the frame's number in each name.
ExportNotes export_sequence(const ExportWork& work, const std::filesystem::path& path);

}  // namespace mien

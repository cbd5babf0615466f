// A clip as a cache of points: where each vertex of `mien mesh` lies at each frame, for programs that have
// the mesh already.
#pragma once

#include "exchange/exports.hpp"

namespace mien {

// PC2 or MDD by the path's ending.
ExportNotes export_points(const ExportWork& work, const std::filesystem::path& path);

}  // namespace mien

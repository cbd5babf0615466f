// A face in ARKit's units, for programs that take those.
#pragma once

#include "exchange/exports.hpp"

namespace mien {

// CSV as Live Link Face writes it: 52 units, the angles of head and eyes in radians, a row a frame, a
// timecode at the clip's rate.
ExportNotes export_live_link(const ExportWork& work, const std::filesystem::path& path);

// JSON of MPFB's expressions: {"name": .., "face_units": {"jawOpen": 0.4}}, of the first frame.
ExportNotes export_face_units(const ExportWork& work, const std::filesystem::path& path);

}  // namespace mien

// A face with its rig, for programs that pose it themselves.
#pragma once

#include "exchange/exports.hpp"

namespace mien {

// glTF 2.0, binary or text by the path's ending; tells how far its vertices are from ours.
ExportNotes export_gltf(const ExportWork& work, const std::filesystem::path& path);

// USD as text, with UsdSkel; tells the same.
ExportNotes export_usd(const ExportWork& work, const std::filesystem::path& path);

// A script that brings the face into Blender, and beside it the .glb that it reads.
ExportNotes export_script(const ExportWork& work, const std::filesystem::path& path);

// VRM 1.0: a bust on a body's bones, with VRM's presets as targets.
ExportNotes export_vrm(const ExportWork& work, const std::filesystem::path& path);

}  // namespace mien

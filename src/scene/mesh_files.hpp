// One head as a mesh for other programs, in the format that a file's ending names: OBJ, PLY or STL. All are
// right-handed millimetres: x to the character's left, y up, z forward.
#pragma once

#include <string>
#include <vector>

#include "core/model.hpp"

namespace mien {

// What a name may end in: ".obj", ".ply", ".stl". A new format is a row of the table in mesh_files.cpp.
std::vector<std::string> list_mesh_endings();

// The content of a file with this ending, one of those. Throws RunError if the drawing does not fit the
// model.
std::string build_mesh_file(const std::string& ending, const Model& model, const Drawing& drawing,
                            const std::string& title);

// PLY, binary and little-endian: vertices with normal and colour (the part's shade, 8 bits a channel), faces
// with `part`, the part's number; the header's comments name the parts: "comment part 0 skin".
std::string build_ply(const Model& model, const Drawing& drawing, const std::string& title);

// STL, binary: all parts one after the other, with a normal a triangle.
std::string build_stl(const Model& model, const Drawing& drawing, const std::string& title);

// One mesh as binary STL.
std::string build_binary_stl(const Mesh& mesh, const std::string& title);

// The part's vertices as they stand in the drawing, with the normals it has or, if it has none, its
// surface's.
Mesh place_part(const Part& part, const PartShape& shape);

// Throws RunError "internal: a drawing of 0 parts for a model of 3".
void check_drawing(const Model& model, const Drawing& drawing);

}  // namespace mien

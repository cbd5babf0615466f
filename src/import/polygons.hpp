// A mesh of somebody else's: positions and polygons, as read from OBJ, PLY, STL or glTF; or a cloud of
// positions alone.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace mien {

// Larger files are refused: what a head needs is a fiftieth of it, and memory stays below a gigabyte.
inline constexpr std::size_t kMaxGeometryPoints = 2'000'000;
inline constexpr std::uintmax_t kMaxGeometryBytes = 200'000'000;
// Coordinates further out are no head in any unit; their squares would lose the digits that count.
inline constexpr double kMaxCoordinate = 1e6;

// Face f has the corners [first[f], first[f + 1]), indices of positions, three at least. Example, one
// triangle: positions {(0,0,0),(1,0,0),(0,1,0)}, corners {0,1,2}, first {0,3}.
struct Polygons {
  std::string file;                   // as messages name it
  std::vector<glm::dvec3> positions;  // in the file's own unit; finite, within kMaxCoordinate
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> first{0};
  std::vector<std::uint32_t> lines;  // each position's line in the file; empty if it is not text
  std::vector<glm::dvec3>
      normals;  // one a position, of any length, where a cloud's file has them; else empty

  // Positions and faces were made of what the file has: of surfaces with control points, or of slices. Its
  // numbers of points are not ours then.
  bool is_made = false;
  std::size_t surfaces = 0, slices = 0;  // that they were made of
  std::vector<Diagnostic> warnings;      // of what was passed over

  std::size_t face_count() const { return first.size() - 1; }
};

// What a name may end in: ".obj", ".ply", ... A new format is a row of the table in polygons.cpp.
std::vector<std::string> list_geometry_endings();

// Whether the name's ending is one of them, letters of either case.
bool is_geometry_name(const std::filesystem::path& file);

enum class Faces { needed, optional };

// Reads the file by its ending. The result has at least one face (or, with Faces::optional, one position) and
// all its indices are right. STL's triangles share the points that are equal to the last digit. Throws
// InputError "FILE:LINE: what was found; what was expected" (or with the offset of the byte, in binary files)
// for anything else.
Polygons load_polygons(const std::filesystem::path& file, Faces faces = Faces::needed);

}  // namespace mien

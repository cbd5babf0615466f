#include "import/polygons.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "import/reading.hpp"

namespace mien {

namespace {

// The whole file, if it is one that may be read.
std::string read_bytes(const std::filesystem::path& path, const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) fail_file(file, "there is no such file; expected a mesh");
  if (fs::is_directory(status)) fail_file(file, "is a folder; expected a mesh");
  if (!fs::is_regular_file(status)) fail_file(file, "is no plain file; expected a mesh");
  const std::uintmax_t size = fs::file_size(path, error);
  if (!error && size > kMaxGeometryBytes)
    fail_file(file, fmt::format("has {} bytes; expected {} at most", size, kMaxGeometryBytes));
  try {
    return read_file(path);
  } catch (const RunError&) {
    fail_file(file, "cannot be read; expected a file that you may read");
  }
}

}  // namespace

bool is_geometry_name(const std::filesystem::path& file) {
  const std::string ending = find_ending(file);
  return ending == ".obj" || ending == ".ply" || ending == ".stl";
}

Polygons load_polygons(const std::filesystem::path& path, Faces faces) {
  const std::string file = path.string(), ending = find_ending(path);
  if (!is_geometry_name(path)) fail_file(file, "the name ends otherwise; expected .obj, .ply or .stl");
  const std::string bytes = read_bytes(path, file);
  if (bytes.find_first_not_of(" \t\r\n") == std::string::npos) fail_file(file, "is empty; expected a mesh");
  Polygons mesh = ending == ".obj"   ? read_obj(file, bytes)
                  : ending == ".ply" ? read_ply(file, bytes)
                                     : read_stl(file, bytes);
  mesh.file = file;
  if (mesh.face_count() == 0 && faces == Faces::needed)
    fail_file(file, "has no faces; expected a surface of triangles or quads");
  if (mesh.positions.empty()) fail_file(file, "has no points; expected a surface or a cloud of points");
  // Of a surface the faces tell; and normals count only if each position has one.
  if (mesh.face_count() > 0 || mesh.normals.size() != mesh.positions.size()) mesh.normals.clear();
  return mesh;
}

}  // namespace mien

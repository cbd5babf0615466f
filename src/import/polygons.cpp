#include "import/polygons.hpp"

#include "core/text.hpp"
#include "import/reading.hpp"

namespace mien {

bool is_geometry_name(const std::filesystem::path& file) {
  const std::string ending = find_ending(file);
  return ending == ".obj" || ending == ".ply" || ending == ".stl" || ending == ".glb" || ending == ".gltf";
}

Polygons load_polygons(const std::filesystem::path& path, Faces faces) {
  const std::string file = path.string(), ending = find_ending(path);
  if (!is_geometry_name(path))
    fail_file(file, "the name ends otherwise; expected .obj, .ply, .stl, .glb or .gltf");
  const std::string bytes = read_plain_file(path, file, "a mesh", kMaxGeometryBytes);
  if (bytes.find_first_not_of(" \t\r\n") == std::string::npos) fail_file(file, "is empty; expected a mesh");
  Polygons mesh = ending == ".obj"   ? read_obj(file, bytes)
                  : ending == ".ply" ? read_ply(file, bytes)
                  : ending == ".stl" ? read_stl(file, bytes)
                                     : read_gltf(file, bytes);
  mesh.file = file;
  if (mesh.face_count() == 0 && faces == Faces::needed)
    fail_file(file, "has no faces; expected a surface of triangles or quads");
  if (mesh.positions.empty()) fail_file(file, "has no points; expected a surface or a cloud of points");
  // Of a surface the faces tell; and normals count only if each position has one.
  if (mesh.face_count() > 0 || mesh.normals.size() != mesh.positions.size()) mesh.normals.clear();
  return mesh;
}

}  // namespace mien

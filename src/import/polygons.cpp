#include "import/polygons.hpp"

#include <algorithm>
#include <array>

#include "core/text.hpp"
#include "import/reading.hpp"

namespace mien {

namespace {

struct GeometryFormat {
  const char* ending;
  Polygons (*read)(const std::string& file, std::string_view bytes);
};

constexpr std::array kGeometryFormats{
    GeometryFormat{".obj", read_obj},    GeometryFormat{".ply", read_ply},
    GeometryFormat{".stl", read_stl},    GeometryFormat{".glb", read_gltf},
    GeometryFormat{".gltf", read_gltf},  GeometryFormat{".xyz", read_points},
    GeometryFormat{".pts", read_points}, GeometryFormat{".asc", read_points},
    GeometryFormat{".csv", read_points},
};

const GeometryFormat* find_format(const std::filesystem::path& file) {
  const auto format = std::ranges::find(kGeometryFormats, find_ending(file),
                                        [](const GeometryFormat& each) { return std::string(each.ending); });
  return format == kGeometryFormats.end() ? nullptr : format;
}

// ".obj, .ply or .stl".
std::string join_geometry_endings() {
  std::string text;
  for (std::size_t i = 0; i < kGeometryFormats.size(); ++i)
    text += (i == 0                            ? ""
             : i + 1 < kGeometryFormats.size() ? ", "
                                               : " or ") +
            std::string(kGeometryFormats[i].ending);
  return text;
}

}  // namespace

std::vector<std::string> list_geometry_endings() {
  std::vector<std::string> endings;
  for (const GeometryFormat& format : kGeometryFormats) endings.emplace_back(format.ending);
  return endings;
}

bool is_geometry_name(const std::filesystem::path& file) { return find_format(file) != nullptr; }

Polygons load_polygons(const std::filesystem::path& path, Faces faces) {
  const std::string file = path.string();
  const GeometryFormat* format = find_format(path);
  if (format == nullptr) fail_file(file, "the name ends otherwise; expected " + join_geometry_endings());
  const std::string bytes = read_plain_file(path, file, "a mesh", kMaxGeometryBytes);
  if (bytes.find_first_not_of(" \t\r\n") == std::string::npos) fail_file(file, "is empty; expected a mesh");
  Polygons mesh = format->read(file, bytes);
  mesh.file = file;
  if (mesh.face_count() == 0 && faces == Faces::needed)
    fail_file(file, "has no faces; expected a surface of triangles or quads");
  if (mesh.positions.empty()) fail_file(file, "has no points; expected a surface or a cloud of points");
  // Of a surface the faces tell; and normals count only if each position has one.
  if (mesh.face_count() > 0 || mesh.normals.size() != mesh.positions.size()) mesh.normals.clear();
  return mesh;
}

}  // namespace mien

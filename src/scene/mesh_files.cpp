// PLY: Greg Turk, "The PLY Polygon File Format" (1994). STL: StereoLithography Interface Specification, 3D
// Systems 1989.
#include "scene/mesh_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string_view>

#include "core/error.hpp"
#include "scene/title.hpp"
#include "scene/wavefront.hpp"

namespace mien {

namespace {

constexpr std::size_t kStlHeader = 80;  // bytes of anything but "solid", which would announce text

void append_le32(std::string& bytes, std::uint32_t value) {
  for (const int shift : {0, 8, 16, 24}) bytes += static_cast<char>(value >> shift & 0xff);
}

void append_vector(std::string& bytes, const glm::vec3& v) {
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(v[i])) throw RunError("internal: a mesh holds a number that is not finite");
    append_le32(bytes, std::bit_cast<std::uint32_t>(v[i] + 0.0f));  // folds -0
  }
}

void append_colour(std::string& bytes, const glm::vec3& srgb) {
  for (int i = 0; i < 3; ++i) bytes += static_cast<char>(std::lround(std::clamp(srgb[i], 0.0f, 1.0f) * 255));
}

const Shade& find_shade(const Part& part, std::size_t vertex) {
  return part.palette.at(part.shade.empty() ? 0 : part.shade[vertex]);
}

std::string build_ply_header(const Model& model, const std::string& title) {
  std::size_t vertices = 0, faces = 0;
  std::string parts;
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    vertices += model.parts[i].rest.positions.size();
    faces += model.parts[i].rest.triangles.size();
    parts += fmt::format("comment part {} {}\n", i, model.parts[i].name);
  }
  std::string header = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment {}\n"
      "comment millimetres; x to the character's left, y up, z forward\n{}element vertex {}\n",
      clean_title(title), parts, vertices);
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
    header += fmt::format("property float {}\n", name);
  for (const char* name : {"red", "green", "blue"}) header += fmt::format("property uchar {}\n", name);
  return header + fmt::format(
                      "element face {}\nproperty list uchar uint vertex_indices\nproperty int part\n"
                      "end_header\n",
                      faces);
}

}  // namespace

void check_drawing(const Model& model, const Drawing& drawing) {
  if (drawing.parts.size() != model.parts.size())
    throw RunError(fmt::format("internal: a drawing of {} parts for a model of {}", drawing.parts.size(),
                               model.parts.size()));
}

Mesh place_part(const Part& part, const PartShape& shape) {
  Mesh mesh{{}, {}, part.rest.triangles};
  if (!is_carried(part, shape)) {
    mesh.positions = shape.positions;
    mesh.normals = shape.normals;
  } else {
    const glm::mat3 turn(shape.world_from_rest);
    for (const glm::vec3& p : part.rest.positions)
      mesh.positions.emplace_back(shape.world_from_rest * glm::vec4(p, 1));
    for (const glm::vec3& n : part.rest.normals) mesh.normals.push_back(turn * n);
  }
  if (mesh.normals.size() != mesh.positions.size()) update_normals(mesh);
  return mesh;
}

std::string build_ply(const Model& model, const Drawing& drawing, const std::string& title) {
  check_drawing(model, drawing);
  std::string bytes = build_ply_header(model, title);
  std::string faces;
  std::uint32_t first = 0;
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const Part& part = model.parts[i];
    const Mesh mesh = place_part(part, drawing.parts[i]);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      append_vector(bytes, mesh.positions[v]);
      append_vector(bytes, mesh.normals[v]);
      append_colour(bytes, find_shade(part, v).srgb);
    }
    for (const Triangle& triangle : mesh.triangles) {
      faces += '\3';
      for (const std::uint32_t v : triangle) append_le32(faces, first + v);
      append_le32(faces, static_cast<std::uint32_t>(i));
    }
    first += static_cast<std::uint32_t>(mesh.positions.size());
  }
  return bytes + faces;
}

std::string build_binary_stl(const Mesh& mesh, const std::string& title) {
  std::string bytes = "mien, millimetres: " + clean_title(title);
  bytes.resize(kStlHeader, ' ');
  append_le32(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& [a, b, c] : mesh.triangles) {
    const glm::vec3 &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
    const glm::vec3 across = glm::cross(q - p, r - p);
    const float length = glm::length(across);
    append_vector(bytes, length > 0 ? across / length : glm::vec3(0));
    for (const glm::vec3& corner : {p, q, r}) append_vector(bytes, corner);
    bytes += std::string(2, '\0');
  }
  return bytes;
}

std::string build_stl(const Model& model, const Drawing& drawing, const std::string& title) {
  check_drawing(model, drawing);
  Mesh all;
  for (std::size_t i = 0; i < model.parts.size(); ++i)
    append_mesh(all, place_part(model.parts[i], drawing.parts[i]));
  return build_binary_stl(all, title);
}

namespace {

std::string build_obj(const Model& model, const Drawing& drawing, const std::string& title) {
  std::string text;
  append_wavefront(text, model, drawing, title);
  return text;
}

struct MeshFormat {
  std::string_view ending;
  std::string (*build)(const Model& model, const Drawing& drawing, const std::string& title);
};

// In the order in which messages tell them.
constexpr std::array kMeshFormats{
    MeshFormat{".obj", build_obj},
    MeshFormat{".ply", build_ply},
    MeshFormat{".stl", build_stl},
};

}  // namespace

std::vector<std::string> list_mesh_endings() {
  std::vector<std::string> endings;
  for (const MeshFormat& format : kMeshFormats) endings.emplace_back(format.ending);
  return endings;
}

std::string build_mesh_file(const std::string& ending, const Model& model, const Drawing& drawing,
                            const std::string& title) {
  for (const MeshFormat& format : kMeshFormats)
    if (format.ending == ending) return format.build(model, drawing, title);
  throw RunError(fmt::format("internal: no mesh is written as '{}'", ending));
}

}  // namespace mien

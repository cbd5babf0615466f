// glTF 2.0 (Khronos), binary or as text with its numbers inside: the triangles of the default scene at rest,
// each mesh where its node has it. Points that lie on each other to the last digit are one: glTF has one a
// corner where a picture is cut.
#include <fmt/format.h>

#include <array>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>

#include "import/gltf_file.hpp"
#include "import/reading.hpp"

namespace mien {

namespace {

constexpr int kMostNested = 64;     // nodes within nodes
constexpr int kMostNodes = 100000;  // a node may be named by many
constexpr int kTriangles = 4;

struct Collected {
  GltfFile& gltf;
  int nodes = 0;
  Polygons mesh;
  std::map<std::array<double, 3>, std::uint32_t> known;
};

std::uint32_t add_point(Collected& all, const glm::dvec3& place) {
  for (int k = 0; k < 3; ++k)
    if (!(std::abs(place[k]) <= kMaxCoordinate))
      fail_file(all.gltf.file,
                fmt::format("a coordinate is {:g}; expected numbers within {:g}", place[k], kMaxCoordinate));
  const auto [found, is_new] = all.known.emplace(std::array{place.x, place.y, place.z},
                                                 static_cast<std::uint32_t>(all.mesh.positions.size()));
  if (is_new) {
    all.mesh.positions.push_back(place);
    check_point_count(all.gltf.file, 0, all.mesh.positions.size());
  }
  return found->second;
}

void add_primitive(Collected& all, const GltfJson& primitive, const glm::dmat4& world) {
  GltfFile& gltf = all.gltf;
  if (!primitive.is_object()) fail_file(gltf.file, "a primitive is no object; expected glTF 2.0");
  if (find_gltf_count(gltf, primitive, "mode", kTriangles) != kTriangles)
    return;  // lines, points, strips: no skin
  const auto attributes = primitive.find("attributes");
  if (attributes == primitive.end() || !attributes->is_object() || !attributes->contains("POSITION")) return;
  const GltfNumbers places = find_gltf_numbers(gltf, find_gltf_count(gltf, *attributes, "POSITION", {}),
                                               "VEC3", 3, GltfKind::floats);
  std::vector<std::uint32_t> points;
  for (std::size_t i = 0; i < places.count; ++i) {
    std::array<float, 3> xyz{};
    std::memcpy(xyz.data(), places.bytes.data() + i * places.step, sizeof xyz);
    points.push_back(add_point(all, glm::dvec3(world * glm::dvec4(xyz[0], xyz[1], xyz[2], 1))));
  }
  std::vector<std::uint32_t> corners;
  if (primitive.contains("indices")) {
    const GltfNumbers indices = find_gltf_numbers(gltf, find_gltf_count(gltf, primitive, "indices", {}),
                                                  "SCALAR", 1, GltfKind::whole);
    for (std::size_t i = 0; i < indices.count; ++i) corners.push_back(read_gltf_index(indices, i));
  } else {
    for (std::uint32_t i = 0; i < points.size(); ++i) corners.push_back(i);
  }
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    for (int k = 0; k < 3; ++k)
      if (corners[i + k] >= points.size())
        fail_file(gltf.file, fmt::format("a triangle has the vertex {} of {}; expected one that is there",
                                         corners[i + k], points.size()));
    const std::array corner{points[corners[i]], points[corners[i + 1]], points[corners[i + 2]]};
    if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
    if (all.mesh.first.size() > 3 * kMaxGeometryPoints)
      fail_file(gltf.file,
                fmt::format("it has more than {} triangles; expected fewer", 3 * kMaxGeometryPoints));
    all.mesh.corners.insert(all.mesh.corners.end(), corner.begin(), corner.end());
    all.mesh.first.push_back(static_cast<std::uint32_t>(all.mesh.corners.size()));
  }
}

glm::dmat4 read_transform(const GltfFile& gltf, const GltfJson& node) {
  const auto read = [&](const char* name, std::vector<double> otherwise) {
    const auto found = node.find(name);
    if (found == node.end()) return otherwise;
    if (!found->is_array() || found->size() != otherwise.size())
      fail_file(gltf.file,
                fmt::format("a node's '{}' has no {} numbers; expected glTF 2.0", name, otherwise.size()));
    for (std::size_t i = 0; i < otherwise.size(); ++i) {
      if (!(*found)[i].is_number())
        fail_file(gltf.file, fmt::format("a node's '{}' is no list of numbers; expected glTF 2.0", name));
      otherwise[i] = (*found)[i].get<double>();
    }
    return otherwise;
  };
  const std::vector<double> matrix = read("matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
  const std::vector<double> at = read("translation", {0, 0, 0}), turn = read("rotation", {0, 0, 0, 1});
  const std::vector<double> size = read("scale", {1, 1, 1});
  glm::dmat4 own;
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) own[c][r] = matrix[4 * c + r];
  own = glm::translate(own, glm::dvec3(at[0], at[1], at[2])) *
        glm::mat4_cast(glm::dquat(turn[3], turn[0], turn[1], turn[2]));
  return glm::scale(own, glm::dvec3(size[0], size[1], size[2]));
}

void add_node(Collected& all, std::size_t index, const glm::dmat4& parent, int depth) {
  if (depth > kMostNested)
    fail_file(all.gltf.file,
              fmt::format("nodes lie in each other more than {} deep; expected fewer", kMostNested));
  if (++all.nodes > kMostNodes)
    fail_file(all.gltf.file, fmt::format("it shows more than {} nodes; expected fewer", kMostNodes));
  const GltfJson& node = find_gltf_item(all.gltf, "nodes", index);
  const glm::dmat4 world = parent * read_transform(all.gltf, node);
  if (node.contains("mesh")) {
    const GltfJson& mesh = find_gltf_item(all.gltf, "meshes", find_gltf_count(all.gltf, node, "mesh", {}));
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end() || !primitives->is_array())
      fail_file(all.gltf.file, "a mesh has no 'primitives'; expected glTF 2.0");
    for (const GltfJson& primitive : *primitives) add_primitive(all, primitive, world);
  }
  const auto children = node.find("children");
  if (children == node.end()) return;
  if (!children->is_array()) fail_file(all.gltf.file, "a node's 'children' is no list; expected glTF 2.0");
  for (const GltfJson& child : *children) {
    if (!child.is_number_unsigned())
      fail_file(all.gltf.file, "a node's child is no number; expected glTF 2.0");
    add_node(all, child.get<std::size_t>(), world, depth + 1);
  }
}

}  // namespace

Polygons read_gltf(const std::string& file, std::string_view bytes) {
  GltfFile gltf = open_gltf(file, bytes);
  Collected all{gltf, 0, {}, {}};
  all.mesh.file = file;
  const GltfJson& scenes = find_gltf_list(gltf, "scenes");
  if (scenes.empty()) fail_file(file, "it has no scene; expected one with a head");
  const GltfJson& scene = find_gltf_item(gltf, "scenes", find_gltf_count(gltf, gltf.json, "scene", 0));
  const auto roots = scene.find("nodes");
  if (roots == scene.end() || !roots->is_array())
    fail_file(file, "its scene is empty; expected one with a head");
  for (const GltfJson& root : *roots) {
    if (!root.is_number_unsigned()) fail_file(file, "a scene's node is no number; expected glTF 2.0");
    add_node(all, root.get<std::size_t>(), glm::dmat4(1), 0);
  }
  return std::move(all.mesh);
}

}  // namespace mien

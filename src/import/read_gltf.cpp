// glTF 2.0 (Khronos), binary or as text with its numbers inside: the triangles of the default scene at rest,
// each mesh where its node has it. Points that lie on each other to the last digit are one: glTF has one a
// corner where a picture is cut.
#include <fmt/format.h>

#include <array>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "import/reading.hpp"

namespace mien {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kGlbHeader = 12, kChunkHeader = 8;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBytesChunk = 0x004E4942;
constexpr int kMostNested = 64;     // nodes within nodes
constexpr int kMostNodes = 100000;  // a node may be named by many
constexpr int kFloat = 5126, kTriangles = 4;

struct GltfFile {
  std::string file;
  Json json;
  std::string bytes;  // of the file's own buffer
  std::map<std::size_t, std::string> buffers;
};

std::uint32_t read_le32(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

// The array of this name; an empty one if there is none.
const Json& find_list(const GltfFile& gltf, const char* name) {
  static const Json kNone = Json::array();
  const auto found = gltf.json.find(name);
  if (found == gltf.json.end()) return kNone;
  if (!found->is_array()) fail_file(gltf.file, fmt::format("'{}' is no list; expected glTF 2.0", name));
  return *found;
}

// A whole number that is not negative; `otherwise` if there is none.
std::size_t find_count(const GltfFile& gltf, const Json& object, const char* name,
                       std::optional<std::size_t> otherwise) {
  const auto found = object.find(name);
  if (found == object.end() && otherwise) return *otherwise;
  if (found == object.end() || !found->is_number_unsigned())
    fail_file(gltf.file, fmt::format("'{}' is no whole number where one is needed; expected glTF 2.0", name));
  return found->get<std::size_t>();
}

const Json& find_item(const GltfFile& gltf, const char* list, std::size_t index) {
  const Json& items = find_list(gltf, list);
  if (index >= items.size() || !items[index].is_object())
    fail_file(gltf.file, fmt::format("{} {} is not there; expected glTF 2.0", list, index));
  return items[index];
}

void split_glb(GltfFile& gltf, std::string_view bytes, std::string& text) {
  std::size_t at = kGlbHeader;
  for (int chunk = 0; at + kChunkHeader <= bytes.size(); ++chunk) {
    const std::size_t length = read_le32(bytes, at), kind = read_le32(bytes, at + 4);
    at += kChunkHeader;
    if (length > bytes.size() - at)
      fail_file(gltf.file,
                fmt::format("byte {}: a chunk of {} where {} are left; expected the whole file",
                            at - kChunkHeader, count_bytes(length), count_bytes(bytes.size() - at)));
    if (kind == kJsonChunk) text = bytes.substr(at, length);
    if (kind == kBytesChunk) gltf.bytes = bytes.substr(at, length);
    at += length;
  }
  if (text.empty()) fail_file(gltf.file, "there is no JSON in it; expected glTF 2.0");
}

// RFC 4648; what is no letter of it ends it.
std::string decode_base64(std::string_view text) {
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    static constexpr std::string_view kLetters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::size_t value = kLetters.find(c);
    if (value == std::string_view::npos) break;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xff);
  }
  return bytes;
}

const std::string& find_buffer(GltfFile& gltf, std::size_t index) {
  const Json& buffer = find_item(gltf, "buffers", index);
  const auto uri = buffer.find("uri");
  if (uri == buffer.end()) return gltf.bytes;
  if (const auto known = gltf.buffers.find(index); known != gltf.buffers.end()) return known->second;
  const std::string text = uri->is_string() ? uri->get<std::string>() : "";
  const std::size_t comma = text.find(";base64,");
  if (!text.starts_with("data:") || comma == std::string::npos)
    fail_file(gltf.file, "its numbers lie in another file; expected .glb, or .gltf with all inside");
  return gltf.buffers[index] = decode_base64(std::string_view(text).substr(comma + 8));
}

struct Numbers {
  std::string_view bytes;
  std::size_t count = 0, step = 0;
  int component = 0;
};

// What an accessor names, judged: `width` numbers of `size` bytes an item.
Numbers find_numbers(GltfFile& gltf, std::size_t index, const std::string& type, std::size_t width) {
  const Json& accessor = find_item(gltf, "accessors", index);
  if (accessor.contains("sparse"))
    fail_file(gltf.file, "its places are told as sparse ones; expected plain ones");
  if (accessor.value("type", Json()) != Json(type))
    fail_file(gltf.file, fmt::format("accessor {} is no {}; expected glTF 2.0", index, type));
  Numbers numbers;
  numbers.count = find_count(gltf, accessor, "count", {});
  numbers.component = static_cast<int>(find_count(gltf, accessor, "componentType", {}));
  const std::map<int, std::size_t> sizes{{5121, 1}, {5123, 2}, {5125, 4}, {kFloat, 4}};
  const auto size = sizes.find(numbers.component);
  if (size == sizes.end() || (width == 3) != (numbers.component == kFloat))
    fail_file(gltf.file, fmt::format("accessor {} holds numbers of kind {}; expected {}", index,
                                     numbers.component, width == 3 ? "floats" : "whole ones"));
  const Json& view = find_item(gltf, "bufferViews", find_count(gltf, accessor, "bufferView", {}));
  const std::string& buffer = find_buffer(gltf, find_count(gltf, view, "buffer", {}));
  numbers.step = find_count(gltf, view, "byteStride", width * size->second);
  const std::size_t view_from = find_count(gltf, view, "byteOffset", 0);
  const std::size_t within = find_count(gltf, accessor, "byteOffset", 0);
  const std::size_t length = find_count(gltf, view, "byteLength", {});
  const std::size_t item = width * size->second;
  if (numbers.count > kMaxGeometryBytes || numbers.step > kMaxGeometryBytes || view_from > buffer.size() ||
      length > buffer.size() - view_from || within > length || numbers.step < item ||
      (numbers.count > 0 && (numbers.count - 1) * numbers.step + item > length - within))
    fail_file(gltf.file, fmt::format("accessor {} ends behind its buffer; expected the whole file", index));
  const std::size_t from = view_from + within;
  numbers.bytes = std::string_view(buffer).substr(from);
  return numbers;
}

std::uint32_t read_index(const Numbers& numbers, std::size_t i) {
  const char* at = numbers.bytes.data() + i * numbers.step;
  if (numbers.component == 5121) return static_cast<unsigned char>(*at);
  std::uint16_t two = 0;
  std::uint32_t four = 0;
  if (numbers.component == 5123) return std::memcpy(&two, at, 2), two;
  return std::memcpy(&four, at, 4), four;
}

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

void add_primitive(Collected& all, const Json& primitive, const glm::dmat4& world) {
  GltfFile& gltf = all.gltf;
  if (!primitive.is_object()) fail_file(gltf.file, "a primitive is no object; expected glTF 2.0");
  if (find_count(gltf, primitive, "mode", kTriangles) != kTriangles)
    return;  // lines, points, strips: no skin
  const auto attributes = primitive.find("attributes");
  if (attributes == primitive.end() || !attributes->is_object() || !attributes->contains("POSITION")) return;
  const Numbers places = find_numbers(gltf, find_count(gltf, *attributes, "POSITION", {}), "VEC3", 3);
  std::vector<std::uint32_t> points;
  for (std::size_t i = 0; i < places.count; ++i) {
    std::array<float, 3> xyz{};
    std::memcpy(xyz.data(), places.bytes.data() + i * places.step, sizeof xyz);
    points.push_back(add_point(all, glm::dvec3(world * glm::dvec4(xyz[0], xyz[1], xyz[2], 1))));
  }
  std::vector<std::uint32_t> corners;
  if (primitive.contains("indices")) {
    const Numbers indices = find_numbers(gltf, find_count(gltf, primitive, "indices", {}), "SCALAR", 1);
    for (std::size_t i = 0; i < indices.count; ++i) corners.push_back(read_index(indices, i));
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

glm::dmat4 read_transform(const GltfFile& gltf, const Json& node) {
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
  const Json& node = find_item(all.gltf, "nodes", index);
  const glm::dmat4 world = parent * read_transform(all.gltf, node);
  if (node.contains("mesh")) {
    const Json& mesh = find_item(all.gltf, "meshes", find_count(all.gltf, node, "mesh", {}));
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end() || !primitives->is_array())
      fail_file(all.gltf.file, "a mesh has no 'primitives'; expected glTF 2.0");
    for (const Json& primitive : *primitives) add_primitive(all, primitive, world);
  }
  const auto children = node.find("children");
  if (children == node.end()) return;
  if (!children->is_array()) fail_file(all.gltf.file, "a node's 'children' is no list; expected glTF 2.0");
  for (const Json& child : *children) {
    if (!child.is_number_unsigned())
      fail_file(all.gltf.file, "a node's child is no number; expected glTF 2.0");
    add_node(all, child.get<std::size_t>(), world, depth + 1);
  }
}

}  // namespace

Polygons read_gltf(const std::string& file, std::string_view bytes) {
  GltfFile gltf{file, {}, {}, {}};
  std::string text;
  if (bytes.starts_with("glTF") && bytes.size() >= kGlbHeader)
    split_glb(gltf, bytes, text);
  else
    text = bytes;
  gltf.json = Json::parse(text, nullptr, false);
  if (!gltf.json.is_object()) fail_file(file, "it is no JSON; expected glTF 2.0");
  Collected all{gltf, 0, {}, {}};
  all.mesh.file = file;
  const Json& scenes = find_list(gltf, "scenes");
  if (scenes.empty()) fail_file(file, "it has no scene; expected one with a head");
  const Json& scene = find_item(gltf, "scenes", find_count(gltf, gltf.json, "scene", 0));
  const auto roots = scene.find("nodes");
  if (roots == scene.end() || !roots->is_array())
    fail_file(file, "its scene is empty; expected one with a head");
  for (const Json& root : *roots) {
    if (!root.is_number_unsigned()) fail_file(file, "a scene's node is no number; expected glTF 2.0");
    add_node(all, root.get<std::size_t>(), glm::dmat4(1), 0);
  }
  return std::move(all.mesh);
}

}  // namespace mien

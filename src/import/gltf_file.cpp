#include "import/gltf_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "import/reading.hpp"

namespace mien {

namespace {

constexpr std::size_t kGlbHeader = 12, kChunkHeader = 8;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBytesChunk = 0x004E4942;
constexpr int kFloat = 5126;

std::uint32_t read_le32(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
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

}  // namespace

GltfFile open_gltf(const std::string& file, std::string_view bytes) {
  GltfFile gltf{file, {}, {}, {}};
  std::string text;
  if (bytes.starts_with("glTF") && bytes.size() >= kGlbHeader)
    split_glb(gltf, bytes, text);
  else
    text = bytes;
  gltf.json = GltfJson::parse(text, nullptr, false);
  if (!gltf.json.is_object()) fail_file(file, "it is no JSON; expected glTF 2.0");
  return gltf;
}

const GltfJson& find_gltf_list(const GltfFile& gltf, const char* name) {
  static const GltfJson kNone = GltfJson::array();
  const auto found = gltf.json.find(name);
  if (found == gltf.json.end()) return kNone;
  if (!found->is_array()) fail_file(gltf.file, fmt::format("'{}' is no list; expected glTF 2.0", name));
  return *found;
}

std::size_t find_gltf_count(const GltfFile& gltf, const GltfJson& object, const char* name,
                            std::optional<std::size_t> otherwise) {
  const auto found = object.find(name);
  if (found == object.end() && otherwise) return *otherwise;
  if (found == object.end() || !found->is_number_unsigned())
    fail_file(gltf.file, fmt::format("'{}' is no whole number where one is needed; expected glTF 2.0", name));
  return found->get<std::size_t>();
}

const GltfJson& find_gltf_item(const GltfFile& gltf, const char* list, std::size_t index) {
  const GltfJson& items = find_gltf_list(gltf, list);
  if (index >= items.size() || !items[index].is_object())
    fail_file(gltf.file, fmt::format("{} {} is not there; expected glTF 2.0", list, index));
  return items[index];
}

namespace {

const std::string& find_buffer(GltfFile& gltf, std::size_t index) {
  const GltfJson& buffer = find_gltf_item(gltf, "buffers", index);
  const auto uri = buffer.find("uri");
  if (uri == buffer.end()) return gltf.bytes;
  if (const auto known = gltf.buffers.find(index); known != gltf.buffers.end()) return known->second;
  const std::string text = uri->is_string() ? uri->get<std::string>() : "";
  const std::size_t comma = text.find(";base64,");
  if (!text.starts_with("data:") || comma == std::string::npos)
    fail_file(gltf.file, "its numbers lie in another file; expected .glb, or .gltf with all inside");
  return gltf.buffers[index] = decode_base64(std::string_view(text).substr(comma + 8));
}

}  // namespace

GltfNumbers find_gltf_numbers(GltfFile& gltf, std::size_t index, const std::string& type, std::size_t width,
                              GltfKind kind) {
  const GltfJson& accessor = find_gltf_item(gltf, "accessors", index);
  if (accessor.contains("sparse"))
    fail_file(gltf.file, fmt::format("accessor {} is told as a sparse one; expected a plain one", index));
  if (accessor.value("type", GltfJson()) != GltfJson(type))
    fail_file(gltf.file, fmt::format("accessor {} is no {}; expected glTF 2.0", index, type));
  GltfNumbers numbers;
  numbers.count = find_gltf_count(gltf, accessor, "count", {});
  numbers.component = static_cast<int>(find_gltf_count(gltf, accessor, "componentType", {}));
  const std::map<int, std::size_t> sizes{{5121, 1}, {5123, 2}, {5125, 4}, {kFloat, 4}};
  const auto size = sizes.find(numbers.component);
  if (size == sizes.end() || (kind == GltfKind::floats) != (numbers.component == kFloat))
    fail_file(gltf.file, fmt::format("accessor {} holds numbers of kind {}; expected {}", index,
                                     numbers.component, kind == GltfKind::floats ? "floats" : "whole ones"));
  const GltfJson& view =
      find_gltf_item(gltf, "bufferViews", find_gltf_count(gltf, accessor, "bufferView", {}));
  const std::string& buffer = find_buffer(gltf, find_gltf_count(gltf, view, "buffer", {}));
  numbers.step = find_gltf_count(gltf, view, "byteStride", width * size->second);
  const std::size_t view_from = find_gltf_count(gltf, view, "byteOffset", 0);
  const std::size_t within = find_gltf_count(gltf, accessor, "byteOffset", 0);
  const std::size_t length = find_gltf_count(gltf, view, "byteLength", {});
  const std::size_t item = width * size->second;
  if (numbers.count > kMaxGeometryBytes || numbers.step > kMaxGeometryBytes || view_from > buffer.size() ||
      length > buffer.size() - view_from || within > length || numbers.step < item ||
      (numbers.count > 0 && (numbers.count - 1) * numbers.step + item > length - within))
    fail_file(gltf.file, fmt::format("accessor {} ends behind its buffer; expected the whole file", index));
  const std::size_t from = view_from + within;
  numbers.bytes = std::string_view(buffer).substr(from);
  return numbers;
}

std::vector<float> read_gltf_floats(GltfFile& gltf, std::size_t index, const std::string& type,
                                    std::size_t width) {
  const GltfNumbers numbers = find_gltf_numbers(gltf, index, type, width, GltfKind::floats);
  std::vector<float> floats(numbers.count * width);
  for (std::size_t i = 0; i < numbers.count; ++i)
    std::memcpy(&floats[i * width], numbers.bytes.data() + i * numbers.step, 4 * width);
  for (const float number : floats)
    if (!std::isfinite(number))
      fail_file(gltf.file, fmt::format("accessor {} has a number that is none; expected glTF 2.0", index));
  return floats;
}

std::uint32_t read_gltf_index(const GltfNumbers& numbers, std::size_t i) {
  const char* at = numbers.bytes.data() + i * numbers.step;
  if (numbers.component == 5121) return static_cast<unsigned char>(*at);
  std::uint16_t two = 0;
  std::uint32_t four = 0;
  if (numbers.component == 5123) return std::memcpy(&two, at, 2), two;
  return std::memcpy(&four, at, 4), four;
}

std::optional<std::size_t> find_json_index(const GltfJson& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_number_unsigned()) return std::nullopt;
  return found->get<std::size_t>();
}

const GltfJson* find_json_object(const GltfJson& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_object() ? &*found : nullptr;
}

const GltfJson* find_json_item(const GltfJson& json, const char* key, std::size_t index) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_array() || index >= found->size() || !(*found)[index].is_object())
    return nullptr;
  return &(*found)[index];
}

std::vector<std::string> list_gltf_targets(const GltfJson& mesh) {
  std::vector<std::string> names;
  for (const GltfJson* holder : {&mesh, find_json_item(mesh, "primitives", 0)}) {
    const GltfJson* extras = holder != nullptr ? find_json_object(*holder, "extras") : nullptr;
    if (extras == nullptr || !extras->contains("targetNames") || !(*extras)["targetNames"].is_array())
      continue;
    for (const GltfJson& name : (*extras)["targetNames"])
      names.push_back(name.is_string() ? name.get<std::string>() : "");
    if (!names.empty()) break;
  }
  return names;
}

}  // namespace mien

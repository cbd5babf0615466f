#include "import/vrm_file.hpp"

#include <fmt/format.h>

#include "import/reading.hpp"

namespace mien {

namespace {

constexpr std::uintmax_t kMostVrmBytes = 256U << 20;  // an animation has some megabytes, an avatar some tens

}  // namespace

std::uint32_t read_vrm_word(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 4; i-- > 0;) word = word << 8 | static_cast<unsigned char>(bytes[at + i]);
  return word;
}

void fail_vrm_file(const VrmFile& file, const std::string& message) {
  fail_file(file.file, message + "; expected " + file.expected);
}

VrmFile open_vrm_file(const std::filesystem::path& path, const std::string& expected) {
  VrmFile gltf{
      path.string(), expected, read_plain_file(path, path.string(), expected, kMostVrmBytes), {}, {}};
  const std::string_view bytes = gltf.bytes;
  constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
  if (bytes.size() < 20 || !bytes.starts_with("glTF") || read_vrm_word(bytes, 4) != 2)
    fail_vrm_file(gltf, "does not begin as a binary glTF of version 2 does");
  bool has_json = false;
  for (std::size_t at = 12; at + 8 <= bytes.size();) {
    const std::size_t length = read_vrm_word(bytes, at);
    const std::uint32_t kind = read_vrm_word(bytes, at + 4);
    if (length > bytes.size() - at - 8)
      fail_vrm_file(gltf, fmt::format("the part at byte {} has {} bytes, of which {} are there", at, length,
                                      bytes.size() - at - 8));
    const std::string_view part = bytes.substr(at + 8, length);
    if (kind == kJsonChunk && !has_json) {
      gltf.json = VrmJson::parse(part, nullptr, false);
      has_json = !gltf.json.is_discarded() && gltf.json.is_object();
      if (!has_json) fail_vrm_file(gltf, fmt::format("the part at byte {} is no JSON", at));
    } else if (kind == kBinaryChunk && gltf.binary.empty()) {
      gltf.binary = part;
    }
    at += 8 + length + (4 - length % 4) % 4;
  }
  if (!has_json) fail_vrm_file(gltf, "has no JSON");
  return gltf;
}

// A member that is a whole number from 0 on; empty if it is not.
std::optional<std::size_t> find_json_index(const VrmJson& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_number_unsigned()) return std::nullopt;
  return found->get<std::size_t>();
}

const VrmJson* find_json_object(const VrmJson& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_object() ? &*found : nullptr;
}

const VrmJson* find_json_item(const VrmJson& json, const char* key, std::size_t index) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_array() || index >= found->size() || !(*found)[index].is_object())
    return nullptr;
  return &(*found)[index];
}

}  // namespace mien

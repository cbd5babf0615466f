// glTF 2.0 (Khronos), binary or as text with its numbers inside: its JSON, and the numbers that it speaks of.
// What is wrong lies in binary data and is told by what it is of: all functions throw InputError
// "FILE: error: what was found; expected glTF 2.0".
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

using GltfJson = nlohmann::json;

inline constexpr std::uintmax_t kMostGltfBytes = 512U << 20;  // a minute of a head has some tens of megabytes

struct GltfFile {
  std::string file;
  GltfJson json;      // an object
  std::string bytes;  // of the file's own buffer
  std::map<std::size_t, std::string> buffers;
};

// `bytes` are the file's content.
GltfFile open_gltf(const std::string& file, std::string_view bytes);

// The array of this name; an empty one if there is none.
const GltfJson& find_gltf_list(const GltfFile& gltf, const char* name);

// An object of one of these arrays, and a member that is a whole number from 0 on; `otherwise` if it is not
// there.
const GltfJson& find_gltf_item(const GltfFile& gltf, const char* list, std::size_t index);
std::size_t find_gltf_count(const GltfFile& gltf, const GltfJson& object, const char* name,
                            std::optional<std::size_t> otherwise);

// What an accessor of `width` numbers an item names, judged: they all lie in the file.
struct GltfNumbers {
  std::string_view bytes;
  std::size_t count = 0, step = 0;  // items, and bytes from one to the next
  int component = 0;                // glTF's number of their kind
};
enum class GltfKind { floats, whole };
GltfNumbers find_gltf_numbers(GltfFile& gltf, std::size_t index, const std::string& type, std::size_t width,
                              GltfKind kind);

// Item by item; of whole numbers the i-th.
std::vector<float> read_gltf_floats(GltfFile& gltf, std::size_t index, const std::string& type,
                                    std::size_t width);
std::uint32_t read_gltf_index(const GltfNumbers& numbers, std::size_t i);

// A member that is a whole number from 0 on, an object, or an object in a list; empty if it is not.
std::optional<std::size_t> find_json_index(const GltfJson& json, const char* key);
const GltfJson* find_json_object(const GltfJson& json, const char* key);
const GltfJson* find_json_item(const GltfJson& json, const char* key, std::size_t index);

// The names of a mesh's targets in their order, from the `extras` of the mesh or of its first primitive,
// where exporters put them; none if nobody named them.
std::vector<std::string> list_gltf_targets(const GltfJson& mesh);

}  // namespace mien

// A binary glTF 2.0 of VRM: its JSON, and the bytes that it speaks of. Source: Khronos, glTF 2.0, 4.4.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace mien {

using VrmJson = nlohmann::json;

struct VrmFile {
  std::string file;
  std::string expected;     // what messages say that it should be: "an animation of VRM"
  std::string bytes;        // the whole file
  std::string_view binary;  // of `bytes`
  VrmJson json;             // an object
};

// Throws InputError "FILE: error: what was found; expected ...".
VrmFile open_vrm_file(const std::filesystem::path& path, const std::string& expected);
[[noreturn]] void fail_vrm_file(const VrmFile& file, const std::string& message);

// Four bytes, the least first.
std::uint32_t read_vrm_word(std::string_view bytes, std::size_t at);

// A member that is a whole number from 0 on, an object, or an object in a list; empty if it is not.
std::optional<std::size_t> find_json_index(const VrmJson& json, const char* key);
const VrmJson* find_json_object(const VrmJson& json, const char* key);
const VrmJson* find_json_item(const VrmJson& json, const char* key, std::size_t index);

}  // namespace mien

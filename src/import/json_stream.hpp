// JSON from a file, as it is read: nothing of it is held, and each mistake has its place.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

struct JsonSpot {
  int line = 1, column = 1;  // in characters
};

// Where a value stands: the keys and lists around it.
struct JsonStep {
  bool is_list = false;
  std::string key;     // of an object: the key that is being read
  int role = 0;        // what the reader makes of the list or object
  JsonSpot spot = {};  // where it begins
};

// What a reader does with the values, in the order of the file. `steps` are the lists and objects that are
// open; the last one holds the value.
struct JsonUse {
  using Steps = std::vector<JsonStep>;
  // A list or an object begins; returns its role.
  std::function<int(const Steps& steps, bool is_list, JsonSpot spot)> open;
  // The last of `steps` ends; `spot` is where it begins.
  std::function<void(const Steps& steps, JsonSpot spot)> close;
  std::function<void(const Steps& steps, double value, JsonSpot spot)> number;
  std::function<void(const Steps& steps, const std::string& value, JsonSpot spot)> text;
};

// Throws InputError at the place of what is no JSON, of lists and objects too deep in each other, and of
// texts that are no word; what `use` throws passes. `expected` is said of an empty file: "a take of ARKit".
void read_json_stream(const std::filesystem::path& file, const std::string& expected, const JsonUse& use);

[[noreturn]] void fail_json(const std::string& file, JsonSpot spot, const std::string& message);

}  // namespace mien

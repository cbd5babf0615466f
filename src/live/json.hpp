// JSON of requests and answers.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "config/areas.hpp"
#include "core/error.hpp"
#include "live/server.hpp"

namespace mien {

using Json = nlohmann::ordered_json;

LiveAnswer build_answer(const Json& value);

// An answer of bytes: the length of a JSON object (32 bits, little-endian), the object with spaces up to a
// multiple of 4, and the bytes.
LiveAnswer build_bytes(const Json& header, const std::string& bytes);

// The body of a request, which must be an object. Throws InputError.
Json parse_body(const LiveRequest& request);

// The number of changes that a page knows of: "?version=3", else 0.
int take_version(const LiveRequest& request);

// A member of a request's object. Throw InputError "'frame' is missing; expected a number".
std::string take_text(const Json& object, const char* name);
double take_number(const Json& object, const char* name, double low, double high);
double take_number(const Json& object, const char* name, double low, double high, double otherwise);
bool take_flag(const Json& object, const char* name);

// A mistake or warning with its place.
Json describe_finding(const Diagnostic& diagnostic);

// {"brow.left": {"up": 0.07, ...}, ..., "lips": {...}}, all moves; and back, those that are not there at
// rest. Throws InputError on what is no area, move or number, and holds numbers within twice their limits.
Json describe_values(const Pose& pose);
Pose read_pose(const Json& values);

}  // namespace mien

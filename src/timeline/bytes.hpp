// Numbers as bytes: for telling moments apart.
#pragma once

#include <cstring>
#include <string>

#include <glm/glm.hpp>

namespace mien {

// 0 and -0 alike.
inline void append_bytes(std::string& bytes, double value) {
  value += 0.0;
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

inline void append_bytes(std::string& bytes, const glm::vec3& colour) {
  for (int channel = 0; channel < 3; ++channel) append_bytes(bytes, static_cast<double>(colour[channel]));
}

}  // namespace mien

// Pictures of others, through libpng.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace mien {

struct Picture {
  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t> rgb;  // rows from the top, sRGB
};

// Any PNG; what is transparent in it lies on white. What is wrong with it: "is no picture (...); expected a
// PNG of at most 8192x8192 pixels"; empty if nothing is.
std::string read_picture(const std::filesystem::path& path, Picture& picture);

// The colour at a place, 0..1: x to the right, y up; between pixels a mixture.
glm::vec3 sample_picture(const Picture& picture, const glm::vec2& place);

}  // namespace mien

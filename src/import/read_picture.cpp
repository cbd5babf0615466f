#include "import/read_picture.hpp"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"

namespace mien {

namespace {

constexpr std::uint32_t kMostPixels = 8192;

std::string end_picture(png_image& image, const std::string& fault) {
  png_image_free(&image);
  return fmt::format("{}; expected a PNG of at most {}x{} pixels", fault, kMostPixels, kMostPixels);
}

}  // namespace

std::string read_picture(const std::filesystem::path& path, Picture& picture) {
  const std::string bytes = read_file(path);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0)
    return end_picture(image, fmt::format("is no picture ({})", image.message));
  if (image.width > kMostPixels || image.height > kMostPixels)
    return end_picture(image, fmt::format("is {}x{} pixels", image.width, image.height));
  image.format = PNG_FORMAT_RGB;
  picture = {static_cast<int>(image.width), static_cast<int>(image.height), {}};
  picture.rgb.resize(PNG_IMAGE_SIZE(image));
  const png_color white{255, 255, 255};
  if (png_image_finish_read(&image, &white, picture.rgb.data(), 0, nullptr) == 0)
    return end_picture(image, fmt::format("is damaged ({})", image.message));
  return {};
}

glm::vec3 sample_picture(const Picture& picture, const glm::vec2& place) {
  const auto take = [&](int x, int y) {
    x = std::clamp(x, 0, picture.width_px - 1);
    y = std::clamp(y, 0, picture.height_px - 1);
    const std::uint8_t* pixel = &picture.rgb[3 * (static_cast<std::size_t>(y) * picture.width_px + x)];
    return glm::vec3(pixel[0], pixel[1], pixel[2]) / 255.0f;
  };
  const glm::vec2 at(place.x * static_cast<float>(picture.width_px) - 0.5f,
                     (1 - place.y) * static_cast<float>(picture.height_px) - 0.5f);
  const glm::vec2 low = glm::floor(at), share = at - low;
  const int x = static_cast<int>(low.x), y = static_cast<int>(low.y);
  return glm::mix(glm::mix(take(x, y), take(x + 1, y), share.x),
                  glm::mix(take(x, y + 1), take(x + 1, y + 1), share.x), share.y);
}

}  // namespace mien

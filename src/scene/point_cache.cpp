#include "scene/point_cache.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "core/error.hpp"

namespace mien {

namespace {

enum class Ends { little, big };

void append_word(std::string& bytes, std::uint32_t word, Ends ends) {
  for (int i = 0; i < 4; ++i)
    bytes += static_cast<char>(word >> 8 * (ends == Ends::little ? i : 3 - i) & 0xff);
}

void append_real(std::string& bytes, float number, Ends ends) {
  if (!std::isfinite(number)) throw RunError("internal: a mesh holds a number that is not finite");
  append_word(bytes, std::bit_cast<std::uint32_t>(number + 0.0f), ends);  // folds -0
}

void append_points(std::string& bytes, const PointCache& cache, Ends ends) {
  bytes.reserve(bytes.size() + cache.frames.size() * cache.frames.front().size() * 12);
  for (const std::vector<glm::vec3>& points : cache.frames)
    for (const glm::vec3& point : points)
      for (int k = 0; k < 3; ++k) append_real(bytes, point[k], ends);
}

}  // namespace

std::string build_pc2(const PointCache& cache) {
  using namespace std::string_view_literals;
  std::string bytes("POINTCACHE2\0"sv);
  append_word(bytes, 1, Ends::little);
  append_word(bytes, static_cast<std::uint32_t>(cache.frames.front().size()), Ends::little);
  append_real(bytes, static_cast<float>(cache.first_frame), Ends::little);
  append_real(bytes, 1, Ends::little);
  append_word(bytes, static_cast<std::uint32_t>(cache.frames.size()), Ends::little);
  append_points(bytes, cache, Ends::little);
  return bytes;
}

std::string build_mdd(const PointCache& cache) {
  std::string bytes;
  append_word(bytes, static_cast<std::uint32_t>(cache.frames.size()), Ends::big);
  append_word(bytes, static_cast<std::uint32_t>(cache.frames.front().size()), Ends::big);
  for (std::size_t i = 0; i < cache.frames.size(); ++i)
    append_real(bytes, static_cast<float>(double(i) / cache.fps), Ends::big);
  append_points(bytes, cache, Ends::big);
  return bytes;
}

}  // namespace mien

// Format: StereoLithography Interface Specification, 3D Systems 1989. Binary: 80 bytes of anything, the
// number of triangles, then 50 bytes for each: normal, three corners, two spare bytes; little-endian. ASCII
// begins with "solid", but some binary files do as well: the size of the file decides.
#include "scene/stl.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <map>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/holes.hpp"
#include "core/text.hpp"

namespace mien {

namespace {

constexpr std::size_t kHeaderBytes = 84;    // 80 bytes of anything and the number of triangles
constexpr std::size_t kTriangleBytes = 50;  // 12 floats and two spare bytes
constexpr std::string_view kBlank = " \t\r\n";

// Joins equal corners and makes triangles of them.
struct Welder {
  Mesh mesh;
  std::map<std::array<float, 3>, std::uint32_t> index;

  void add(const std::array<glm::vec3, 3>& corners) {
    Triangle triangle{};
    for (int i = 0; i < 3; ++i) {
      const glm::vec3 p = corners[i] + 0.0f;  // folds -0, which compares equal but must not differ
      const auto [at, is_new] =
          index.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(mesh.positions.size()));
      if (is_new) mesh.positions.push_back(p);
      triangle[i] = at->second;
    }
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
      mesh.triangles.push_back(triangle);
  }
};

std::size_t read_binary_count(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof count);
  return count;
}

Mesh read_binary(std::string_view bytes, const std::string& name) {
  Welder welder;
  for (std::size_t at = kHeaderBytes; at < bytes.size(); at += kTriangleBytes) {
    std::array<glm::vec3, 3> corners;
    std::memcpy(corners.data(), bytes.data() + at + 12, sizeof corners);
    for (const glm::vec3& p : corners)
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        throw RunError(fmt::format("{}: not finite", name));
    welder.add(corners);
  }
  return std::move(welder.mesh);
}

// The next word of `text`, taken off its front; empty at the end.
std::string_view take_word(std::string_view& text) {
  const std::size_t begin = std::min(text.find_first_not_of(kBlank), text.size());
  const std::size_t end = std::min(text.find_first_of(kBlank, begin), text.size());
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

float take_number(std::string_view& text, const std::string& name) {
  const std::string_view word = take_word(text);
  if (word.empty()) throw RunError(fmt::format("{}: cut short", name));
  float value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    throw RunError(fmt::format("{}: not an STL file", name));
  if (!std::isfinite(value)) throw RunError(fmt::format("{}: not finite", name));
  return value;
}

Mesh read_ascii(std::string_view text, const std::string& name) {
  Welder welder;
  std::array<glm::vec3, 3> corners;
  int corner = 0;
  bool is_ended = false;
  text.remove_prefix(std::min(text.find('\n'), text.size()));  // "solid NAME"; the name may be any words
  for (std::string_view word = take_word(text); !word.empty(); word = take_word(text)) {
    is_ended = word == "endsolid";
    if (is_ended) {  // its name may be any words as well
      text.remove_prefix(std::min(text.find('\n'), text.size()));
    } else if (word == "vertex") {
      if (corner == 3) throw RunError(fmt::format("{}: not an STL file", name));
      for (int i = 0; i < 3; ++i) corners[corner][i] = take_number(text, name);
      ++corner;
    } else if (word == "endfacet") {
      if (corner != 3) throw RunError(fmt::format("{}: not an STL file", name));
      welder.add(corners);
      corner = 0;
    }
  }
  if (!is_ended) throw RunError(fmt::format("{}: cut short", name));
  return std::move(welder.mesh);
}

}  // namespace

Mesh read_stl(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  const std::string name = path.string();
  if (bytes.size() >= kHeaderBytes &&
      bytes.size() == kHeaderBytes + kTriangleBytes * read_binary_count(bytes))
    return read_binary(bytes, name);
  if (bytes.starts_with("solid")) return read_ascii(bytes, name);
  const bool is_short =
      bytes.size() >= kHeaderBytes && bytes.size() < kHeaderBytes + kTriangleBytes * read_binary_count(bytes);
  throw RunError(fmt::format("{}: {}", name, is_short ? "cut short" : "not an STL file"));
}

StlFacts measure_stl(const Mesh& mesh) {
  StlFacts facts;
  facts.triangles = mesh.triangles.size();
  facts.parts = split_pieces(mesh).size();
  facts.open_edges = count_open_edges(mesh.triangles);
  facts.volume_mm3 = compute_volume_mm3(mesh);
  facts.box = compute_bounds(mesh.positions);
  return facts;
}

StlFacts check_stl(const std::filesystem::path& path) { return measure_stl(read_stl(path)); }

}  // namespace mien

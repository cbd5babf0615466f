// STL, as text or binary: a bag of triangles, whose equal corners are made one point.
#include <fmt/format.h>
#include <bit>
#include <cstring>
#include <unordered_map>

#include "import/reading.hpp"

namespace mien {

namespace {

constexpr std::size_t kHeader = 80, kFacet = 50;  // bytes

struct Hash {
  std::size_t operator()(const glm::dvec3& p) const {
    std::uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis)
      hash = (hash ^ std::bit_cast<std::uint64_t>(p[axis] + 0.0)) * 0x9E3779B97F4A7C15u;
    return hash ^ (hash >> 32);
  }
};

struct PointMerger {
  std::unordered_map<glm::dvec3, std::uint32_t, Hash> index;
  Polygons mesh;
};

void add_corner(PointMerger& merger, const std::string& file, int line, const glm::dvec3& position) {
  const auto next = static_cast<std::uint32_t>(merger.mesh.positions.size());
  const auto [found, is_new] = merger.index.emplace(position, next);
  if (is_new) {
    merger.mesh.positions.push_back(position);
    check_point_count(file, line, merger.mesh.positions.size());
  }
  merger.mesh.corners.push_back(found->second);
  if (merger.mesh.corners.size() % 3 == 0)
    merger.mesh.first.push_back(static_cast<std::uint32_t>(merger.mesh.corners.size()));
}

std::uint32_t read_count(std::string_view bytes) {
  std::uint32_t count = 0;  // little-endian, as all of STL
  for (int i = 3; i >= 0; --i) count = count << 8 | static_cast<unsigned char>(bytes[kHeader + i]);
  return count;
}

float read_float(std::string_view bytes, std::size_t at) {
  std::uint32_t bits = 0;
  for (int i = 3; i >= 0; --i) bits = bits << 8 | static_cast<unsigned char>(bytes[at + i]);
  return std::bit_cast<float>(bits);
}

Polygons read_binary(const std::string& file, std::string_view bytes) {
  if (bytes.size() < kHeader + 4)
    fail_file(file, fmt::format("ends at byte {}, within its head; expected an STL of 84 bytes at least",
                                bytes.size()));
  const std::size_t count = read_count(bytes), wanted = kHeader + 4 + count * kFacet;
  if (bytes.size() < wanted)
    fail_file(file, fmt::format("ends at byte {}, within triangle {} of {}; expected {} more", bytes.size(),
                                (bytes.size() - kHeader - 4) / kFacet + 1, count,
                                count_bytes(wanted - bytes.size())));
  PointMerger merger;
  for (std::size_t f = 0; f < count; ++f)
    for (std::size_t corner = 1; corner <= 3; ++corner) {
      const std::size_t at = kHeader + 4 + f * kFacet + corner * 12;
      const glm::dvec3 position(read_float(bytes, at), read_float(bytes, at + 4), read_float(bytes, at + 8));
      check_position(file, at, position);
      add_corner(merger, file, 0, position);
    }
  return std::move(merger.mesh);
}

// solid / facet normal .. / outer loop / vertex x y z (three times) / endloop / endfacet / endsolid.
Polygons read_text(const std::string& file, std::string_view bytes) {
  LineReader lines{file, bytes, {}, 0};
  std::vector<std::string_view> words;
  PointMerger merger;
  int corners = 0;
  bool is_ended = false;
  while (read_line(lines)) {
    split_words(lines.line, words);
    if (words.empty()) continue;
    const std::string_view word = words.front();
    is_ended = word == "endsolid";
    if (word == "vertex") {
      if (words.size() != 4)
        fail_line(file, lines.number, fmt::format("a vertex of {} numbers; expected 3", words.size() - 1));
      if (++corners > 3) fail_line(file, lines.number, "a fourth vertex; expected 3 in a facet");
      add_corner(merger, file, lines.number,
                 parse_position(file, lines.number, words[1], words[2], words[3]));
    } else if (word == "endfacet") {
      if (corners != 3)
        fail_line(file, lines.number, fmt::format("a facet of {} vertices; expected 3", corners));
      corners = 0;
    } else if (word != "solid" && word != "facet" && word != "outer" && word != "endloop" && !is_ended) {
      fail_line(file, lines.number,
                fmt::format("unknown word '{}'; expected facet, outer loop, vertex, endloop, endfacet or "
                            "endsolid",
                            show_found(word)));
    }
  }
  if (!is_ended) fail_line(file, lines.number, "the file ends without 'endsolid'; expected a whole STL");
  return std::move(merger.mesh);
}

}  // namespace

Polygons read_stl(const std::string& file, std::string_view bytes) {
  // Some binary files begin with "solid", too: their size tells them.
  const bool is_binary =
      bytes.size() >= kHeader + 4 && bytes.size() == kHeader + 4 + kFacet * std::size_t{read_count(bytes)};
  const bool is_text = bytes.starts_with("solid") && bytes.substr(0, 1000).find('\0') == bytes.npos;
  return !is_binary && is_text ? read_text(file, bytes) : read_binary(file, bytes);
}

}  // namespace mien

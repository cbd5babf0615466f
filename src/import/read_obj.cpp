// Wavefront OBJ as Blender, MeshLab and ZBrush write it: v and f lines count, vn where there are no f; all
// else about looks is passed.
#include <fmt/format.h>
#include <algorithm>
#include <array>

#include "import/reading.hpp"

namespace mien {

namespace {

// What may stand in an OBJ besides v and f and has no bearing on the surface.
constexpr std::array<std::string_view, 17> kPassed{"vn",     "vt",     "vp",     "o",        "g",       "s",
                                                   "l",      "p",      "usemtl", "mtllib",   "mg",      "lod",
                                                   "usemap", "maplib", "bevel",  "c_interp", "d_interp"};

struct ObjReader {
  LineReader lines;
  std::vector<std::string_view> words;
  std::vector<std::uint32_t> face_lines;  // each face's line
  Polygons mesh;
};

void read_point(ObjReader& reader) {
  const auto& words = reader.words;
  // x y z, with a weight, a colour or both behind.
  if (words.size() < 4 || words.size() > 8)
    fail_line(reader.lines.file, reader.lines.number,
              fmt::format("a point of {} number{}; expected v X Y Z", words.size() - 1,
                          words.size() == 2 ? "" : "s"));
  reader.mesh.positions.push_back(
      parse_position(reader.lines.file, reader.lines.number, words[1], words[2], words[3]));
  reader.mesh.lines.push_back(static_cast<std::uint32_t>(reader.lines.number));
  check_point_count(reader.lines.file, reader.lines.number, reader.mesh.positions.size());
}

// Of a cloud, one a point. Broken ones are passed like all that is about looks: too few are none at all.
void read_normal(ObjReader& reader) {
  const auto& words = reader.words;
  glm::dvec3 normal{0};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto value = axis + 1 < words.size() ? parse_coordinate(words[axis + 1]) : std::nullopt;
    if (!value) return;
    normal[static_cast<glm::length_t>(axis)] = *value;
  }
  reader.mesh.normals.push_back(normal);
}

void read_face(ObjReader& reader) {
  const auto& words = reader.words;
  const std::string& file = reader.lines.file;
  const int line = reader.lines.number;
  if (words.size() < 4)
    fail_line(file, line,
              fmt::format("a face of {} point{}; expected 3 at least", words.size() - 1,
                          words.size() == 2 ? "" : "s"));
  for (std::size_t i = 1; i < words.size(); ++i) {
    const auto index = parse_index(words[i].substr(0, words[i].find('/')));
    if (!index)
      fail_line(file, line,
                fmt::format("'{}' names no point; expected a number from 1, as in f 1 2 3 4",
                            show_found(words[i])));
    const auto count = static_cast<long long>(reader.mesh.positions.size());
    if (*index == 0) fail_line(file, line, "a face names point 0; expected numbers from 1");
    const long long at = *index > 0 ? *index - 1 : count + *index;
    if (at < 0 || at >= static_cast<long long>(kMaxGeometryPoints))
      fail_line(file, line,
                fmt::format("a face names point {}; expected numbers from 1 to {}", *index, count));
    reader.mesh.corners.push_back(static_cast<std::uint32_t>(at));
  }
  reader.mesh.first.push_back(static_cast<std::uint32_t>(reader.mesh.corners.size()));
  reader.face_lines.push_back(static_cast<std::uint32_t>(line));
}

// Points may stand behind the faces that use them, so this comes last.
void check_indices(const ObjReader& reader) {
  const Polygons& mesh = reader.mesh;
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    for (std::uint32_t i = mesh.first[f]; i < mesh.first[f + 1]; ++i)
      if (mesh.corners[i] >= mesh.positions.size())
        fail_line(reader.lines.file, static_cast<int>(reader.face_lines[f]),
                  fmt::format("a face names point {}; expected numbers from 1 to {}", mesh.corners[i] + 1,
                              mesh.positions.size()));
}

}  // namespace

Polygons read_obj(const std::string& file, std::string_view bytes) {
  ObjReader reader{{file, bytes, {}, 0}, {}, {}, {}};
  while (read_line(reader.lines)) {
    split_words(reader.lines.line.substr(0, reader.lines.line.find('#')), reader.words);
    if (reader.words.empty()) continue;
    const std::string_view word = reader.words.front();
    if (word == "v") {
      read_point(reader);
    } else if (word == "f") {
      read_face(reader);
    } else if (word == "vn" && reader.mesh.face_count() == 0) {
      read_normal(reader);
    } else if (std::ranges::find(kPassed, word) == kPassed.end()) {
      // What is no OBJ at all is none of this message's business.
      if (reader.mesh.positions.empty())
        fail_line(file, reader.lines.number, "no word of an OBJ file; expected v, f or another one");
      fail_line(
          file, reader.lines.number,
          fmt::format("unknown word '{}'; expected v, f or another word of an OBJ file", show_found(word)));
    }
  }
  check_indices(reader);
  return std::move(reader.mesh);
}

}  // namespace mien

// Wavefront OBJ as Blender, MeshLab and ZBrush write it: v and f lines count, surfaces with control points
// as Rhino and Alias write them, where there is neither l lines as slices, and vn where there are points
// alone; all else about looks is passed.
#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "import/obj_surfaces.hpp"
#include "import/reading.hpp"
#include "import/slices.hpp"

namespace mien {

namespace {

// What may stand in an OBJ besides v and f and has no bearing on the surface.
constexpr std::array<std::string_view, 16> kPassed{"vn",     "vt",     "vp",       "o",       "g",   "s",
                                                   "p",      "usemtl", "mtllib",   "mg",      "lod", "usemap",
                                                   "maplib", "bevel",  "c_interp", "d_interp"};
constexpr std::size_t kMostLineBytes = 16'000'000;  // of one line; its words take ten times as much memory

struct ObjReader {
  LineReader lines;
  std::vector<std::string_view> line_words;
  ObjStatement now;
  ObjSurfaces surfaces;
  std::vector<std::uint32_t> face_lines;  // each face's line
  std::vector<std::uint32_t> corners;     // of l lines
  std::vector<std::uint32_t> ends;        // of each l line, in `corners`
  std::vector<std::uint32_t> l_lines;     // each one's line
  std::vector<double> weights;            // one a point
  Polygons mesh;
};

// The next statement with words: a line, and those after it while a backslash stands at their ends.
bool read_statement(ObjReader& reader) {
  reader.now.words.clear();
  while (read_line(reader.lines)) {
    if (reader.now.words.empty()) reader.now.line = reader.lines.number;
    if (reader.lines.line.size() > kMostLineBytes)
      fail_line(reader.lines.file, reader.lines.number,
                fmt::format("a line of {}; expected {} at most", count_bytes(reader.lines.line.size()),
                            kMostLineBytes));
    std::string_view line = reader.lines.line.substr(0, reader.lines.line.find('#'));
    const std::size_t last = line.find_last_not_of(" \t");
    const bool goes_on = last != line.npos && line[last] == '\\';
    if (goes_on) line = line.substr(0, last);
    split_words(line, reader.line_words);
    reader.now.words.insert(reader.now.words.end(), reader.line_words.begin(), reader.line_words.end());
    if (reader.now.words.size() > kMostLineBytes / 2)
      fail_line(
          reader.lines.file, reader.now.line,
          fmt::format("a line that goes on for more than {} words; expected fewer", kMostLineBytes / 2));
    if (!goes_on && !reader.now.words.empty()) return true;
  }
  return !reader.now.words.empty();
}

void read_point(ObjReader& reader) {
  const auto& words = reader.now.words;
  // x y z, with a weight, a colour or both behind.
  if (words.size() < 4 || words.size() > 8)
    fail_line(reader.lines.file, reader.now.line,
              fmt::format("a point of {} number{}; expected v X Y Z", words.size() - 1,
                          words.size() == 2 ? "" : "s"));
  reader.mesh.positions.push_back(
      parse_position(reader.lines.file, reader.now.line, words[1], words[2], words[3]));
  reader.mesh.lines.push_back(static_cast<std::uint32_t>(reader.now.line));
  const bool has_weight = words.size() == 5 || words.size() == 8;
  reader.weights.push_back(has_weight ? parse_coordinate(words[4]).value_or(NAN) : 1);
  check_point_count(reader.lines.file, reader.now.line, reader.mesh.positions.size());
}

// Of a cloud, one a point. Broken ones are passed like all that is about looks: too few are none at all.
void read_normal(ObjReader& reader) {
  const auto& words = reader.now.words;
  glm::dvec3 normal{0};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto value = axis + 1 < words.size() ? parse_coordinate(words[axis + 1]) : std::nullopt;
    if (!value) return;
    normal[static_cast<glm::length_t>(axis)] = *value;
  }
  reader.mesh.normals.push_back(normal);
}

void read_face(ObjReader& reader) {
  const auto& words = reader.now.words;
  if (words.size() < 4)
    fail_line(reader.lines.file, reader.now.line,
              fmt::format("a face of {} point{}; expected 3 at least", words.size() - 1,
                          words.size() == 2 ? "" : "s"));
  for (std::size_t i = 1; i < words.size(); ++i)
    reader.mesh.corners.push_back(parse_point_number(reader.lines.file, reader.now.line, words[i],
                                                     reader.mesh.positions.size(), "face"));
  reader.mesh.first.push_back(static_cast<std::uint32_t>(reader.mesh.corners.size()));
  reader.face_lines.push_back(static_cast<std::uint32_t>(reader.now.line));
}

// Beside faces they are edges of looks, and not asked.
void read_polyline(ObjReader& reader) {
  if (reader.mesh.face_count() > 0) return;
  const auto& words = reader.now.words;
  if (words.size() < 3)
    fail_line(reader.lines.file, reader.now.line,
              fmt::format("a line of {} point{}; expected 2 at least", words.size() - 1,
                          words.size() == 2 ? "" : "s"));
  for (std::size_t i = 1; i < words.size(); ++i)
    reader.corners.push_back(parse_point_number(reader.lines.file, reader.now.line, words[i],
                                                reader.mesh.positions.size(), "line"));
  reader.ends.push_back(static_cast<std::uint32_t>(reader.corners.size()));
  reader.l_lines.push_back(static_cast<std::uint32_t>(reader.now.line));
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

// Control points lie beside the surface: only those that faces use are kept.
void keep_points_of_faces(Polygons& mesh) {
  constexpr std::uint32_t kUnused = ~0u;
  std::vector<std::uint32_t> number(mesh.positions.size(), kUnused);
  for (const std::uint32_t corner : mesh.corners) number[corner] = 0;
  std::uint32_t next = 0;
  for (std::uint32_t i = 0; i < number.size(); ++i) {
    if (number[i] == kUnused) continue;
    mesh.positions[next] = mesh.positions[i];
    mesh.lines[next] = mesh.lines[i];
    number[i] = next++;
  }
  mesh.positions.resize(next);
  mesh.lines.resize(next);
  for (std::uint32_t& corner : mesh.corners) corner = number[corner];
}

void add_surfaces(ObjReader& reader) {
  const std::string& file = reader.lines.file;
  Polygons& mesh = reader.mesh;
  const ObjSurfaces& surfaces = reader.surfaces;
  const std::vector<SplinePatch> patches = build_patches(file, surfaces, mesh.positions, reader.weights);
  if (patches.empty()) {
    if (surfaces.curve_line > 0 && mesh.face_count() == 0)
      fail_line(file, surfaces.curve_line,
                "a curve, and the file has no surface; expected surf, f or, for slices, l");
    return;
  }
  keep_points_of_faces(mesh);
  add_patches(file, patches, mesh);
  mesh.is_made = true;
  mesh.surfaces = patches.size();
  if (surfaces.trimmed > 0)
    mesh.warnings.push_back(
        {{file, surfaces.trimmed_line, 0},
         fmt::format("{} of {} surfaces {} 'trim' or 'hole': taken whole, with what these cut away",
                     surfaces.trimmed, patches.size(), surfaces.trimmed == 1 ? "has" : "have"),
         "",
         true});
}

void add_slices(ObjReader& reader) {
  Polygons& mesh = reader.mesh;
  std::vector<std::vector<std::uint32_t>> lines;
  std::uint32_t begin = 0;
  for (std::size_t i = 0; i < reader.ends.size(); ++i) {
    lines.emplace_back(reader.corners.begin() + begin, reader.corners.begin() + reader.ends[i]);
    begin = reader.ends[i];
    for (const std::uint32_t corner : lines.back())
      if (corner >= mesh.positions.size())
        fail_line(reader.lines.file, static_cast<int>(reader.l_lines[i]),
                  fmt::format("a line names point {}; expected numbers from 1 to {}", corner + 1,
                              mesh.positions.size()));
  }
  std::vector<Slice> slices;
  for (const std::vector<std::uint32_t>& chain : chain_lines(lines)) {
    Slice& slice = slices.emplace_back();
    for (const std::uint32_t point : chain) slice.push_back(mesh.positions[point]);
  }
  fill_slices(slices, mesh);
}

}  // namespace

Polygons read_obj(const std::string& file, std::string_view bytes) {
  ObjReader reader;
  reader.lines = {file, bytes, {}, 0};
  reader.now.file = file;
  while (read_statement(reader)) {
    const std::string_view word = reader.now.words.front();
    reader.now.point_count = reader.mesh.positions.size();
    if (word == "v") {
      read_point(reader);
    } else if (word == "f") {
      read_face(reader);
    } else if (word == "l") {
      read_polyline(reader);
    } else if (word == "vn" && reader.mesh.face_count() == 0) {
      read_normal(reader);
    } else if (std::ranges::find(kPassed, word) == kPassed.end() &&
               !read_surface_statement(reader.now, reader.surfaces)) {
      // What is no OBJ at all is none of this message's business.
      if (reader.mesh.positions.empty())
        fail_line(file, reader.now.line, "no word of an OBJ file; expected v, f or another one");
      fail_line(
          file, reader.now.line,
          fmt::format("unknown word '{}'; expected v, f or another word of an OBJ file", show_found(word)));
    }
  }
  check_indices(reader);
  add_surfaces(reader);
  if (reader.mesh.face_count() == 0 && !reader.ends.empty()) add_slices(reader);
  return std::move(reader.mesh);
}

}  // namespace mien

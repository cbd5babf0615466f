#include "scene/wavefront.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/text.hpp"

namespace mien {

namespace {

constexpr int kPositionDecimals = 4;
constexpr int kNormalDecimals = 5;  // an angle of a thousandth of a degree

void append_vector(std::string& text, const char* keyword, const glm::vec3& v, int decimals) {
  text += keyword;
  for (int i = 0; i < 3; ++i) {
    text += ' ';
    append_number(text, v[i], decimals);
  }
  text += '\n';
}

// The part as it stands in the drawing.
PartShape place_part(const Part& part, const PartShape& shape) {
  if (!part.is_rigid) return shape;
  PartShape placed;
  const glm::mat3 turn(shape.world_from_rest);
  for (const glm::vec3& p : part.rest.positions)
    placed.positions.emplace_back(shape.world_from_rest * glm::vec4(p, 1));
  for (const glm::vec3& n : part.rest.normals) placed.normals.push_back(turn * n);
  return placed;
}

// `first_vertex` and `first_normal` are the numbers of the part's own first ones; OBJ counts from 1 through
// the file.
void append_faces(std::string& text, const Part& part, bool has_normals, std::size_t first_vertex,
                  std::size_t first_normal) {
  for (const Triangle& t : part.rest.triangles) {
    text += 'f';
    for (const std::uint32_t v : t) {
      text += fmt::format(" {}", v + first_vertex);
      if (has_normals) text += fmt::format("//{}", v + first_normal);
    }
    text += '\n';
  }
}

}  // namespace

void append_wavefront(std::string& text, const Model& model, const Drawing& drawing,
                      const std::string& title) {
  if (drawing.parts.size() != model.parts.size())
    throw RunError(fmt::format("internal: a drawing of {} parts for a model of {}", drawing.parts.size(),
                               model.parts.size()));
  std::string line = title;
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < ' ' || c == 127 || c == '\\'; }, ' ');
  text += fmt::format("# {}\n# millimetres; x to the character's left, y up, z forward\n", line);
  std::size_t first_vertex = 1, first_normal = 1;
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const Part& part = model.parts[i];
    const PartShape placed = place_part(part, drawing.parts[i]);
    const bool has_normals = placed.normals.size() == placed.positions.size();
    text += fmt::format("o {0}\ng {0}\n", part.name);
    for (const glm::vec3& p : placed.positions) append_vector(text, "v", p, kPositionDecimals);
    if (has_normals)
      for (const glm::vec3& n : placed.normals) append_vector(text, "vn", n, kNormalDecimals);
    append_faces(text, part, has_normals, first_vertex, first_normal);
    first_vertex += placed.positions.size();
    if (has_normals) first_normal += placed.normals.size();
  }
}

}  // namespace mien

#include "scene/wavefront.hpp"

#include <fmt/format.h>

#include "core/text.hpp"
#include "scene/mesh_files.hpp"
#include "scene/title.hpp"

namespace mien {

namespace {

constexpr int kPositionDecimals = 4;
constexpr int kNormalDecimals = 5;  // an angle of a thousandth of a degree

template <typename Vector>
void append_vector(std::string& text, const char* keyword, const Vector& v, int decimals) {
  text += keyword;
  for (int i = 0; i < 3; ++i) {
    text += ' ';
    append_number(text, v[i], decimals);
  }
  text += '\n';
}

// `first_vertex` is the number of the part's own first one; OBJ counts from 1 through the file. Every vertex
// has one normal, of the same number.
void append_faces(std::string& text, const Part& part, std::size_t first_vertex) {
  for (const Triangle& t : part.rest.triangles) {
    text += 'f';
    for (const std::uint32_t v : t) text += fmt::format(" {0}//{0}", v + first_vertex);
    text += '\n';
  }
}

}  // namespace

void append_wavefront(std::string& text, const Model& model, const Drawing& drawing,
                      const std::string& title) {
  check_drawing(model, drawing);
  text +=
      fmt::format("# {}\n# millimetres; x to the character's left, y up, z forward\n", clean_title(title));
  std::size_t first_vertex = 1;
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const Part& part = model.parts[i];
    const Mesh placed = place_part(part, drawing.parts[i]);
    text += fmt::format("o {0}\ng {0}\n", part.name);
    for (const glm::vec3& p : placed.positions) append_vector(text, "v", p, kPositionDecimals);
    for (const glm::vec3& n : placed.normals) append_vector(text, "vn", n, kNormalDecimals);
    append_faces(text, part, first_vertex);
    first_vertex += placed.positions.size();
  }
}

void append_wavefront(std::string& text, const std::vector<glm::dvec3>& positions,
                      const std::vector<Quad>& quads, const std::string& name,
                      const std::vector<std::string>& comment) {
  for (const std::string& line : comment) text += "# " + line + "\n";
  text += "o " + name + "\n";
  for (const glm::dvec3& p : positions) append_vector(text, "v", p, kPositionDecimals);
  for (const auto& [a, b, c, d] : quads) text += fmt::format("f {} {} {} {}\n", a + 1, b + 1, c + 1, d + 1);
}

}  // namespace mien

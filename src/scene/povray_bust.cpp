#include "scene/povray_bust.hpp"

#include <fmt/format.h>

#include "core/text.hpp"

namespace mien {

std::string build_plaster_scene(const Mesh& mesh, double aspect, const Templates& templates) {
  constexpr int kDecimals = 4;
  std::string vertices, faces;
  for (const glm::vec3& p : mesh.positions) {
    vertices += vertices.empty() ? "<" : ",\n<";
    append_number(vertices, p.x, kDecimals);
    vertices += ',';
    append_number(vertices, p.y, kDecimals);
    vertices += ',';
    append_number(vertices, p.z, kDecimals);
    vertices += '>';
  }
  for (const Triangle& t : mesh.triangles)
    faces += fmt::format("{}<{},{},{}>", faces.empty() ? "" : ",\n", t[0], t[1], t[2]);
  const Box box = compute_bounds(mesh.positions);
  return fill_template(templates, "povray/bust.pov",
                       {{"height_mm", format_number(box.high.z, 3)},
                        {"width_mm", format_number(box.high.x - box.low.x, 3)},
                        {"aspect", format_number(aspect, 5)},
                        {"vertex_count", fmt::format("{}", mesh.positions.size())},
                        {"vertices", vertices},
                        {"face_count", fmt::format("{}", mesh.triangles.size())},
                        {"faces", faces}});
}

}  // namespace mien

// A figure as a browser's graphics are given it: vertices with the colours of POV-Ray's materials, places in
// sixteen bits.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/model.hpp"
#include "sketch/look.hpp"

namespace mien {

// What the surface of a part does with light; of a part of several materials that of the first.
struct ViewFinish {
  float diffuse = 0, brilliance = 1, specular = 0, roughness = 0.05f, phong = 0, phong_size = 40,
        metallic = 0, reflection = 0;
  glm::vec3 emission{0};
};

// One part. Where a border of colours is sharp a vertex of the model is several here, one a colour.
struct ViewPart {
  std::string name, material;
  std::vector<std::uint32_t> vertices;  // of the model, one for each of these
  std::vector<Triangle> triangles;      // of these
  std::vector<Triangle> pieces;         // of a part of many loose pieces some of them, for quick drawings
  std::vector<glm::u8vec4> colours;     // linear, as square roots; the fourth is how much comes through
  ViewFinish finish;
  bool is_clear = false;  // lets light through: drawn last
  bool is_seen = true;    // false: only its shadow is
  bool has_shadow = true;
  bool is_rigid = false;    // and never bends
  Mesh unbent;              // of one that may bend: where it lies at rest
  bool is_outline = false;  // changes its triangles with each drawing; no vertices here
};

struct ViewModel {
  std::vector<ViewPart> parts;  // those of the model that are seen or cast a shadow, in its order
  std::vector<std::size_t> of;  // the model's part that each is
};

// `look` is the model's on some stage.
ViewModel build_view_model(const Model& model, const SketchLook& look);

// How many millimetres a step of sixteen bits is: 0.02 mm is less than a tenth of what a screen shows.
inline constexpr float kViewStep_mm = 1.0f / 48;

// A part of a drawing, appended: of a rigid one the 16 numbers of its transform, column after column; of
// another its vertices' places in steps (x, y, z and 0; 16 bits each), then their normals (x, y, z and 0; 8
// bits each, 127 is 1), and of an outline then its triangles, three 32-bit numbers each. Little-endian. What
// lies further off than 32767 steps is put there.
void append_shape(std::string& bytes, const ViewPart& part, const PartShape& shape);

// What of a part never changes, appended: colours (4 bytes a vertex; one of an outline), triangles and pieces
// (three 32-bit numbers each), and of a rigid part its vertices at rest as those of a drawing.
void append_model(std::string& bytes, const ViewPart& part, const Mesh& rest);

}  // namespace mien

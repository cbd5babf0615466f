// What a line drawing shows: surfaces that hide what lies behind them, and lines in space.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/mesh.hpp"

namespace mien {

// What a line is drawn with; how thick and in which colour is the page's affair (wire/drawing.hpp).
enum class Pen {
  mesh,     // the net on a surface
  hair,     // a hair, a pupil's hatching
  crease,   // where a surface is sharp
  border,   // where it ends
  contour,  // where it turns away
  guide,    // Loomis' lines
  limit,    // of an area
  rest      // what is beside the head: units, levels
};
inline constexpr std::size_t kPenCount = 8;

struct WireLine {
  std::vector<glm::vec3> points;  // mm, at least two
  Pen pen = Pen::mesh;
  bool is_before_all = false;  // nothing hides it
};

// Counter-clockwise seen from outside, as all meshes are. It may be open.
struct WireSolid {
  std::vector<glm::vec3> positions;  // mm
  std::vector<Triangle> triangles;
  bool has_contour = true;  // its contours and borders are drawn
  double sharp_deg = 180;   // an edge that bends by more is drawn
};

struct WireModel {
  std::vector<WireSolid> solids;
  std::vector<WireLine> lines;
};

}  // namespace mien

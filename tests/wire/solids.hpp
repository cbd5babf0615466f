// Solids whose lines can be told by hand.
#pragma once

#include "wire/drawing.hpp"

namespace mien {

// From (-10, -10, -10) to (10, 10, 10); its twelve edges are lines.
inline WireModel build_cube() {
  WireSolid solid;
  for (int i = 0; i < 8; ++i)
    solid.positions.emplace_back(i & 1 ? 10 : -10, i & 2 ? 10 : -10, i & 4 ? 10 : -10);
  for (const Quad& q : {Quad{4, 5, 7, 6}, Quad{1, 0, 2, 3}, Quad{5, 1, 3, 7}, Quad{0, 4, 6, 2},
                        Quad{6, 7, 3, 2}, Quad{0, 1, 5, 4}}) {
    solid.triangles.push_back({q[0], q[1], q[2]});
    solid.triangles.push_back({q[0], q[2], q[3]});
  }
  solid.has_contour = false;
  WireModel model{{solid}, {}};
  for (std::uint32_t a = 0; a < 8; ++a)
    for (const std::uint32_t bit : {1U, 2U, 4U})
      if (!(a & bit)) model.lines.push_back({{solid.positions[a], solid.positions[a | bit]}});
  return model;
}

// A ball of 20 mm about 0, in `rings` rings of twice as many.
inline WireSolid build_ball(int rings) {
  WireSolid ball;
  const int around = 2 * rings;
  for (int r = 0; r <= rings; ++r)
    for (int k = 0; k < around; ++k) {
      const double up = 3.14159265358979 * r / rings, turn = 2 * 3.14159265358979 * k / around;
      ball.positions.emplace_back(20 * std::sin(up) * std::cos(turn), 20 * std::cos(up),
                                  -20 * std::sin(up) * std::sin(turn));
    }
  // All points of a pole are one.
  const auto at = [&](int r, int k) {
    return static_cast<std::uint32_t>(r * around + (r == 0 || r == rings ? 0 : k % around));
  };
  for (int r = 0; r < rings; ++r)
    for (int k = 0; k < around; ++k) {
      if (r + 1 < rings) ball.triangles.push_back({at(r, k), at(r + 1, k), at(r + 1, k + 1)});
      if (r > 0) ball.triangles.push_back({at(r, k), at(r + 1, k + 1), at(r, k + 1)});
    }
  return ball;
}

// A camera without perspective; 10 pixels are a millimetre.
inline WireCamera build_flat_camera(double angle_deg, double height_deg) {
  CameraView view;
  view.is_orthographic = true;
  view.angle_deg = angle_deg;
  view.height_deg = height_deg;
  view.look_at = glm::vec3(0);
  view.frame_width_mm = view.frame_height_mm = 60;
  return build_wire_camera(view, {600, 600});
}

inline double measure_px(const Paper& paper) {
  double sum = 0;
  for (const PaperStroke& stroke : paper.strokes)
    for (std::size_t i = 0; i + 1 < stroke.points_px.size(); ++i)
      sum += glm::distance(stroke.points_px[i], stroke.points_px[i + 1]);
  return sum;
}

}  // namespace mien

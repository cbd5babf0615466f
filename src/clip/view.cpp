#include "clip/view.hpp"

#include <algorithm>
#include <cmath>

#include "core/conventions.hpp"
#include "head/landmarks.hpp"

namespace mien {

namespace {

// Around the head, as shares of its height from chin to crown: air above, the neck below, ears and air at the
// sides.
constexpr double kLeastAbove =
    0.065;  // the same over high hair, which comes nearer to the camera than the crown
constexpr double kAbove = 0.10, kBelow = 0.25, kWide = 1.08;
constexpr double kAside = 1.08;    // from one side of the head to the other, with the least air at the sides
constexpr double kNeckEnd = 0.08;  // above its lowest place the neck is still whole

// The picture's own x.
glm::dvec3 compute_right(const CameraView& view) {
  const double angle = view.angle_deg * kRadiansPerDegree;
  return {std::cos(angle), 0, -std::sin(angle)};
}

// How far the points reach to the left (below 0) and to the right of the picture's middle, mm in the plane of
// the middle: what is nearer to the camera counts for more.
glm::dvec2 compute_reach(const std::vector<glm::vec3>& points, const CameraView& view) {
  const glm::dvec3 right = compute_right(view);
  const double height = view.height_deg * kRadiansPerDegree;
  const glm::dvec3 level = glm::cross(right, glm::dvec3(0, 1, 0));  // toward the camera, were it level
  const glm::dvec3 toward = level * std::cos(height) + glm::dvec3(0, std::sin(height), 0);
  const double distance_mm = compute_camera_distance_mm(view);
  glm::dvec2 reach(0);
  for (const glm::vec3& point : points) {
    const glm::dvec3 p = glm::dvec3(point) - glm::dvec3(view.look_at);
    const double nearness = distance_mm / (distance_mm - glm::dot(p, toward));
    const double x = glm::dot(p, right) * nearness;
    reach = {std::min(reach.x, x), std::max(reach.y, x)};
  }
  return reach;
}

struct NeckAndCrown {
  double crown = 0, top = 0, chin = 0,
         floor = 0;  // mm; the top is the hair's; down to the floor the neck is whole
};

NeckAndCrown measure_ends(const Figure& figure) {
  const NeutralHead& head = figure.head;
  const Box skin = compute_bounds(head.skin.positions);
  const double crown = skin.high.y;
  const double chin = head.skin.positions[head.cage.index.find("m12_D1")->second].y;
  double top = crown;
  for (const Part& part : figure.model.parts)
    if (part.name.starts_with("hair"))
      top = std::max<double>(top, compute_bounds(part.rest.positions).high.y);
  // Air for a drawn head that stretches; 0 of a real one.
  top += compute_most_stretch(figure.redraw) * (top - figure.redraw.floor_mm);
  return {crown, top, chin, skin.low.y + (crown - chin) * kNeckEnd};
}

// What the picture holds from top to bottom at distance 1.
double compute_tall_mm(const CameraView& view, const RenderSpec& render) {
  return std::max(view.frame_height_mm, view.frame_width_mm * render.height_px / render.width_px);
}

}  // namespace

void add_figure(const Figure& figure, const glm::dmat4& world_from_figure, Framing& framing) {
  add_growing_figure({&figure}, world_from_figure, framing);
}

void add_growing_figure(const std::vector<const Figure*>& figures, const glm::dmat4& world_from_figure,
                        Framing& framing) {
  const bool is_first = framing.points.empty();
  const glm::mat4 world(world_from_figure);
  NeckAndCrown all = measure_ends(*figures.front());
  for (const Figure* figure : figures) {
    const NeckAndCrown ends = measure_ends(*figure);
    all.crown = std::max(all.crown, ends.crown);
    all.top = std::max(all.top, ends.top);
    all.chin = std::min(all.chin, ends.chin);
    all.floor = std::min(all.floor, ends.floor);
    for (const Part& part : figure->model.parts)
      for (const glm::vec3& vertex : part.rest.positions)
        if (vertex.y >= ends.chin) framing.points.emplace_back(world * glm::vec4(vertex, 1));
  }
  const double rise_mm = world_from_figure[3].y;
  framing.crown_mm = is_first ? all.crown + rise_mm : std::max(framing.crown_mm, all.crown + rise_mm);
  framing.top_mm = is_first ? all.top + rise_mm : std::max(framing.top_mm, all.top + rise_mm);
  framing.chin_mm = is_first ? all.chin + rise_mm : std::min(framing.chin_mm, all.chin + rise_mm);
  framing.floor_mm = is_first ? all.floor + rise_mm : std::max(framing.floor_mm, all.floor + rise_mm);
}

double compute_lowering_mm(const Figure& figure, const glm::dmat4& world_from_figure, const Framing& framing,
                           const RenderSpec& render) {
  const CameraView view = compute_view(framing, {}, render);
  const double bottom_mm = view.look_at.y - compute_tall_mm(view, render) / 2;
  return std::min(0.0, bottom_mm - (measure_ends(figure).floor + world_from_figure[3].y));
}

glm::dvec3 compute_resting_place(const NeutralHead& head, const std::string& name) {
  const bool is_left = name.ends_with("_l"), is_right = name.ends_with("_r");
  const std::string bare = is_left || is_right ? name.substr(0, name.size() - 2) : name;
  const SkinSpot spot = find_place(head, bare);
  glm::dvec3 place{0};
  for (std::size_t i = 0; i < spot.vertices.size(); ++i)
    place += spot.shares[i] * glm::dvec3(head.skin.positions[spot.vertices[i]]);
  if (!is_left) place.x = is_right ? -place.x : 0;
  return place;
}

CameraView compute_view(const Framing& framing, const CameraKey& camera, const StageMoment& stage,
                        const RenderSpec& render) {
  CameraKey seen = camera;
  seen.lens_mm = stage.lens_mm;
  CameraView view = compute_view(framing, seen, render);
  glm::dvec3 look_at{0};
  bool is_shifted = false;
  for (const AimShare& share : stage.aims) {
    const Aim& aim = share.aim;
    is_shifted = is_shifted || aim.kind != Aim::Kind::frame;
    glm::dvec3 place = view.look_at;
    if (aim.kind == Aim::Kind::point) place = aim.point_mm;
    if (aim.kind == Aim::Kind::landmark) place = framing.places.at({aim.actor, aim.landmark});
    look_at += share.share * place;
  }
  if (is_shifted) view.look_at = glm::vec3(look_at);
  return view;
}

CameraView compute_view(const Framing& framing, const CameraKey& camera, const RenderSpec& render) {
  const double crown = framing.crown_mm, height = crown - framing.chin_mm;
  CameraView view;
  view.angle_deg = camera.angle_deg;
  view.height_deg = camera.height_deg;
  view.distance = camera.distance;
  view.lens_mm = camera.lens_mm;
  const double above_mm = std::max(height * kAbove, framing.top_mm - crown + height * kLeastAbove);
  view.frame_height_mm = height * (1 + kBelow) + above_mm;
  view.look_at = glm::vec3(0, crown + above_mm - view.frame_height_mm / 2, 0);

  const glm::dvec3 right = compute_right(view);
  const glm::dvec2 reach = compute_reach(framing.points, view);
  view.look_at += glm::vec3(right * ((reach.x + reach.y) / 2));
  view.frame_width_mm = std::max(height * kWide, (reach.y - reach.x) * kAside);

  // A frame that grew to be wide enough would show where the neck ends.
  view.look_at.y = static_cast<float>(
      std::max<double>(view.look_at.y, framing.floor_mm + compute_tall_mm(view, render) / 2));
  return view;
}

glm::dvec3 find_direction(double angle_deg, double up_deg) {
  const double aside = angle_deg * kRadiansPerDegree, up = up_deg * kRadiansPerDegree;
  return {std::sin(aside) * std::cos(up), std::sin(up), std::cos(aside) * std::cos(up)};
}

glm::dvec3 find_own_lamp(const CameraView& view, double angle_deg) {
  constexpr double kAside_deg = 38, kUp_deg = 37;
  return find_direction(
      view.angle_deg - kAside_deg * std::cos(view.angle_deg * kRadiansPerDegree) + angle_deg, kUp_deg);
}

InkView compute_ink_view(const CameraView& view, const RenderSpec& render,
                         const std::optional<InkLamp>& lamp) {
  constexpr double kLine = 0.0029;  // of the picture's height
  InkView ink;
  ink.camera_mm = glm::dvec3(view.look_at) + compute_camera_distance_mm(view) * view.distance *
                                                 find_direction(view.angle_deg, view.height_deg);
  ink.to_light = lamp ? lamp->to_light : find_own_lamp(view, 0);
  ink.line_mm = render.line * kLine * compute_tall_mm(view, render) * view.distance;
  return ink;
}

EyeRig compute_eyes(const Figure& figure, const glm::dmat4& world_from_figure, const Framing& framing,
                    const RenderSpec& render) {
  EyeRig rig;
  rig.left_mm = figure.head.eye.centre;
  rig.pivot_mm = figure.face.turn_pivot;
  const auto compute_reach = [&](Side side) {
    const std::size_t across = *find_move(Area::eye, side, "side"), up = *find_move(Area::eye, side, "up");
    const Face& face = figure.face;
    return EyeReach{figure.limits.plus[across] * face.eye_side_rad / kRadiansPerDegree,
                    figure.limits.minus[across] * face.eye_side_rad / kRadiansPerDegree,
                    figure.limits.plus[up] * face.eye_up_rad / kRadiansPerDegree,
                    figure.limits.minus[up] * face.eye_down_rad / kRadiansPerDegree};
  };
  rig.left = compute_reach(Side::left);
  rig.right = compute_reach(Side::right);
  const CameraView view = compute_view(framing, {}, render);
  rig.camera_target_mm = glm::dvec3(glm::inverse(world_from_figure) * glm::dvec4(view.look_at, 1));
  rig.camera_mm = compute_camera_distance_mm(view);
  return rig;
}

EyeRig compute_eyes(const Figure& figure, const RenderSpec& render) {
  Framing framing;
  add_figure(figure, glm::dmat4(1), framing);
  return compute_eyes(figure, glm::dmat4(1), framing, render);
}

CameraView compute_view(const Figure& figure, const CameraKey& camera, const RenderSpec& render) {
  Framing framing;
  add_figure(figure, glm::dmat4(1), framing);
  return compute_view(framing, camera, render);
}

}  // namespace mien

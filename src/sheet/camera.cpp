#include "sheet/camera.hpp"

#include <algorithm>
#include <cmath>

#include "core/conventions.hpp"
#include "head/landmarks.hpp"
#include "head/shapes.hpp"

namespace mien {

namespace {

// Around a whole head, as shares of its height: air above; below, enough of the neck to carry it.
constexpr double kAbove = 0.12, kBelow = 0.22;
constexpr double kLeastAbove = 0.02;  // over hair

// Loomis' numbers, in units of which a head is 3.5 high.
constexpr double kUnitsHigh = 3.5, kUnitsWide = 3, kUnitsDeep = 3.5;
constexpr double kNotch = 0.06;   // half of a notch's length, in units
constexpr double kAcross = 0.05;  // sine of how far a view may be off the front or the side

// Shares of the frame's height, so that a line is as thick on every head: about 1.5 and 1 pixel of 500.
constexpr double kGuideRadius = 0.0014, kFrameRadius = 0.0012;
constexpr double kLift_mm = 0.3;      // off the skin, whose triangles are flat and whose normals are not
constexpr double kWordsSize = 0.026;  // of the frame's height: the mouth's and the nose's names do not touch
constexpr double kWordsInset = 0.02, kWordsLift = 0.007;
constexpr glm::vec3 kGuideInk{0.72f, 0.15f, 0.10f};  // the red pencil
constexpr glm::vec3 kFrameInk{0.36f, 0.42f, 0.50f};  // the blue one

// Where the plane dot(normal, p) = offset cuts the skin, above `lowest_mm`, lifted off it.
void append_contour(const Mesh& skin, const glm::vec3& normal, float offset, double lowest_mm,
                    OverlayLine& line) {
  const auto find_crossing = [&](std::uint32_t a, std::uint32_t b, float at_a, float at_b) {
    const float t = at_a / (at_a - at_b);
    const glm::vec3 lift = glm::mix(skin.normals[a], skin.normals[b], t);
    return glm::mix(skin.positions[a], skin.positions[b], t) +
           static_cast<float>(kLift_mm) * (lift - glm::dot(lift, normal) * normal);
  };
  for (const Triangle& triangle : skin.triangles) {
    std::array<glm::vec3, 2> ends{};
    int count = 0;
    for (int i = 0; i < 3 && count < 2; ++i) {
      const std::uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
      const float at_a = glm::dot(normal, skin.positions[a]) - offset;
      const float at_b = glm::dot(normal, skin.positions[b]) - offset;
      if ((at_a < 0) != (at_b < 0)) ends[count++] = find_crossing(a, b, at_a, at_b);
    }
    if (count == 2 && std::min(ends[0].y, ends[1].y) >= lowest_mm) line.segments.push_back(ends);
  }
}

// The frame around the head as it stands in the picture's plane, behind the head: a front's width or a side's
// depth, with a notch at each unit. None where the camera looks across a corner of the block.
OverlayLine build_frame(const HeadMeasures& head, const glm::vec3& right, const glm::vec3& middle,
                        double radius_mm) {
  OverlayLine frame{{}, {}, radius_mm, kFrameInk};
  const double along_x = std::abs(right.x), along_z = std::abs(right.z);
  if (std::min(along_x, along_z) > kAcross) return frame;
  const double unit_mm = head.height_mm() / kUnitsHigh;
  const double wide = along_x > along_z ? kUnitsWide : kUnitsDeep;
  const auto find_place = [&](double x, double y) {  // units from the frame's lower middle
    glm::vec3 place = middle + right * static_cast<float>(x * unit_mm);
    place.y = static_cast<float>(head.chin_mm() + y * unit_mm);
    return place;
  };
  const auto add = [&](double x, double y, double to_x, double to_y) {
    frame.segments.push_back({find_place(x, y), find_place(to_x, to_y)});
  };
  for (const double side : {-wide / 2, wide / 2}) {
    add(side, 0, side, kUnitsHigh);
    for (double y = 0; y <= kUnitsHigh; y += 1) add(side - kNotch, y, side + kNotch, y);
  }
  for (const double y : {0.0, kUnitsHigh}) {
    add(-wide / 2, y, wide / 2, y);
    for (double x = -wide / 2; x <= wide / 2; x += 1) add(x, y - kNotch, x, y + kNotch);
  }
  return frame;
}

// Of those names that the head has.
std::vector<glm::dvec3> find_places(const HeadMeasures& head, const std::vector<std::string>& names) {
  std::vector<glm::dvec3> places;
  for (const std::string& name : names)
    if (const auto found = head.landmarks.find(name); found != head.landmarks.end())
      places.push_back(found->second);
  return places;
}

}  // namespace

glm::vec3 compute_toward_camera(const CameraView& view) {
  const double angle = view.angle_deg * kRadiansPerDegree;
  return {std::sin(angle), 0, std::cos(angle)};
}

FigurePlaces build_places(const Figure& figure) {
  const auto landmarks = find_landmarks(figure.head);
  return [&figure, landmarks](const Pose& pose) {
    DeformBuffers buffers;
    Drawing drawing;
    deform_figure(figure, pose, TurnKey{}, buffers, drawing);
    PlacesOfPose places = measure_landmarks(figure.head, landmarks, figure.model, drawing);
    const Cage& cage = figure.head.cage;
    for (std::size_t i = 0; i < cage.names.size(); ++i)
      places.emplace(cage.names[i], drawing.parts.front().positions[i]);
    return places;
  };
}

HeadMeasures measure_head(const Figure& figure) {
  HeadMeasures measures;
  measures.landmarks = build_places(figure)(Pose{});
  measures.limits = measure_limits(figure.head, figure.face, figure.limits);
  measures.guides = measure_guide_heights(figure.head);
  std::vector<glm::vec3> above;
  for (const glm::vec3& p : figure.head.skin.positions)
    if (p.y >= measures.chin_mm()) above.push_back(p);
  measures.head = compute_bounds(above);
  double top_mm = measures.guides.back().second;
  for (const Part& part : figure.model.parts)
    if (part.name.starts_with("hair"))
      top_mm = std::max<double>(top_mm, compute_bounds(part.rest.positions).high.y);
  const double stretch = compute_most_stretch(figure.redraw);
  if (stretch > 0)
    measures.above_mm = top_mm + stretch * (top_mm - figure.redraw.floor_mm) - measures.guides.back().second;
  return measures;
}

CameraView compute_cell_view(const SheetCell& cell, const HeadMeasures& own, const HeadMeasures& scale) {
  CameraView view;
  view.is_orthographic = true;
  view.angle_deg = cell.angle_deg;
  view.height_deg = cell.height_deg;
  const SheetFraming& framing = cell.framing;
  const std::vector<glm::dvec3> around = find_places(scale, framing.around);
  const double top_mm = own.guides.back().second + own.above_mm + kLeastAbove * scale.height_mm();
  if (around.empty()) {
    view.frame_height_mm = scale.height_mm() * (1 + kAbove + kBelow);
    view.frame_width_mm = scale.height_mm() * framing.wide;
    view.look_at = (own.head.low + own.head.high) / 2.0f;
    const double low_mm = own.chin_mm() - kBelow * scale.height_mm();
    view.look_at.y =
        static_cast<float>(std::max(low_mm + view.frame_height_mm / 2, top_mm - view.frame_height_mm / 2));
    return view;
  }
  glm::dvec3 sum{0};
  double longest_mm = 0;
  for (const glm::dvec3& place : around) {
    sum += place;
    for (const glm::dvec3& other : around) longest_mm = std::max(longest_mm, glm::distance(place, other));
  }
  view.look_at = glm::vec3(sum / static_cast<double>(around.size()));
  view.frame_height_mm = framing.spread * longest_mm + framing.margin * scale.height_mm();
  view.frame_width_mm = view.frame_height_mm;
  if (framing.has_crown && own.above_mm > 0)
    view.frame_height_mm = std::max(view.frame_height_mm, 2 * (top_mm - view.look_at.y));
  return view;
}

double compute_line_radius_mm(double share, double tall_mm, int height_px) {
  constexpr double kThinnest_px = 1.2;  // thinner lines break up between the pixels
  return std::max(share * tall_mm, kThinnest_px / 2 * tall_mm / height_px);
}

Overlay build_guides(const HeadMeasures& head, const Mesh& skin, const CameraView& view,
                     std::pair<int, int> size_px, bool has_frame) {
  const double aspect = static_cast<double>(size_px.first) / size_px.second;
  const double tall_mm = std::max(view.frame_height_mm, view.frame_width_mm / aspect);
  const double half_width_mm = tall_mm * aspect / 2;
  const glm::vec3 toward = compute_toward_camera(view);
  const glm::vec3 right(toward.z, 0, -toward.x);
  const glm::vec3 away = toward * static_cast<float>(head.height_mm());  // before all of the head, or behind
  const glm::vec3 reach = right * static_cast<float>(half_width_mm * 1.1);

  OverlayLine guides{{}, {}, compute_line_radius_mm(kGuideRadius, tall_mm, size_px.second), kGuideInk};
  Overlay overlay;
  for (const auto& [name, y_mm] : head.guides) {
    const glm::vec3 middle(view.look_at.x, y_mm, view.look_at.z);
    guides.segments.push_back({middle - away - reach, middle - away + reach});
    if (name != "chin" && name != "crown")  // there the plane touches the head at its edge only
      append_contour(skin, {0, 1, 0}, static_cast<float>(y_mm), y_mm - 1, guides);
    glm::vec3 at = middle + away - right * static_cast<float>(half_width_mm - tall_mm * kWordsInset);
    at.y += static_cast<float>(tall_mm * kWordsLift);
    overlay.words.push_back({build_caption(name), at, tall_mm * kWordsSize, kGuideInk, 0});
  }
  append_contour(skin, {1, 0, 0}, 0, head.chin_mm(), guides);
  if (has_frame)
    overlay.lines.push_back(build_frame(head, right, view.look_at - away,
                                        compute_line_radius_mm(kFrameRadius, tall_mm, size_px.second)));
  overlay.lines.push_back(std::move(guides));
  return overlay;
}

}  // namespace mien

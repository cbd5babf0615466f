#include "head/shapes.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "head/cage.hpp"

namespace mien {

namespace {

// Where x changes over from the features' factor to the skull's, mm on the adult.
constexpr double kFeatures_mm = 20, kSkull_mm = 62;

// Heights of the guide lines on the adult, mm (chin and crown bound them all).
constexpr double kAdultChin_mm = -114.6, kAdultCrown_mm = 113.7;
struct GuideLine {
  const char* name;
  double adult_y_mm;
};
constexpr std::array kGuideLines{GuideLine{"mouth_line", -70.3}, GuideLine{"nose_base", -48.0},
                                 GuideLine{"eye_line", 0.0}, GuideLine{"brow_line", 16.5},
                                 GuideLine{"hairline", 81.0}};

// The cage and the eye of one head, as they are summed and mixed.
struct Shape {
  std::vector<glm::dvec3> points;
  Eye eye;
};

glm::dvec3 warp_point(const Warp& warp, const glm::dvec3& p) {
  const double t = glm::smoothstep(kFeatures_mm, kSkull_mm, std::abs(p.x));
  const double x = glm::mix(sample_curve(warp.inner, p.y), sample_curve(warp.outer, p.y), t);
  // The two depths meet with no kink at the ear canals.
  const double front = glm::smoothstep(-10.0, 10.0, p.z);
  const double z = glm::mix(sample_curve(warp.back, p.y), sample_curve(warp.front, p.y), front);
  return {p.x * x, sample_curve(warp.height, p.y, true), p.z * z};
}

// How far a point of the eye's rings follows the ball as a similarity, so that lids fit it on every head.
double find_carry(const Warp& warp, std::string_view name) {
  name = strip_side(name);
  if (name.starts_with("EB_") || name.starts_with("E0_") || name.starts_with("E1_") ||
      name.starts_with("E2_"))
    return 1;
  if (name.starts_with("E3_")) return warp.carry_e3;
  if (name.starts_with("E4_")) return warp.carry_e4;
  return 0;
}

Shape apply_warp(const Cage& cage, const Eye& eye, const Warp& warp) {
  Shape shape{cage.points, eye};
  shape.eye.centre = warp_point(warp, eye.centre);
  shape.eye.radius_mm = eye.radius_mm * warp.eye;
  for (std::size_t i = 0; i < cage.points.size(); ++i) {
    const glm::dvec3 side(cage.names[i].starts_with("R:") ? -1 : 1, 1, 1);
    const glm::dvec3 carried = (shape.eye.centre + warp.eye * (cage.points[i] * side - eye.centre)) * side;
    shape.points[i] = glm::mix(warp_point(warp, cage.points[i]), carried, find_carry(warp, cage.names[i]));
  }
  return shape;
}

// What a character field leaves alone: ear, back and crown of the head, the eye opening, the neck.
std::vector<bool> find_anchors(const Cage& cage, const Handles& handles) {
  const bool moves_neck = handles.contains("m12_N1");
  std::vector<bool> anchors(cage.points.size(), false);
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    const std::string_view name = strip_side(cage.names[i]);
    const bool is_neck = name.find("_N") != name.npos;
    const bool is_upper_neck = name.ends_with("_N0") || name.ends_with("_N1") || name.ends_with("_N2");
    const bool is_side = name.size() > 1 && name[0] == 's' && name[1] >= '4';
    const bool is_eye = name.starts_with("EB") || name.starts_with("E0") || name.starts_with("E1") ||
                        name.starts_with("E2") ||
                        (name.starts_with("E3_") && std::stoi(std::string(name.substr(3))) <= 8);
    anchors[i] = name.starts_with("er") || is_side || name.starts_with("cap") || name.ends_with("_F3") ||
                 name.ends_with("_F4") || (is_neck && !(moves_neck && is_upper_neck)) || is_eye ||
                 name == "M1_6";
  }
  return anchors;
}

void add_field(const Cage& cage, const Handles& handles, double scale, std::vector<glm::dvec3>& points) {
  Cage warped = cage;
  warped.points = points;
  const Field field =
      solve_field(build_field_solver(warped), handles, find_anchors(warped, handles), Reach::both);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] += scale * field[i];
}

Shape make_variant(const HeadShapes& shapes, const std::string& name, const Cage& cage, const Eye& eye) {
  Shape shape{cage.points, eye};
  const auto warp = shapes.warps.find(name);
  if (warp != shapes.warps.end()) shape = apply_warp(cage, eye, warp->second);
  const auto field = shapes.fields.find(name);
  if (field != shapes.fields.end()) add_field(cage, field->second, 1, shape.points);
  return shape;
}

void add_shape(Shape& sum, const Shape& addition, double weight) {
  for (std::size_t i = 0; i < sum.points.size(); ++i) sum.points[i] += weight * addition.points[i];
  sum.eye.centre += weight * addition.eye.centre;
  sum.eye.radius_mm += weight * addition.eye.radius_mm;
}

// Which warps and fields a mix of names comes to: {child: 0.5, adult: 0.5} of ages, say.
Mix flatten_mix(const std::map<std::string, Mix>& known, const Mix& mix) {
  Mix flat;
  for (const auto& [name, weight] : mix) {
    const auto found = known.find(name);
    if (found == known.end())
      throw RunError(fmt::format("templates/head/heads.yaml does not define '{}'", name));
    for (const auto& [variant, share] : found->second) flat[variant] += weight * share;
  }
  return flat;
}

// Adds what `name` would change on the adult, at the size of the head that `shape` has become.
void add_variant(const HeadShapes& shapes, const std::string& name, double weight, double size,
                 const Cage& adult, const Eye& eye, Shape& shape) {
  if (weight == 0) return;
  const Shape variant = make_variant(shapes, name, adult, eye);
  add_shape(shape, variant, weight * size);
  add_shape(shape, {adult.points, eye}, -weight * size);
}

// Height of the chin and crown of a shape, mm, read off the cage's own points.
glm::dvec2 find_height(const Cage& adult, const Shape& shape) {
  const auto height_of = [&](std::string_view name) {
    return shape.points[adult.index.find(name)->second].y;
  };
  const double adult_chin = adult.points[adult.index.find("m12_D1")->second].y;
  const double adult_crown = adult.points[adult.index.find("cap_0_2")->second].y;
  // The cage stands off the skin by a fixed small amount at both ends: scale that with the head.
  const double scale = (height_of("cap_0_2") - height_of("m12_D1")) / (adult_crown - adult_chin);
  return {height_of("m12_D1") + scale * (kAdultChin_mm - adult_chin),
          height_of("cap_0_2") + scale * (kAdultCrown_mm - adult_crown)};
}

// Where each guide line of the adult has gone on `shape`: interpolated along the mid-plane and the eye.
std::map<std::string, double> measure_guides(const Cage& adult, const Shape& shape, const Eye& adult_eye) {
  const auto y_of = [](const Cage& cage, const std::vector<glm::dvec3>& points, std::string_view name) {
    return points[cage.index.find(name)->second].y;
  };
  std::vector<glm::dvec2> knots;
  for (const std::string_view name :
       {"m12_D1", "M6_12", "M1_12", "M6_0", "p_b1", "p_g", "p_F1", "p_F3", "p_F4"})
    knots.emplace_back(y_of(adult, adult.points, name), y_of(adult, shape.points, name));
  const MonotoneCurve curve = build_monotone_curve(std::move(knots));
  const glm::dvec2 ends = find_height(adult, shape);
  std::map<std::string, double> guides;
  for (const GuideLine& line : kGuideLines) {
    const double y = line.adult_y_mm == 0 ? shape.eye.centre.y - adult_eye.centre.y
                                          : sample_curve(curve, line.adult_y_mm, true);
    guides[line.name] = (y - ends.x) / (ends.y - ends.x);
  }
  return guides;
}

void move_guides(const Cage& adult, const Eye& adult_eye, const std::map<std::string, double>& wanted,
                 Shape& shape) {
  if (wanted.empty()) return;
  const glm::dvec2 ends = find_height(adult, shape);
  const double height = ends.y - ends.x;
  const std::map<std::string, double> now = measure_guides(adult, shape, adult_eye);
  std::vector<glm::dvec2> knots{{ends.x - height, ends.x - height}, {ends.x, ends.x}};
  for (const GuideLine& line : kGuideLines) {
    const auto moved = wanted.find(line.name);
    const double to = ends.x + height * (moved == wanted.end() ? now.at(line.name) : moved->second);
    if (to <= knots.back().y + 0.01 * height)
      throw InputError(
          fmt::format("guide line '{}' meets the one below it; expected the order mouth_line, nose_base, "
                      "eye_line, brow_line, hairline from chin to crown on this head",
                      line.name));
    knots.emplace_back(ends.x + height * now.at(line.name), to);
  }
  if (knots.back().y >= ends.y - 0.01 * height)
    throw InputError("guide line 'hairline' meets the crown; expected it below");
  knots.emplace_back(ends.y, ends.y);
  Warp warp;
  warp.height = build_monotone_curve(std::move(knots));
  warp.outer = warp.inner = warp.front = warp.back = build_monotone_curve({{-1, 1}, {1, 1}});
  Cage now_cage = adult;
  now_cage.points = shape.points;
  shape = apply_warp(now_cage, shape.eye, warp);
}

// Fuller lips part and thinner ones bare the teeth: brings the two back to the adult's contact, column by
// column, at the head's size. What one lip moves its rings share, so the borders hardly know.
void close_lips(const Cage& adult, double size, Shape& shape) {
  struct RingShare {
    const char* ring;
    double share;
  };
  constexpr std::array kRings{RingShare{"M0_", 1}, RingShare{"M1_", 1}, RingShare{"M2_", 0.8},
                              RingShare{"M3_", 0.4}};
  const auto find = [&](const std::string& name) { return adult.index.find(name)->second; };
  for (int column = 0; column < 6; ++column) {
    const std::string upper = std::to_string(column), lower = std::to_string(12 - column);
    const auto gap = [&](const std::vector<glm::dvec3>& points) {
      return points[find("M1_" + upper)].y - points[find("M1_" + lower)].y;
    };
    const double excess = gap(shape.points) - size * gap(adult.points);
    for (const RingShare& ring : kRings)
      for (const auto& [name, sign] : {std::pair{upper, -0.5}, std::pair{lower, 0.5}}) {
        const std::uint32_t point = find(ring.ring + name), image = adult.mirror[point];
        shape.points[point].y += sign * ring.share * excess;
        if (image != point) shape.points[image].y = shape.points[point].y;
      }
  }
}

Shape build_shape(const HeadShapes& shapes, const HeadSpec& spec, const Cage& adult, const Eye& eye) {
  Shape shape{std::vector<glm::dvec3>(adult.points.size(), glm::dvec3(0)), {glm::dvec3(0), 0}};
  for (const auto& [name, weight] : flatten_mix(shapes.ages, spec.age))
    add_shape(shape, make_variant(shapes, name, adult, eye), weight);
  const glm::dvec2 ends = find_height(adult, shape);
  const double size = (ends.y - ends.x) / (kAdultCrown_mm - kAdultChin_mm);
  for (const auto& [name, weight] : flatten_mix(shapes.skulls, spec.skull))
    add_variant(shapes, name, weight, size, adult, eye, shape);
  add_variant(shapes, spec.character < 0 ? "female" : "male", std::abs(spec.character), size, adult, eye,
              shape);
  Handles features;
  for (const auto& [name, value] : spec.features)
    for (const auto& [point, move] : shapes.features.at(name)) features[point] += value * size * move;
  if (!features.empty()) add_field(adult, features, 1, shape.points);
  close_lips(adult, size, shape);
  return shape;
}

}  // namespace

void shape_head(const HeadShapes& shapes, const HeadSpec& spec, Cage& cage, Eye& eye) {
  Shape shape = build_shape(shapes, spec, cage, eye);
  move_guides(cage, eye, spec.guides, shape);
  cage.points = std::move(shape.points);
  eye = shape.eye;
}

std::map<std::string, double> find_guides(const HeadShapes& shapes, const HeadSpec& spec, const Cage& cage,
                                          const Eye& eye) {
  return measure_guides(cage, build_shape(shapes, spec, cage, eye), eye);
}

}  // namespace mien

#include "head/shapes.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "config/words.hpp"
#include "core/error.hpp"
#include "core/smooth.hpp"
#include "head/cage.hpp"
#include "head/organs.hpp"

namespace mien {

namespace {

// Where x changes over from the features' factor to the skull's, mm on the adult.
constexpr double kFeatures_mm = 20, kSkull_mm = 62;

using Shape = HeadForm;  // as it is summed and mixed

const GuideChart& find_adult_chart(const HeadShapes& shapes) { return shapes.charts.at(kAdult); }

glm::dvec3 warp_point(const Warp& warp, const glm::dvec3& p) {
  const double t = smooth_step(kFeatures_mm, kSkull_mm, std::abs(p.x));
  const double x = glm::mix(sample_curve(warp.inner, p.y), sample_curve(warp.outer, p.y), t);
  // The two depths meet with no kink at the ear canals.
  const double front = smooth_step(-10.0, 10.0, p.z);
  const double z = glm::mix(sample_curve(warp.back, p.y), sample_curve(warp.front, p.y), front);
  return {p.x * x, sample_curve(warp.height, p.y, true), p.z * z};
}

// What a character field leaves alone: ear, back and crown of the head, the eye opening, the neck.
std::vector<bool> compute_anchors(const Cage& cage, const Handles& handles) {
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
      solve_field(build_field_solver(warped), handles, compute_anchors(warped, handles), Reach::both);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] += scale * field[i];
}

Shape make_variant(const HeadShapes& shapes, const std::string& name, const Cage& cage, const Eye& eye) {
  Shape shape{cage.points, eye};
  const auto warp = shapes.warps.find(name);
  if (warp != shapes.warps.end()) {
    shape = apply_warp(cage, eye, warp->second);
    shape.brow_thickness = warp->second.brow_thickness;
  }
  const auto field = shapes.fields.find(name);
  if (field != shapes.fields.end()) add_field(cage, field->second, 1, shape.points);
  return shape;
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
  const Shape before = shape;
  add_form(shape, variant, weight * size);
  add_form(shape, {adult.points, eye}, -weight * size);
  // These are no lengths.
  shape.hairline = before.hairline;
  shape.brow_thickness = before.brow_thickness + weight * (variant.brow_thickness - 1);
}

// One age, its guide lines as far from the start's as its chart is from the adult's.
Shape build_age(const HeadShapes& shapes, const std::string& age, const Cage& adult, const Shape& start) {
  Cage cage = adult;
  cage.points = start.points;
  Shape shape = make_empty_form(adult);
  for (const auto& [name, weight] : flatten_mix(shapes.ages, {{age, 1.0}}))
    add_form(shape, make_variant(shapes, name, cage, start.eye), weight);
  shape.hairline = start.hairline;
  shape.brow_thickness *= start.brow_thickness;
  if (age == kAdult) return shape;
  const GuideChart &of_adult = find_adult_chart(shapes), &of_age = shapes.charts.at(age);
  GuideChart chart = measure_chart(adult, start);
  chart.height_mm *= of_age.height_mm / of_adult.height_mm;
  for (auto& [line, height] : chart.lines) height += of_age.lines.at(line) - of_adult.lines.at(line);
  fit_chart(adult, chart, shape);
  return shape;
}

void add_features(const HeadShapes& shapes, const HeadSpec& spec, const Cage& adult, double size,
                  Shape& shape) {
  Handles handles;
  std::map<std::string, double> reach;  // mm: how far the strongest of the features moves a point alone
  EyeChange eyes;
  EarChange ears;
  for (const auto& [name, value] : spec.features) {
    const Feature& feature = shapes.features.at(name);
    for (const auto& [point, move] : feature.handles) {
      handles[point] += value * size * move;
      reach[point] = std::max(reach[point], size * glm::length(move));
    }
    eyes.size += value * feature.eye_size;
    eyes.move_mm += value * size * feature.eye_move_mm;
    eyes.tilt_deg += value * feature.eye_tilt_deg;
    ears.size += value * feature.ear_size;
    ears.out_deg += value * (value > 0 ? feature.ear_out_deg : feature.ear_in_deg);
    shape.brow_thickness *= 1 + value * feature.brow_thickness;
  }
  // Features that pull the same way yield, or a long, drooping, far-standing nose would fold its nostrils.
  constexpr double kYield = 0.35;  // of what goes beyond the reach of the strongest
  for (auto& [point, move] : handles)
    if (const double length = glm::length(move), most = reach[point]; length > most)
      move *= (most + kYield * (length - most)) / length;
  if (!handles.empty()) add_field(adult, handles, 1, shape.points);
  change_eyes(adult, eyes, shape);
  change_ears(adult, ears, shape);
}

double find_character(const HeadShapes& shapes, const HeadSpec& spec) {
  double character = spec.character;
  for (const auto& [name, value] : spec.features) character += value * shapes.features.at(name).character;
  return std::clamp(character, -1.0, 1.0);
}

Shape build_shape(const HeadShapes& shapes, const HeadSpec& spec, const Cage& adult, const Shape& start) {
  Cage cage = adult;
  cage.points = start.points;
  Shape shape = make_empty_form(adult);
  double growth = 0;  // against the start
  for (const auto& [age, weight] : spec.age) {
    add_form(shape, build_age(shapes, age, adult, start), weight);
    growth += weight * shapes.charts.at(age).height_mm / find_adult_chart(shapes).height_mm;
  }
  for (const auto& [name, weight] : flatten_mix(shapes.skulls, spec.skull))
    add_variant(shapes, name, weight, growth, cage, start.eye, shape);
  const double character = find_character(shapes, spec);
  add_variant(shapes, character < 0 ? "female" : "male", std::abs(character), growth, cage, start.eye, shape);
  const double size = growth * measure_chart(adult, start).height_mm / find_adult_chart(shapes).height_mm;
  add_features(shapes, spec, cage, size, shape);
  close_lips(cage, growth, shape);
  return shape;
}

}  // namespace

HeadForm make_empty_form(const Cage& cage) {
  return {std::vector<glm::dvec3>(cage.points.size(), glm::dvec3(0)), {glm::dvec3(0), 0}, 0, 0, 0};
}

void add_form(HeadForm& sum, const HeadForm& addition, double weight) {
  for (std::size_t i = 0; i < sum.points.size(); ++i) sum.points[i] += weight * addition.points[i];
  sum.eye.centre += weight * addition.eye.centre;
  sum.eye.radius_mm += weight * addition.eye.radius_mm;
  sum.hairline += weight * addition.hairline;
  sum.brow_thickness += weight * addition.brow_thickness;
  sum.shortened_mm += weight * addition.shortened_mm;
}

void close_lips(const Cage& adult, double size, HeadForm& shape) {
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

HeadForm apply_warp(const Cage& cage, const Eye& eye, const Warp& warp) {
  HeadForm shape{cage.points, eye};
  // The ball's front keeps its place in the socket; behind it there is room.
  shape.eye.radius_mm = eye.radius_mm * warp.eye;
  shape.eye.centre = warp_point(warp, eye.centre + glm::dvec3(0, 0, eye.radius_mm));
  shape.eye.centre.z -= shape.eye.radius_mm;
  for (std::size_t i = 0; i < cage.points.size(); ++i) {
    const glm::dvec3 side(cage.names[i].starts_with("R:") ? -1 : 1, 1, 1);
    const glm::dvec3 carried = (shape.eye.centre + warp.eye * (cage.points[i] * side - eye.centre)) * side;
    shape.points[i] = glm::mix(warp_point(warp, cage.points[i]), carried,
                               compute_eye_share(cage.names[i], warp.carry_e3, warp.carry_e4, 0));
  }
  return shape;
}

void shape_head(const HeadShapes& shapes, const HeadSpec& spec, const Cage& adult, HeadForm& form) {
  Shape shape = build_shape(shapes, spec, adult, form);
  move_guides(adult, spec.guides, shape, spec.guide_shares);
  form = std::move(shape);
}

GuideLines compute_guides(const HeadShapes& shapes, const HeadSpec& spec, const Cage& cage, const Eye& eye) {
  return measure_guides(cage, build_shape(shapes, spec, cage, {cage.points, eye}));
}

std::vector<std::pair<std::string, double>> measure_guide_heights(const NeutralHead& head) {
  const Shape shape{head.cage.points, head.eye, head.hairline};
  const glm::dvec2 ends = find_height(head.cage, shape);
  const GuideLines lines = measure_guides(head.cage, shape);
  std::vector<std::pair<std::string, double>> heights{{"chin", ends.x}};
  for (const std::string& line : kGuides)
    heights.emplace_back(line, glm::mix(ends.x, ends.y, lines.at(line)));
  heights.emplace_back("crown", compute_bounds(head.skin.positions).high.y);
  return heights;
}

}  // namespace mien

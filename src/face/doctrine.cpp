#include "face/doctrine.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>

#include "config/doctrine_data.hpp"
#include "core/conventions.hpp"
#include "head/cage.hpp"
#include "head/patterns.hpp"

namespace mien {

namespace {

constexpr double kQuarter = std::numbers::pi / 2;

// The column of a ring of the mouth ("M3_7", "R:MB1_7"); -1 for other points.
int find_mouth_column(std::string_view name) {
  name = strip_side(name);
  const std::size_t line = name.find('_');
  if (!name.starts_with('M') || line == name.npos || name.starts_with("M6")) return -1;
  int column = 0;
  for (const char c : name.substr(line + 1)) column = 10 * column + (c - '0');
  return column;
}

// A muscle of one lip leaves the other: half of its pull at the corner, column 6, which both share.
double compute_lip_share(LipsOf lips, int column) {
  if (lips == LipsOf::both || column < 0) return 1;
  const double upper = std::clamp((7.0 - column) / 2, 0.0, 1.0);
  return lips == LipsOf::upper ? upper : 1 - upper;
}

// What is left of every muscle's pull, by point: none where nothing may move, little on the lids.
std::vector<double> build_shares(const NeutralHead& head) {
  const DoctrineData& data = head.data->doctrines;
  std::vector<double> shares(head.cage.names.size(), 1.0);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const std::string_view name = strip_side(head.cage.names[i]);
    const auto row = data.rows.find(std::string(name.substr(0, name.find('_'))));
    if (row != data.rows.end()) shares[i] = row->second;
  }
  const std::vector<bool> zero = find_points(head.cage, data.zero);
  for (std::size_t i = 0; i < shares.size(); ++i)
    if (zero[i]) shares[i] = 0;
  return shares;
}

// The field of a left muscle and its mirror image, or of one of the middle.
DrivenField build_driven(const NeutralHead& head, std::size_t channel, Field field) {
  const std::size_t twin = find_twin(channel);
  if (twin == channel) return {{{channel, 1}}, std::move(field), {}, {}, false, {}, {}};
  Field mirrored = mirror_field(head.cage, field);
  return {{{channel, 1}}, std::move(field), {{twin, 1}}, std::move(mirrored), false, {}, {}};
}

Field build_linear_field(const NeutralHead& head, const LinearMuscle& muscle,
                         const std::vector<double>& shares) {
  const std::uint32_t from = find_point(head.cage, muscle.from), to = find_point(head.cage, muscle.to);
  const auto length_of = [&](const std::vector<glm::dvec3>& points) {
    return glm::length(points[to] - points[from]);
  };
  const double scale = length_of(head.cage.points) / length_of(head.adult_points);
  const glm::dvec3 bone = head.cage.points[from] + scale * muscle.off_mm;
  const glm::dvec3 to_skin = head.cage.points[to] - bone;
  Field field(head.cage.points.size(), glm::dvec3(0));
  for (std::size_t i = 0; i < field.size(); ++i) {
    const glm::dvec3 to_point = head.cage.points[i] - bone;
    const double pull =
        compute_pull(to_point, to_skin, muscle.half_deg * kRadiansPerDegree, muscle.start, muscle.end);
    const double share =
        pull * shares[i] * compute_lip_share(muscle.lips, find_mouth_column(head.cage.names[i]));
    if (share > 0) field[i] = -scale * muscle.most_mm * share * glm::normalize(to_point);
  }
  return field;
}

// The skin of an ellipse drawn together: each point by a share of its own way to the middle, most there, so
// that points on both sides of it do not pass each other.
Field build_ring_field(const NeutralHead& head, const RingMuscle& muscle, const std::vector<double>& shares) {
  const bool is_eye = muscle.around.front() == "eye";
  glm::dvec3 middle = is_eye ? head.eye.centre : glm::dvec3(0);
  double scale = head.eye.radius_mm / head.adult_eye.radius_mm;
  if (!is_eye) {
    for (const std::string& name : muscle.around)
      middle += head.cage.points[find_point(head.cage, name)] / static_cast<double>(muscle.around.size());
    const std::uint32_t corner = find_point(head.cage, "M1_6");
    scale = head.cage.points[corner].x / head.adult_points[corner].x;
  }
  Field field(head.cage.points.size(), glm::dvec3(0));
  for (std::size_t i = 0; i < field.size(); ++i) {
    const glm::dvec3 arm = head.cage.points[i] - middle;
    const double radius = std::hypot(arm.x / muscle.half_mm.x, arm.y / muscle.half_mm.y) / scale;
    if (radius >= 1 || std::abs(arm.z) >= scale * muscle.deep_mm) continue;
    const double share = (1 - radius) * shares[i];
    field[i] = share * glm::dvec3(-muscle.pull.x * arm.x, -muscle.pull.y * arm.y, scale * muscle.forward_mm);
  }
  return field;
}

double find_unit_mm(const FaceUnits& units, const std::string& name) {
  return name == "eye_separation" ? units.eye_separation
         : name == "eye_nose"     ? units.eye_nose
         : name == "mouth_nose"   ? units.mouth_nose
                                  : units.mouth_width;
}

}  // namespace

struct DoctrineFields::Once {
  std::once_flag flag;
  std::vector<DrivenField> fields;
};

std::shared_ptr<DoctrineFields::Once> DoctrineFields::build() { return std::make_shared<Once>(); }

const std::vector<DrivenField>& DoctrineFields::get_muscles(const NeutralHead& head) {
  std::call_once(muscles_->flag, [&] { muscles_->fields = build_muscle_fields(head); });
  return muscles_->fields;
}

const std::vector<DrivenField>& DoctrineFields::get_units(const NeutralHead& head, const FaceUnits& units) {
  std::call_once(units_->flag, [&] { units_->fields = build_unit_fields(head, units); });
  return units_->fields;
}

double compute_pull(const glm::dvec3& to_point, const glm::dvec3& to_skin, double half_rad, double start,
                    double end) {
  const double distance = glm::length(to_point), length = glm::length(to_skin);
  if (distance == 0 || distance >= end * length) return 0;
  const double cosine = glm::dot(to_point, to_skin) / (distance * length);
  const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
  if (angle >= half_rad) return 0;
  const double way = distance / length;
  const double radial = way < start ? std::cos((1 - way / start) * kQuarter)
                                    : std::cos((way - start) / (end - start) * kQuarter);
  return std::cos(angle / half_rad * kQuarter) * radial;
}

std::vector<DrivenField> build_muscle_fields(const NeutralHead& head) {
  const std::vector<double> shares = build_shares(head);
  std::vector<DrivenField> fields;
  for (const LinearMuscle& muscle : head.data->doctrines.linear)
    fields.push_back(build_driven(head, muscle.channel, build_linear_field(head, muscle, shares)));
  for (const RingMuscle& muscle : head.data->doctrines.rings)
    fields.push_back(build_driven(head, muscle.channel, build_ring_field(head, muscle, shares)));
  return fields;
}

std::vector<DrivenField> build_unit_fields(const NeutralHead& head, const FaceUnits& units) {
  const PointPatterns& always = head.data->areas.anchors.at("always");
  const FieldSolver solver = build_field_solver(head.cage);
  std::vector<DrivenField> fields;
  for (const PointUnit& unit : head.data->doctrines.units) {
    Handles handles = unit.points;
    const glm::dvec3 scale(find_unit_mm(units, unit.units[0]), find_unit_mm(units, unit.units[1]),
                           find_unit_mm(units, unit.units[2]));
    for (auto& [point, way] : handles) way *= scale;
    PointPatterns still = always;
    still.insert(still.end(), unit.still.begin(), unit.still.end());
    Field field = solve_field(solver, handles, find_points(head.cage, still), Reach::both);
    Field reverse = field;
    for (glm::dvec3& way : reverse) way = -way;
    fields.push_back(build_driven(head, unit.channel, std::move(field)));
    if (kChannels[unit.channel].low < 0)
      fields.push_back({{{unit.channel, -1}}, std::move(reverse), {}, {}, false, {}, {}});
  }
  return fields;
}

}  // namespace mien

// What `rules: thesis` changes of a face before it is posed.
#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "core/conventions.hpp"
#include "face/thesis_rules.hpp"
#include "head/cage.hpp"
#include "head/patterns.hpp"

namespace mien {

namespace {

glm::dvec3 compute_skin_way(const NeutralHead& head, const Field& field, const char* name) {
  return sample_row(compute_limit_row(*head.surface, find_point(head.cage, name)), field);
}

DrivenField& find_brow_field(Face& face, const char* move, int sign) {
  const std::size_t wanted = *find_move("brow", Side::left, move);
  return *std::ranges::find_if(face.fields, [&](const DrivenField& driven) {
    return driven.drivers.size() == 1 && driven.drivers.front().move == wanted &&
           driven.drivers.front().sign == sign;
  });
}

// The brow as a stick that turns by `angle_rad` about its end in the plane of x and y; on its way up or down
// it slides over the skull as a brow does that `sliding` raises by as much.
Handles turn_stick(const Cage& cage, const char* end, double angle_rad, const Field& sliding) {
  const glm::dvec3 pivot = cage.points[find_point(cage, end)];
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  Handles handles;
  for (const char* name : kBrowPoints) {
    const std::uint32_t point = find_point(cage, name);
    const glm::dvec3 arm = cage.points[point] - pivot;
    const double rise = arm.x * s + arm.y * c - arm.y;
    handles[name] = {arm.x * c - arm.y * s - arm.x, rise, rise * sliding[point].z / sliding[point].y};
  }
  return handles;
}

// The angle between the brow's ends that a turn by the data's own handles has.
double measure_turn_rad(const NeutralHead& head, const Field& turn) {
  const glm::dvec3 inner = head.cage.points[find_point(head.cage, kBrowPoints.front())],
                   outer = head.cage.points[find_point(head.cage, kBrowPoints.back())];
  const glm::dvec3 rest = outer - inner;
  const glm::dvec3 turned = rest + compute_skin_way(head, turn, kBrowPoints.back()) -
                            compute_skin_way(head, turn, kBrowPoints.front());
  return std::atan2(turned.y, turned.x) - std::atan2(rest.y, rest.x);
}

void turn_about_end(const NeutralHead& head, const FieldSolver& solver, const std::vector<bool>& anchors,
                    const Field& sliding, const char* end, DrivenField& driven) {
  constexpr int kRounds =
      8;  // the skin at the end is off by less than 0.05 mm then, the angle by a tenth of a degree
  const double wanted_rad = measure_turn_rad(head, driven.field);
  double angle_rad = wanted_rad;
  glm::dvec3 back(0);  // what brings the skin at the end back, which its neighbours drag along
  for (int round = 0; round < kRounds; ++round) {
    Handles handles = turn_stick(head.cage, end, angle_rad, sliding);
    handles[end] += back;
    driven.field = solve_field(solver, handles, anchors, Reach::left);
    back -= compute_skin_way(head, driven.field, end);
    angle_rad *= wanted_rad / measure_turn_rad(head, driven.field);
  }
  fade_far_side(head.cage, driven.field);
  driven.mirror_field = mirror_field(head.cage, driven.field);
}

void turn_brows_about_ends(const NeutralHead& head, Face& face) {
  const AreaData& data = head.data->areas;
  const FieldSolver solver = build_field_solver(head.cage);
  PointPatterns held = data.anchors.at("always");
  const PointPatterns& own = data.anchors.at("brow_turn");
  held.insert(held.end(), own.begin(), own.end());
  const std::vector<bool> anchors = find_points(head.cage, held);
  const Field& raised = find_brow_field(face, "up", 1).field;
  // The inner end goes up about the outer one; the outer one goes up about the inner one.
  turn_about_end(head, solver, anchors, raised, kBrowPoints.back(), find_brow_field(face, "turn", 1));
  turn_about_end(head, solver, anchors, raised, kBrowPoints.front(), find_brow_field(face, "turn", -1));
}

// The directions of the outline of the left eye's lids at rest, seen from the eye's centre.
struct Outline {
  std::vector<double> pitch_rad, yaw_rad;  // around
};

Outline measure_outline(const NeutralHead& head, const LidRig& lids) {
  Outline outline;
  for (int column = 0; column < kLidColumns; ++column) {
    glm::dvec3 at(0);
    for (const LidShare& share : lids.edges[1].shares[column])
      at += share.share * lids.rings[share.ring].rest[share.column];
    const glm::dvec3 way = at - head.eye.centre;
    outline.pitch_rad.push_back(std::atan2(way.y, std::hypot(way.x, way.z)));
    outline.yaw_rad.push_back(std::atan2(way.x, way.z));
  }
  return outline;
}

// Where the outline crosses `along` = 0, the furthest on either side: {lowest, highest} of `across`.
std::pair<double, double> find_crossings(const std::vector<double>& along,
                                         const std::vector<double>& across) {
  double low = 0, high = 0;
  for (std::size_t i = 0; i < along.size(); ++i) {
    const std::size_t next = (i + 1) % along.size();
    if ((along[i] > 0) == (along[next] > 0)) continue;
    const double at = std::lerp(across[i], across[next], along[i] / (along[i] - along[next]));
    low = std::min(low, at);
    high = std::max(high, at);
  }
  return {low, high};
}

void keep_pupils_in_outline(const NeutralHead& head, Face& face) {
  const auto& [pupil_mm, pupil_z] = head.data->parts.eye.iris_inner_mm;
  const double pupil_rad = std::atan2(pupil_mm, pupil_z);
  const Outline outline = measure_outline(head, face.lids);
  const auto [bottom, top] = find_crossings(outline.yaw_rad, outline.pitch_rad);
  const auto [inner, outer] = find_crossings(outline.pitch_rad, outline.yaw_rad);
  const auto limit = [&](double outline_rad, double& reach_rad) {
    reach_rad = std::clamp(outline_rad - pupil_rad, 0.0, reach_rad);
  };
  limit(top, face.eye_up_rad);
  limit(-bottom, face.eye_down_rad);
  limit(std::min(-inner, outer), face.eye_side_rad);
}

void find_corner_points(const NeutralHead& head, Face& face) {
  constexpr std::array kRings{"EB", "E0", "E1", "E2"};  // those that turn with the lids there
  face.eye_corners.clear();
  for (const bool is_right : {false, true})
    for (const int column : {0, kLidColumns / 2}) {
      const auto find = [&](const char* ring) {
        const std::uint32_t left = find_point(head.cage, fmt::format("{}_{}", ring, column));
        return is_right ? head.cage.mirror[left] : left;
      };
      EyeCorner corner{compute_limit_row(*head.surface, find("E1")), {}, 0};
      for (const char* ring : kRings) corner.points.push_back(find(ring));
      for (const auto& [point, weight] : corner.row)
        if (std::ranges::find(corner.points, point) != corner.points.end()) corner.share += weight;
      face.eye_corners.push_back(std::move(corner));
    }
}

}  // namespace

void follow_thesis(const NeutralHead& head, Face& face) {
  turn_brows_about_ends(head, face);
  face.follows_thesis = true;
  find_corner_points(head, face);
  face.lids.meeting = face.lids.slide_upper_mm = face.lids.slide_lower_mm = {};
  keep_pupils_in_outline(head, face);
  if (!face.match_level_mm) face.match_level_mm = 0;
}

}  // namespace mien

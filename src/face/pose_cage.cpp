#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/conventions.hpp"
#include "face/face.hpp"

namespace mien {

namespace {

void add_scaled(const Field& field, double factor, std::vector<glm::dvec3>& points) {
  if (factor == 0) return;
  for (std::size_t i = 0; i < points.size(); ++i) points[i] += factor * field[i];
}

double signed_part(const Pose& pose, std::size_t move, int sign) {
  return std::max(0.0, sign * pose.values[move]);
}

double value_of(const Pose& pose, std::string_view area, Side side, std::string_view move) {
  return pose.values[*find_move(area, side, move)];
}

double gaze_pitch_rad(const Face& face, const Pose& pose, Side side) {
  const double up = value_of(pose, "eye", side, "up");
  return up * (up > 0 ? face.eye_up_rad : face.eye_down_rad);
}

using Columns = std::array<double, 9>;

// `height` of one margin, known at `along`, at another place along the axis.
double sample_margin(const Columns& along, const Columns& height, double at) {
  std::size_t i = 1;
  while (i < 8 && along[i] < at) ++i;
  const double t = std::clamp((at - along[i - 1]) / (along[i] - along[i - 1]), 0.0, 1.0);
  return glm::mix(height[i - 1], height[i], t);
}

// How far each column of the two margins turns.
struct LidTurns {
  Columns upper{}, lower{};
};

// Gaze and the two lids first, then shutting as a share of the way to the line where the lids meet. Both
// margins close on one line, whose height is asked at each column's own place. In a conflict the upper lid
// wins.
LidTurns find_lid_turns(const LidRig& rig, double upper, double lower, double pitch_rad) {
  const double follow = pitch_rad * (pitch_rad > 0 ? rig.follow_up : rig.follow_down);
  Columns up = rig.upper_rest_rad, low = rig.lower_rest_rad;
  for (int i = 1; i < 8; ++i) up[i] += rig.taper[i] * (follow + std::max(0.0, upper) * rig.wide_rad);
  for (int i = 1; i < 8; ++i) {
    low[i] += rig.taper[i] * (pitch_rad * rig.follow_lower + lower * rig.raised_rad);
    low[i] =
        std::min(low[i], sample_margin(rig.upper_along_mm, up, rig.lower_along_mm[i]) - rig.least_gap_rad);
  }
  const double shut = std::max(0.0, -upper);
  Columns meeting = low;
  for (int i = 1; i < 8; ++i)
    meeting[i] = glm::mix(low[i], sample_margin(rig.upper_along_mm, up, rig.lower_along_mm[i]), rig.meeting);
  LidTurns turns;
  for (int i = 1; i < 8; ++i) {
    const double line = sample_margin(rig.lower_along_mm, meeting, rig.upper_along_mm[i]);
    turns.upper[i] = glm::mix(up[i], line + 0.5 * rig.least_gap_rad, shut) - rig.upper_rest_rad[i];
    turns.lower[i] = glm::mix(low[i], meeting[i] - 0.5 * rig.least_gap_rad, shut) - rig.lower_rest_rad[i];
  }
  return turns;
}

glm::dvec3 turn_about_axis(const LidRig& rig, const glm::dvec3& arm, double angle_rad) {
  // Positive angles lift what lies in front of the axis: from z toward the rig's up.
  const glm::dvec3 up = glm::cross(glm::dvec3(0, 0, 1), rig.axis);
  const double along = glm::dot(arm, rig.axis), height = glm::dot(arm, up), depth = arm.z;
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return along * rig.axis + (height * c + depth * s) * up + glm::dvec3(0, 0, depth * c - height * s);
}

void turn_lids(const NeutralHead& head, const Face& face, const Pose& pose, Side side,
               std::vector<glm::dvec3>& points) {
  const LidRig& rig = face.lids;
  const double upper = value_of(pose, "lid", side, "upper"), lower = value_of(pose, "lid", side, "lower");
  const double pitch = gaze_pitch_rad(face, pose, side);
  const LidTurns turns = find_lid_turns(rig, upper, lower, pitch);

  const glm::dvec3 mirror(side == Side::left ? 1 : -1, 1, 1);
  for (const LidRing& ring : rig.rings[side == Side::left ? 0 : 1])
    for (int i = 0; i < 16; ++i) {
      const bool is_upper = i < 8;
      const int column = is_upper ? i : 16 - i;
      const double angle =
          is_upper ? turns.upper[column] * ring.upper_share : turns.lower[column] * ring.lower_share;
      const std::uint32_t p = ring.points[i];
      if (angle != 0) {
        const glm::dvec3 arm = head.cage.points[p] * mirror - rig.centre;
        glm::dvec3 move = turn_about_axis(rig, arm, angle) - arm;
        if (!is_upper) move += lower * rig.taper[column] * ring.bulge;
        points[p] += move * mirror;
      }
      if (ring.least_radius_mm == 0) continue;
      // Never into the ball: but a ring that lies nearer at rest may stay where it is.
      const glm::dvec3 arm = points[p] * mirror - rig.centre;
      const double rest = glm::length(head.cage.points[p] * mirror - rig.centre);
      const double least = std::min(ring.least_radius_mm, rest), length = glm::length(arm);
      if (length < least) points[p] = (rig.centre + arm * (least / length)) * mirror;
    }
}

glm::dvec3 turn_jaw_point(const JawRig& jaw, const glm::dvec3& point, double share) {
  const double angle = share * jaw.open_rad, c = std::cos(angle), s = std::sin(angle);
  const glm::dvec3 arm = point - jaw.axis;
  return jaw.axis + glm::dvec3(arm.x, arm.y * c - arm.z * s, arm.y * s + arm.z * c) + share * jaw.forward;
}

// LIPS_MATCH_LEVEL: overlapping lips are pushed apart half and half; pressed lips close what a shut jaw
// leaves open.
void match_lips(const Face& face, const Pose& pose, std::vector<glm::dvec3>& points) {
  const double press = value_of(pose, "lips", Side::none, "press");
  for (const LipColumn& column : face.lips) {
    const double gap = points[column.upper_contact].y - points[column.lower_contact].y - column.rest_gap_mm;
    double closing = 0;
    if (gap < 0) closing = gap / 2;
    if (gap > 0 && gap < face.seal_until_mm) closing = press * gap / 2;
    if (closing == 0) continue;
    for (const auto& [point, share] : column.upper) points[point].y -= closing * share;
    for (const auto& [point, share] : column.lower) points[point].y += closing * share;
  }
}

}  // namespace

void pose_cage(const NeutralHead& head, const Face& face, const Pose& pose, std::vector<glm::dvec3>& points) {
  points = head.cage.points;
  if (pose == Pose{}) return;
  for (const MoveField& move : face.moves)
    add_scaled(move.field, signed_part(pose, move.move, move.sign), points);
  for (const CorrectiveField& corrective : face.correctives) {
    double product = 1;
    for (const auto& [move, sign] : corrective.drivers) product *= signed_part(pose, move, sign);
    add_scaled(corrective.field, product, points);
  }
  turn_lids(head, face, pose, Side::left, points);
  turn_lids(head, face, pose, Side::right, points);
  const double open = value_of(pose, "chin", Side::none, "down");
  if (open != 0)
    for (std::size_t i = 0; i < points.size(); ++i)
      if (face.jaw.weights[i] != 0)
        points[i] = turn_jaw_point(face.jaw, points[i], open * face.jaw.weights[i]);
  match_lips(face, pose, points);
}

glm::dmat3 find_gaze(const Face& face, const Pose& pose, Side side) {
  const double yaw = value_of(pose, "eye", side, "side") * face.eye_side_rad;
  const double pitch = gaze_pitch_rad(face, pose, side);
  const glm::dmat4 turned = glm::rotate(glm::dmat4(1), yaw, glm::dvec3(0, 1, 0));
  return glm::dmat3(glm::rotate(turned, -pitch, glm::dvec3(1, 0, 0)));
}

glm::dmat4 find_jaw(const Face& face, const Pose& pose) {
  const double open = value_of(pose, "chin", Side::none, "down");
  glm::dmat4 world = glm::translate(glm::dmat4(1), face.jaw.axis + open * face.jaw.forward);
  world = glm::rotate(world, open * face.jaw.open_rad, glm::dvec3(1, 0, 0));
  return glm::translate(world, -face.jaw.axis);
}

}  // namespace mien

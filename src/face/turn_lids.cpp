#include <algorithm>
#include <cmath>

#include "face/lid_place.hpp"
#include "face/lid_rig.hpp"
#include "head/contact.hpp"

namespace mien {

namespace {

// A row's number, known at `along`, at another place along the axis: on a smooth curve (cubic, its slopes
// those of the neighbours' chords), since the skin between two columns is smooth as well.
double sample_row(const LidRow& along, const LidRow& row, double at) {
  std::size_t i = 1;
  while (i < 8 && along[i] < at) ++i;
  const auto slope = [&](std::size_t k) {
    const std::size_t from = k > 0 ? k - 1 : 0, to = std::min<std::size_t>(k + 1, 8);
    return (row[to] - row[from]) / (along[to] - along[from]);
  };
  const double width = along[i] - along[i - 1];
  const double t = std::clamp((at - along[i - 1]) / width, 0.0, 1.0), u = 1 - t;
  return row[i - 1] * u * u * (1 + 2 * t) + row[i] * t * t * (1 + 2 * u) +
         width * t * u * (u * slope(i - 1) - t * slope(i));
}

// Where an edge's two rows go on the skin: how far they turn and how far from the axis they lie then.
struct EdgeAim {
  LidRow upper_turn{}, lower_turn{};
  LidRow upper_radius_mm{}, lower_radius_mm{};
  LidRow upper_along_mm{}, lower_along_mm{};  // that it gains along the axis
  bool slides = false;                        // where it lies along it is asked at all
};

// Gaze and the two lids first, then shutting as a share of the way to the line where the lids meet. Both
// margins close on one line, whose place is asked at each column's own. In a conflict the upper lid wins.
EdgeAim compute_aim(const LidRig& rig, std::size_t e, const LidPose& pose) {
  const LidEdge& rest = rig.edges[e];
  const auto find_gap = [&](int row) {  // inside it is not seen and must not cross, least of all at the outer
    return (e == 1 ? 1 : row < 7 ? 1.75 : 3) * rig.least_gap_rad;  // corner, round which the skin cuts
  };
  const double follow = pose.pitch_rad * (pose.pitch_rad > 0 ? rig.follow_up : rig.follow_down);
  LidRow up = rest.upper_rad, low = rest.lower_rad;
  for (int i = 1; i < 8; ++i) up[i] += rig.taper[i] * (follow + std::max(0.0, pose.upper) * rig.wide_rad);
  for (int i = 1; i < 8; ++i) {
    low[i] += rig.taper[i] * (pose.pitch_rad * rig.follow_lower + pose.lower * rig.raised_rad);
    low[i] = std::min(low[i], sample_row(rest.upper_along_mm, up, rest.lower_along_mm[i]) - find_gap(i));
  }
  const double shut = std::max(0.0, -pose.upper);
  LidRow line = low, radius = rest.lower_radius_mm;
  for (int i = 1; i < 8; ++i) {
    const double at = rest.lower_along_mm[i];
    line[i] = glm::mix(low[i], sample_row(rest.upper_along_mm, up, at), rig.meeting[i]);
    radius[i] = 0.5 * (radius[i] + sample_row(rest.upper_along_mm, rest.upper_radius_mm, at));
  }
  EdgeAim aim{{}, {}, rest.upper_radius_mm, rest.lower_radius_mm, {}, {}, rig.pairing > 0 || shut > 0};
  for (int i = 1; i < 8; ++i) {
    const double apart = 0.5 * rig.pairing * (rest.lower_along_mm[i] - rest.upper_along_mm[i]);
    const double gain = apart - rig.slide_upper_mm[i], low_gain = -apart - rig.slide_lower_mm[i];
    aim.upper_along_mm[i] = shut * gain;
    aim.lower_along_mm[i] = shut * low_gain;
    const double at = rest.upper_along_mm[i] + gain, low_at = rest.lower_along_mm[i] + low_gain;
    const double height = sample_row(rest.lower_along_mm, line, at),
                 low_height = low_gain == 0 ? line[i] : sample_row(rest.lower_along_mm, line, low_at),
                 low_radius = low_gain == 0 ? radius[i] : sample_row(rest.lower_along_mm, radius, low_at);
    aim.upper_turn[i] = glm::mix(up[i], height + 0.5 * find_gap(i), shut) - rest.upper_rad[i];
    aim.lower_turn[i] = glm::mix(low[i], low_height - 0.5 * find_gap(i), shut) - rest.lower_rad[i];
    aim.upper_radius_mm[i] =
        glm::mix(aim.upper_radius_mm[i], sample_row(rest.lower_along_mm, radius, at), shut);
    aim.lower_radius_mm[i] = glm::mix(aim.lower_radius_mm[i], low_radius, shut);
  }
  return aim;
}

glm::dvec3 turn_about_axis(const LidRig& rig, const glm::dvec3& arm, double angle_rad) {
  // Positive angles lift what lies in front of the axis: from z toward the rig's up.
  const glm::dvec3 up = compute_up(rig);
  const double along = glm::dot(arm, rig.axis), height = glm::dot(arm, up), depth = arm.z;
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return along * rig.axis + (height * c + depth * s) * up + glm::dvec3(0, 0, depth * c - height * s);
}

struct LidColumn {
  bool is_upper;
  int row;  // in a LidRow
};
LidColumn compute_lid_column(int column) { return {column < 8, column <= 8 ? column : kLidColumns - column}; }

RingPoints turn_rings(const LidRig& rig, const std::array<EdgeAim, 2>& aims, const LidPose& pose) {
  const double shut = std::max(0.0, -pose.upper);
  RingPoints points;
  for (const LidRing& ring : rig.rings) {
    const EdgeAim& aim = aims[ring.is_inner ? 0 : 1];
    points.push_back(ring.rest);
    for (int i = 0; i < kLidColumns; ++i) {
      const auto [is_upper, row] = compute_lid_column(i);
      const double share = is_upper ? std::lerp(ring.upper_share, ring.shut_share, shut) : ring.lower_share;
      const double angle = share * (is_upper ? aim.upper_turn[row] : aim.lower_turn[row]);
      const double slide_mm = share * shut * (is_upper ? rig.slide_upper_mm[row] : rig.slide_lower_mm[row]);
      if (angle == 0 && slide_mm == 0) continue;
      points.back()[i] = rig.eye.centre + turn_about_axis(rig, ring.rest[i] - rig.eye.centre, angle);
      points.back()[i] -= slide_mm * rig.axis;
      if (!is_upper) points.back()[i] += pose.lower * rig.taper[row] * ring.bulge;
    }
  }
  return points;
}

// How much an edge's column lacks of its aim on the skin.
LidPlace compute_shortfall(const LidRig& rig, std::size_t e, const EdgeAim& aim, int column,
                           const glm::dmat3& eye_from_head, const glm::dvec3& on_skin) {
  const LidEdge& edge = rig.edges[e];
  const auto [is_upper, row] = compute_lid_column(column);
  const LidPlace now = find_place(rig, on_skin);
  LidPlace shortfall;
  shortfall.height_rad =
      (is_upper ? edge.upper_rad[row] + aim.upper_turn[row] : edge.lower_rad[row] + aim.lower_turn[row]) -
      now.height_rad;
  if (aim.slides)
    shortfall.along_mm = (is_upper ? edge.upper_along_mm[row] + aim.upper_along_mm[row]
                                   : edge.lower_along_mm[row] + aim.lower_along_mm[row]) -
                         now.along_mm;
  shortfall.radius_mm = (is_upper ? aim.upper_radius_mm[row] : aim.lower_radius_mm[row]) - now.radius_mm;
  if (e == 0) {
    const glm::dvec3 looked = rig.eye.centre + eye_from_head * (on_skin - rig.eye.centre);
    const double off = compute_standoff_mm(rig.eye_numbers, rig.eye, looked);
    shortfall.radius_mm = std::max(shortfall.radius_mm, edge.clear_mm[column] - off);
  }
  return shortfall;
}

// How far a column's inner edge was pushed out, by the cornea.
double compute_push_mm(const LidRig& rig, const EdgeAim& aim, int column, const glm::dvec3& on_skin) {
  const auto [is_upper, row] = compute_lid_column(column);
  const double aimed = is_upper ? aim.upper_radius_mm[row] : aim.lower_radius_mm[row];
  return std::max(0.0, find_place(rig, on_skin).radius_mm - aimed);
}

// Moves the control points of both edges until the skin is where they aim.
void set_edges(const LidRig& rig, const std::array<EdgeAim, 2>& aims, const LidPose& pose,
               RingPoints& points) {
  constexpr int kRounds = 6;     // fewer leave a tenth of a millimetre beside the corners
  constexpr double kGain = 1.4;  // a point has four ninths of its place on the skin, a whole edge two thirds
  const glm::dmat3 eye_from_head = glm::transpose(pose.gaze);
  for (int round = 0; round < kRounds; ++round) {
    std::array<std::array<LidPlace, kLidColumns>, 2> shortfalls;
    for (int i = 0; i < kLidColumns; ++i) {
      if (i % 8 == 0) continue;
      const std::array on_skin{compute_on_skin(rig.edges[0], i, points),
                               compute_on_skin(rig.edges[1], i, points)};
      for (std::size_t e = 0; e < 2; ++e)
        shortfalls[e][i] = compute_shortfall(rig, e, aims[e], i, eye_from_head, on_skin[e]);
      // The outer edge goes with the inner one, or the margin turns over.
      const double taper = rig.taper[compute_lid_column(i).row];
      shortfalls[1][i].radius_mm += taper * taper * taper * compute_push_mm(rig, aims[0], i, on_skin[0]);
    }
    for (std::size_t e = 0; e < 2; ++e)
      for (int i = 0; i < kLidColumns; ++i) {
        if (i % 8 == 0) continue;
        glm::dvec3& point = points[rig.edges[e].ring][i];
        LidPlace place = find_place(rig, point);
        place.height_rad += kGain * shortfalls[e][i].height_rad;
        place.radius_mm += kGain * shortfalls[e][i].radius_mm;
        place.along_mm += kGain * shortfalls[e][i].along_mm;
        point = compute_point_at(rig, place);
      }
  }
}

// A ring of the upper lid stays over the next lower one: what comes nearer to it than `wanted` tells for
// their room at rest, from below or above, takes it along and out by `forward`. All in radians about the
// lids' axis.
template <typename Wanted>
void keep_over(const LidRig& rig, const LidRing& lower, const LidRing& upper, const Wanted& wanted,
               double forward, Side side, std::vector<glm::dvec3>& points) {
  const glm::dvec3 mirror(side == Side::left ? 1 : -1, 1, 1);
  for (int i = 1; i < 8; ++i) {
    const double room = find_place(rig, upper.rest[i]).height_rad - find_place(rig, lower.rest[i]).height_rad;
    const LidPlace below =
        find_place(rig, points[side == Side::left ? lower.left[i] : lower.right[i]] * mirror);
    glm::dvec3& point = points[side == Side::left ? upper.left[i] : upper.right[i]];
    LidPlace place = find_place(rig, point * mirror);
    const double shortfall = below.height_rad + wanted(room) - place.height_rad;
    if (shortfall <= 0) continue;
    place.height_rad += shortfall;
    place.radius_mm *= 1 + forward * shortfall;
    point = compute_point_at(rig, place) * mirror;
  }
}

// The fold of the upper lid stays over the lid; the hood under the brow may hang down before the fold, but no
// further than the skin between them reaches.
void keep_fold(const LidRig& rig, Side side, std::vector<glm::dvec3>& points) {
  // More turns the skin between hood and fold over, less lifts the brow; where lids are opened wide they have
  // drawn it tight.
  const double hang_rad = std::lerp(0.07, 0.0, rig.pairing);
  const LidRing &fold = rig.rings[rig.fold_ring], &hood = rig.rings[rig.fold_ring + 1];  // E3, E4: by name
  keep_over(
      rig, rig.rings[rig.lid_ring], fold, [&](double room) { return room > 0 ? rig.fold_least * room : -1; },
      rig.fold_forward, side, points);
  keep_over(
      rig, fold, hood, [&](double room) { return std::min(room, 0.0) - hang_rad; }, 0, side, points);
}

}  // namespace

void turn_lids(const LidRig& rig, const LidPose& pose, Side side, std::vector<glm::dvec3>& points) {
  const glm::dvec3 mirror(side == Side::left ? 1 : -1, 1, 1);
  const bool is_moved =
      pose.upper != 0 || pose.lower != 0 || pose.pitch_rad != 0 || pose.gaze != glm::dmat3(1);
  RingPoints moved;
  if (is_moved) {
    const std::array aims{compute_aim(rig, 0, pose), compute_aim(rig, 1, pose)};
    moved = turn_rings(rig, aims, pose);
    set_edges(rig, aims, pose, moved);
  }
  for (std::size_t r = 0; r < rig.rings.size(); ++r) {
    const LidRing& ring = rig.rings[r];
    for (int i = 0; i < kLidColumns; ++i) {
      glm::dvec3& point = points[side == Side::left ? ring.left[i] : ring.right[i]];
      if (is_moved) point += (moved[r][i] - ring.rest[i]) * mirror;
      if (ring.least_radius_mm == 0) continue;
      // Never into the ball: but a ring that lies nearer at rest may stay where it is.
      const glm::dvec3 arm = point * mirror - rig.eye.centre;
      const double least = std::min(ring.least_radius_mm, glm::length(ring.rest[i] - rig.eye.centre));
      if (const double length = glm::length(arm); length < least)
        point = (rig.eye.centre + arm * (least / length)) * mirror;
    }
  }
  keep_fold(rig, side, points);
}

}  // namespace mien

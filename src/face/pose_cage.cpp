#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/conventions.hpp"
#include "core/smooth.hpp"
#include "core/sums.hpp"
#include "face/doctrine.hpp"
#include "face/face.hpp"
#include "face/thesis_rules.hpp"

namespace mien {

namespace {

void add_field(const DrivenField& driven, const Pose& pose, std::vector<glm::dvec3>& points) {
  const double here = compute_drive(driven.drivers, driven.yields, pose),
               there = compute_drive(driven.mirror_drivers, driven.mirror_yields, pose);
  if (here != 0 && there != 0)
    add_products(here, driven.field, there, driven.mirror_field, points);
  else if (here != 0)
    add_products(here, driven.field, points);
  else if (there != 0)
    add_products(there, driven.mirror_field, points);
}

double value_of(const Pose& pose, std::string_view area, Side side, std::string_view move) {
  return pose.values[*find_move(area, side, move)];
}

double gaze_pitch_rad(const Face& face, const Pose& pose, Side side) {
  const double up = value_of(pose, "eye", side, "up");
  return up * (up > 0 ? face.eye_up_rad : face.eye_down_rad);
}

glm::dmat3 build_gaze(double yaw_rad, double pitch_rad) {
  const glm::dmat4 turned = glm::rotate(glm::dmat4(1), yaw_rad, glm::dvec3(0, 1, 0));
  return glm::dmat3(glm::rotate(turned, -pitch_rad, glm::dvec3(1, 0, 0)));
}

double gaze_yaw_rad(const Face& face, const Pose& pose, Side side) {
  return value_of(pose, "eye", side, "side") * face.eye_side_rad;
}

LidPose compute_lid_pose(const Face& face, const Pose& pose, Side side) {
  const double yaw = gaze_yaw_rad(face, pose, side), pitch = gaze_pitch_rad(face, pose, side);
  return {value_of(pose, "lid", side, "upper"), value_of(pose, "lid", side, "lower"), pitch,
          build_gaze(side == Side::left ? yaw : -yaw, pitch)};
}

// How near skin comes to what stops it, of a room at rest of 1, where it asks for `room`: all the way down to
// `from`, from there ever slower, and never nearer than `least`, however far it asks.
double soften_stop(double room, double from, double least) {
  return room >= from ? room : least + (from - least) * std::exp((room - from) / (from - least));
}

// Skin that is pushed together keeps room in itself, and bulges.
void give_way(const GiveWay& give, std::vector<glm::dvec3>& points) {
  for (const GiveWayLine& line : give.lines)
    for (std::size_t i = 0; i < line.ways.size(); ++i) {
      const glm::dvec3 way = points[line.points[i + 1]] - points[line.points[i]];
      const double room = glm::dot(way, line.ways[i]) / line.rest_mm[i];
      if (room >= give.from) continue;
      const double shortfall_mm = (soften_stop(room, give.from, give.least) - room) * line.rest_mm[i];
      points[line.points[i + 1]] += shortfall_mm * (line.ways[i] + glm::dvec3(0, 0, give.forward));
    }
}

// The raised upper lip stops under the nose.
void stop_under_nose(const Face& face, std::vector<glm::dvec3>& points) {
  constexpr double kFrom = 0.58, kLeast = 0.38;  // nearer and the fold under the nose turns over
  for (const PhiltrumColumn& column : face.philtrum) {
    const double gap = (points[column.nose].y - points[column.rows.front().first].y) / column.rest_gap_mm;
    const double shortfall_mm = (soften_stop(gap, kFrom, kLeast) - gap) * column.rest_gap_mm;
    if (shortfall_mm <= 0) continue;
    for (const auto& [point, share] : column.rows) points[point].y -= share * shortfall_mm;
  }
}

// Lips that are pushed apart slide a little past each other as well, and lie higher and lower there: they
// part by a share more than they overlap. Pressed ones hardly do, or light would come in.
constexpr double kPart = 0.1, kPressed = 0.8;

// Resting lips leave a slit with the dark behind it. Rolled in they lie before the teeth, and close most of
// it.
constexpr double kSlit = 0.7;

// How much of a gap pressed lips close: all of a small one, none from `seal_until_mm` on, and no jump
// between.
double compute_seal(double gap) {
  const double t = std::clamp(2 * gap - 1, 0.0, 1.0);
  return 1 - smooth_share(t);
}

// How much further apart than at rest the lips are, by whichever measure says least: their control points,
// their skin, and the skin above one place where the lips' line is steep.
double compute_gap_mm(const LipColumn& column, const std::vector<glm::dvec3>& points) {
  const double skin = compute_skin_gap_mm(column, points);
  return std::min({points[column.upper_contact].y - points[column.lower_contact].y - column.rest_gap_mm,
                   skin - column.rest_skin_gap_mm,
                   skin + compute_lean_mm(column, points) - column.rest_leaning_gap_mm});
}

// No lip goes past its stop.
void stop_at_level(const Face& face, const std::vector<LipStop>& stops, std::vector<glm::dvec3>& points) {
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const LipColumn& column = face.lips[i];
    const double raise = std::max(0.0, stops[i].upper_mm - points[column.upper_contact].y),
                 lower = std::max(0.0, points[column.lower_contact].y - stops[i].lower_mm);
    for (const auto& [point, share] : column.upper) points[point].y += raise * share;
    for (const auto& [point, share] : column.lower) points[point].y -= lower * share;
  }
}

// Where lips that overlap meet by their level; nothing for a column whose lips do not.
std::vector<std::optional<double>> list_meetings(const Face& face, const std::vector<LipStop>& stops,
                                                 const std::vector<glm::dvec3>& points) {
  std::vector<std::optional<double>> meetings(stops.size());
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const double upper = points[face.lips[i].upper_contact].y, lower = points[face.lips[i].lower_contact].y;
    if (upper <= lower) meetings[i] = std::clamp(stops[i].level_mm, upper, lower);
  }
  return meetings;
}

// Brings lips that have been parted half and half to where they meet.
void bring_to_level(const Face& face, const std::vector<std::optional<double>>& meetings,
                    std::vector<glm::dvec3>& points) {
  for (std::size_t i = 0; i < meetings.size(); ++i) {
    if (!meetings[i]) continue;
    const LipColumn& column = face.lips[i];
    const double aside =
        *meetings[i] - 0.5 * (points[column.upper_contact].y + points[column.lower_contact].y);
    for (const auto& [point, share] : column.upper) points[point].y += aside * share;
    for (const auto& [point, share] : column.lower) points[point].y += aside * share;
  }
}

// LIPS_MATCH_LEVEL: overlapping lips are pushed apart half and half; pressed lips close what a shut jaw
// leaves open.
void match_lips(const Face& face, const Pose& pose, std::vector<glm::dvec3>& points) {
  const double press = std::max(value_of(pose, "lips", Side::none, "press"), compute_shut(pose));
  const double part = 1 + kPart * (1 - kPressed * std::min(press, 1.0));
  for (const LipColumn& column : face.lips) {
    const double gap = compute_gap_mm(column, points);
    double closing = 0;
    if (gap < 0) closing = part * gap / 2;
    const double seal = press * compute_seal(std::max(0.0, gap) / face.seal_until_mm);
    if (gap > 0) closing = seal * gap / 2;
    closing += seal * kSlit * column.rest_skin_gap_mm / 2;
    if (closing == 0) continue;
    for (const auto& [point, share] : column.upper) points[point].y -= closing * share;
    for (const auto& [point, share] : column.lower) points[point].y += closing * share;
  }
}

// What the columns' middles do not tell, where the lips' line is steep or its edge round: the skin itself is
// looked at, and parted where it still crosses.
void part_skin(const Face& face, std::vector<glm::dvec3>& points) {
  constexpr int kRounds = 4;     // each takes away half or more
  constexpr double kGain = 0.6;  // of what each lip gives way: a column has two thirds of its own place
  constexpr double kFar_mm = 4;  // lips that are further apart in every column have nothing to cross
  const bool is_near = std::ranges::any_of(
      face.lips, [&](const LipColumn& column) { return compute_gap_mm(column, points) < kFar_mm; });
  if (!is_near) return;
  static thread_local std::vector<glm::dvec3> upper_at, lower_at;
  for (int round = 0; round < kRounds; ++round) {
    std::array<LipShortfalls, 2> shortfalls{};
    for (const Side side : {Side::left, Side::right}) {
      place_lip(face.upper_lip, points, side, upper_at);
      place_lip(face.lower_lip, points, side, lower_at);
      compute_lip_shortfalls(face.upper_lip, upper_at, face.lower_lip, lower_at, 0,
                             shortfalls[side == Side::right ? 1 : 0]);
    }
    shortfalls[0][0] = std::max(shortfalls[0][0], shortfalls[1][0]);
    bool is_parted = true;
    for (std::size_t i = 0; i < face.lips.size(); ++i) {  // left columns 0 to 5, right ones 1 to 5
      const double shortfall = i < kLipColumns ? shortfalls[0][i] : shortfalls[1][i - kLipColumns + 1];
      if (shortfall <= 0) continue;
      is_parted = false;
      for (const auto& [point, share] : face.lips[i].upper) points[point].y += kGain * shortfall * share;
      for (const auto& [point, share] : face.lips[i].lower) points[point].y -= kGain * shortfall * share;
    }
    if (is_parted) return;
  }
}

}  // namespace

std::vector<const std::vector<DrivenField>*> list_doctrine_fields(const NeutralHead& head, const Face& face,
                                                                  const Pose& pose) {
  const auto moves_any = [&](std::size_t begin, std::size_t end) {
    return std::any_of(pose.values.begin() + static_cast<std::ptrdiff_t>(begin),
                       pose.values.begin() + static_cast<std::ptrdiff_t>(end),
                       [](double value) { return value != 0; });
  };
  std::vector<const std::vector<DrivenField>*> fields;
  if (moves_any(kFirstMuscle, kFirstUnit)) fields.push_back(&face.doctrines->get_muscles(head));
  if (moves_any(kFirstUnit, kChannelCount)) fields.push_back(&face.doctrines->get_units(head, face.units));
  return fields;
}

double compute_drive(const std::vector<SignedMove>& drivers, const std::vector<Yield>& yields,
                     const Pose& pose) {
  double product = drivers.empty() ? 0 : 1, most = 1;
  for (const auto& [move, sign] : drivers) {
    const double value = std::max(0.0, sign * pose.values[move]);
    product *= std::min(1.0, value);
    most = std::max(most, value);
  }
  if (product == 0) return 0;
  for (const Yield& yield : yields) {
    double kept = 1;  // of two sides first: the mirrored pose has the same to the last bit
    for (const auto& [move, sign] : yield.to)
      kept *= 1 - yield.share * std::clamp(sign * pose.values[move], 0.0, 1.0);
    product *= kept;
  }
  return product * most;  // past the limits no steeper than the drivers themselves
}

glm::dvec3 move_jaw_point(const JawRig& jaw, const glm::dvec3& point, double turned, double straight) {
  const double angle = turned * jaw.open_rad, c = std::cos(angle), s = std::sin(angle);
  const glm::dvec3 arm = point - jaw.axis;
  return jaw.axis + glm::dvec3(arm.x, arm.y * c - arm.z * s, arm.y * s + arm.z * c) + turned * jaw.forward -
         glm::dvec3(0, straight * jaw.straight_mm, 0);
}

double compute_shut(const Pose& pose) {
  // A chin that is pushed up and corners that are drawn in or up push together what shut lips draw out: all
  // of both would fold the skin beside the mouth over.
  constexpr double kChin = 0.6, kCorner = 0.25, kUp = 0.4;
  const double shut = value_of(pose, "lips", Side::none, "shut") *
                      (1 - kChin * std::clamp(value_of(pose, "chin", Side::none, "up"), 0.0, 1.0));
  double corners = 1;  // of two sides first: the mirrored pose has the same to the last bit
  for (const Side side : {Side::left, Side::right})
    corners *= (1 - kCorner * std::clamp(-value_of(pose, "corner", side, "out"), 0.0, 1.0)) *
               (1 - kUp * std::clamp(value_of(pose, "corner", side, "up"), 0.0, 1.0));
  // So do lips that are drawn aside, and a jaw that goes forward or aside.
  constexpr double kAside = 0.6, kJaw = 0.5;
  const auto keep = [&](const char* area, const char* move, double share) {
    const double value = value_of(pose, area, Side::none, move);
    return 1 - share * std::min(value * value, 1.0);
  };
  return shut * corners * keep("mouth", "side", kAside) * keep("jaw", "side", kJaw) *
         keep("jaw", "forward", kJaw);
}

double compute_jaw_share(const JawRig& jaw, std::size_t point, double shut) {
  return jaw.weights[point] - shut * jaw.shut[point];
}

double compute_straight(const Pose& pose) {
  // A product: the lesser of both would be a jolt where one overtakes the other.
  return value_of(pose, "chin", Side::none, "straight") *
         std::max(0.0, 1 - value_of(pose, "chin", Side::none, "down"));
}

double compute_skin_gap_mm(const LipColumn& column, const std::vector<glm::dvec3>& points) {
  // The limit of a cubic spline at the middle one of three points.
  const auto height = [&](const std::array<std::uint32_t, 3>& row) {
    return (points[row[0]].y + 4 * points[row[1]].y + points[row[2]].y) / 6;
  };
  return height(column.upper_edge) - height(column.lower_edge);
}

double compute_lean_mm(const LipColumn& column, const std::vector<glm::dvec3>& points) {
  constexpr double kSteep = 0.05;                 // keeps the slope of an upright line from growing past two
  if (column.inward == column.outward) return 0;  // the middle
  const glm::dvec3 along = points[column.outward] - points[column.inward];
  const double slope = along.x * along.y / (along.x * along.x + kSteep * along.y * along.y);
  return slope * (points[column.lower_contact].x - points[column.upper_contact].x);
}

Pose stiffen_pose(const Face& face, const Pose& pose) {
  Pose stiff = pose;
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    const double past = std::min(std::abs(pose.values[i]), 2.0) - 1;
    if (past <= 0) continue;
    const double reach = pose.values[i] > 0 ? face.plus_reach[i] : face.minus_reach[i];
    stiff.values[i] = std::copysign(1 + past * (reach - 1), pose.values[i]);
  }
  return stiff;
}

namespace {

// All but what keeps the lips apart.
void pose_freely(const NeutralHead& head, const Face& face, const Pose& pose,
                 std::vector<glm::dvec3>& points) {
  for (const DrivenField& driven : face.fields)
    if (!driven.is_late) add_field(driven, pose, points);
  // What muscles and units draw, lids, jaw and lips then find as their own fields.
  for (const std::vector<DrivenField>* fields : list_doctrine_fields(head, face, pose))
    for (const DrivenField& driven : *fields) add_field(driven, pose, points);
  const std::vector<glm::dvec3> corners = find_eye_corners(face, points);
  for (const Side side : {Side::left, Side::right})
    turn_lids(face.lids, compute_lid_pose(face, pose, side), side, points);
  keep_eye_corners(face, corners, points);
  give_way(face.give_way, points);
  const double open = value_of(pose, "chin", Side::none, "down"), straight = compute_straight(pose);
  if (open != 0 || straight != 0) {
    const double shut = compute_shut(pose);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (const double weight = compute_jaw_share(face.jaw, i, shut); weight != 0)
        points[i] = move_jaw_point(face.jaw, points[i], open * weight, straight * weight);
  }
  for (const DrivenField& driven : face.fields)
    if (driven.is_late) add_field(driven, pose, points);
  stop_under_nose(face, points);
}

}  // namespace

void pose_cage_bare(const NeutralHead& head, const Face& face, const Pose& asked,
                    std::vector<glm::dvec3>& points) {
  points = head.cage.points;
  if (asked != Pose{}) pose_freely(head, face, hold_brows(face, stiffen_pose(face, asked)), points);
}

void pose_cage(const NeutralHead& head, const Face& face, const Pose& asked,
               std::vector<glm::dvec3>& points) {
  points = head.cage.points;
  if (asked == Pose{}) return;
  const Pose pose = hold_chin(head, face, hold_brows(face, stiffen_pose(face, asked)));
  pose_freely(head, face, pose, points);
  const std::vector<LipStop> stops = compute_lip_stops(head, face, pose);
  stop_at_level(face, stops, points);
  const std::vector<std::optional<double>> meetings = list_meetings(face, stops, points);
  match_lips(face, pose, points);
  part_skin(face, points);
  bring_to_level(face, meetings, points);
}

glm::dmat3 compute_gaze(const Face& face, const Pose& pose, Side side) {
  return build_gaze(gaze_yaw_rad(face, pose, side), gaze_pitch_rad(face, pose, side));
}

glm::dmat4 compute_jaw(const Face& face, const Pose& pose) {
  const Pose stiff = stiffen_pose(face, pose);
  const double open = value_of(stiff, "chin", Side::none, "down");
  const glm::dvec3 slide = value_of(stiff, "jaw", Side::none, "side") * face.jaw.aside +
                           value_of(stiff, "jaw", Side::none, "forward") * face.jaw.protruded +
                           value_of(stiff, "lips", Side::none, "roll_lower") * face.jaw.rolled -
                           glm::dvec3(0, compute_straight(stiff) * face.jaw.straight_mm, 0);
  glm::dmat4 world = glm::translate(glm::dmat4(1), face.jaw.axis + open * face.jaw.forward + slide);
  world = glm::rotate(world, open * face.jaw.open_rad, glm::dvec3(1, 0, 0));
  return glm::translate(world, -face.jaw.axis);
}

}  // namespace mien

// Face units after MPEG-4's FAPU (ISO/IEC 14496-2), limits after Yen (1990).
#include "face/limits.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "core/conventions.hpp"
#include "core/error.hpp"
#include "head/surface.hpp"

namespace mien {

namespace {

double compute_unit_mm(const FaceUnits& units, const std::string& name) {
  if (name == "eye_separation") return units.eye_separation;
  if (name == "eye_nose") return units.eye_nose;
  if (name == "mouth_nose") return units.mouth_nose;
  if (name == "mouth_width") return units.mouth_width;
  if (name == "iris") return units.iris;
  throw RunError(fmt::format("unknown face unit '{}'", name));
}

struct Ways {
  double point_mm = 0, skin_mm = 0;
};

// How far a point of the cage goes with one move alone, and the skin that it has under it.
Ways compute_ways(const NeutralHead& head, const Face& face, const Pose& pose, const std::string& point) {
  std::vector<glm::dvec3> points;
  pose_cage(head, face, pose, points);
  const auto found = head.cage.index.find(point);
  if (found == head.cage.index.end()) throw RunError(fmt::format("unknown point '{}' of a limit", point));
  const std::uint32_t i = found->second;
  glm::dvec3 skin(0);
  for (std::uint32_t k = head.surface->first[i]; k < head.surface->first[i + 1]; ++k) {
    const std::uint32_t p = head.surface->point[k];
    skin += static_cast<double>(head.surface->weight[k]) * (points[p] - head.cage.points[p]);
  }
  return {glm::distance(points[i], head.cage.points[i]), glm::length(skin)};
}

}  // namespace

double compute_length_mm(const FaceUnits& units, const LimitLength& length) {
  return length.unit == "mm" ? length.value : length.value * compute_unit_mm(units, length.unit);
}

namespace {

double compute_angle_deg(const Face& face, const LimitName& name) {
  const MoveInfo& info = kMoves[name.move];
  double angle = face.jaw.open_rad;
  if (info.area == "lid") angle = info.move == "upper" ? face.lids.wide_rad : face.lids.raised_rad;
  if (info.area == "eye" && info.move == "up") angle = name.sign > 0 ? face.eye_up_rad : face.eye_down_rad;
  if (info.area == "eye" && info.move == "side") angle = face.eye_side_rad;
  return angle / kRadiansPerDegree;
}

Limit measure_turn(const NeutralHead& head, const Face& face, const LimitName& name, double share,
                   const Pose& lifted, const std::string& point) {
  Limit limit{&name, "deg", share * compute_angle_deg(face, name), 0, 0, point, -1};
  if (kMoves[name.move].area == "eye") {
    // The pupil's way is the chord of its turn about the eye's centre.
    limit.mm = limit.skin_mm = 2 * head.eye.radius_mm * std::sin(limit.value * kRadiansPerDegree / 2);
    return limit;
  }
  const Ways ways = compute_ways(head, face, lifted, point);
  limit.mm = ways.point_mm;
  limit.skin_mm = ways.skin_mm;
  return limit;
}

// One limit where its share of the head's own is this.
Limit measure_limit(const NeutralHead& head, const Face& face, const LimitName& name, double asked) {
  const FaceUnits adult = measure_face(head.cage, head.adult_points, head.adult_eye);
  const MoveInfo& info = kMoves[name.move];
  const LimitPlace& place = head.data->areas.limits.at(fmt::format("{}.{}", info.area, info.move));
  Pose lifted;
  lifted.values[name.move] = name.sign * asked;
  const double share = std::abs(stiffen_pose(face, lifted).values[name.move]);
  const std::string point = (info.side == Side::right && info.area != "eye" ? "R:" : "") + place.point;
  if (place.point == kTonguePlace) {
    const double reach_mm = info.move == "out" ? face.tongue_out_mm : face.tongue_up_mm;
    return {&name,
            place.unit,
            share * reach_mm / compute_unit_mm(face.units, place.unit),
            share * reach_mm,
            share * reach_mm,
            point,
            place.axis};
  }
  if (place.axis < 0) return measure_turn(head, face, name, share, lifted, point);
  if (face.follows_thesis && info.area == "brow" && info.move == "turn") {
    // About its end, whose other end goes furthest.
    const std::string end =
        (info.side == Side::right ? "R:" : "") + std::string(name.sign > 0 ? "E5_2" : "E5_6");
    const Ways ways = compute_ways(head, face, lifted, end);
    return {&name,         place.unit,   ways.point_mm / compute_unit_mm(face.units, place.unit),
            ways.point_mm, ways.skin_mm, end,
            place.axis};
  }
  const double adult_mm = (name.sign > 0 ? place.plus_mm : place.minus_mm) *
                          get_gain(head.design, info.area, info.move, name.sign);
  const double value = share * adult_mm / compute_unit_mm(adult, place.unit);
  return {&name,
          place.unit,
          value,
          value * compute_unit_mm(face.units, place.unit),
          compute_ways(head, face, lifted, point).skin_mm,
          point,
          place.axis};
}

}  // namespace

LimitShares::LimitShares() {
  plus.fill(1);
  minus.fill(1);
}

LimitShares compute_limit_shares(const std::map<std::string, double>& limits) {
  LimitShares shares;
  for (const LimitName& name : list_limits())
    if (const auto found = limits.find(name.name); found != limits.end())
      (name.sign > 0 ? shares.plus : shares.minus)[name.move] = found->second;
  return shares;
}

Pose apply_limits(const LimitShares& shares, const Pose& pose) {
  Pose limited = pose;
  for (std::size_t i = 0; i < kMoveCount; ++i)
    limited.values[i] *= pose.values[i] > 0 ? shares.plus[i] : shares.minus[i];
  return limited;
}

std::vector<Limit> measure_limits(const NeutralHead& head, const Face& face, const LimitShares& shares) {
  std::vector<Limit> limits;
  for (const LimitName& name : list_limits())
    limits.push_back(
        measure_limit(head, face, name, (name.sign > 0 ? shares.plus : shares.minus)[name.move]));
  return limits;
}

void fit_limit_lengths(const NeutralHead& head, const Face& face,
                       const std::map<std::string, LimitLength>& lengths, LimitShares& shares) {
  constexpr int kHalvings = 24;
  for (const LimitName& name : list_limits()) {
    const auto found = lengths.find(name.name);
    if (found == lengths.end()) continue;
    const LimitLength& length = found->second;
    const double asked_mm = compute_length_mm(face.units, length);
    double low = 0, high = kMaxLimit;
    const double most_mm = measure_limit(head, face, name, high).mm;
    const bool is_reached = asked_mm <= most_mm;
    // A name that several moves share is a mistake if none of them reaches it.
    const auto reaches_it = [&](const LimitName& other) {
      const auto same = lengths.find(other.name);
      return same != lengths.end() && same->second.is_shared &&
             same->second.place.line == length.place.line &&
             same->second.place.column == length.place.column &&
             asked_mm <= measure_limit(head, face, other, kMaxLimit).mm;
    };
    if (!is_reached && !(length.is_shared && std::ranges::any_of(list_limits(), reaches_it)))
      throw InputError(
          {Diagnostic{length.place,
                      fmt::format("'{}' goes {:.1f} mm at most on this head; expected no more than that",
                                  name.name, most_mm),
                      "", false}});
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (low + high);
      (measure_limit(head, face, name, middle).mm < asked_mm ? low : high) = middle;
    }
    (name.sign > 0 ? shares.plus : shares.minus)[name.move] = 0.5 * (low + high);
  }
}

}  // namespace mien

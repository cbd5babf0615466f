#include "face/thesis_rules.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <ranges>

#include "head/cage.hpp"

namespace mien {

namespace {

constexpr int kHalvings = 30;  // to a millionth of a limit

std::size_t find_sided_move(const char* area, Side side, const char* move) {
  return *find_move(area, side, move);
}

BrowBox::Heights compute_heights(const Face& face, const BrowBox& box, const Pose& pose) {
  BrowBox::Heights heights = box.rest_mm;
  for (std::size_t i = 0; i < face.fields.size(); ++i) {
    const DrivenField& driven = face.fields[i];
    const double here = compute_drive(driven.drivers, driven.yields, pose),
                 there = compute_drive(driven.mirror_drivers, driven.mirror_yields, pose);
    for (std::size_t p = 0; p < BrowBox::kPoints; ++p)
      heights[p] += here * box.rises_mm[i][p] + there * box.mirror_rises_mm[i][p];
  }
  return heights;
}

// The value of `move` between what is asked and its other limit at which the brow is back in its rectangle.
template <typename IsInside>
double find_held(Pose pose, std::size_t move, double other, const IsInside& is_inside) {
  double out = pose.values[move], in = other;
  for (int i = 0; i < kHalvings; ++i) {
    pose.values[move] = 0.5 * (out + in);
    (is_inside(pose) ? in : out) = pose.values[move];
  }
  return in;
}

void hold_brow(const Face& face, Side side, Pose& pose, std::vector<BrowHold>* holds) {
  constexpr double kSlack_mm = 1e-6;  // of a limit that is reached exactly
  const BrowBox& box = face.brow_boxes[side == Side::right ? 1 : 0];
  const std::size_t up = find_sided_move("brow", side, "up");
  for (const bool is_top : {true, false}) {
    const auto find_furthest = [&](const BrowBox::Heights& heights) {
      return is_top ? std::ranges::max_element(heights) : std::ranges::min_element(heights);
    };
    const auto is_inside = [&](const Pose& asked) {
      const BrowBox::Heights heights = compute_heights(face, box, asked);
      const double furthest = *find_furthest(heights);
      return is_top ? furthest <= box.top_mm + kSlack_mm : furthest >= box.bottom_mm - kSlack_mm;
    };
    if (is_inside(pose)) continue;
    const BrowBox::Heights heights = compute_heights(face, box, pose);
    BrowHold hold{side, is_top, static_cast<std::size_t>(find_furthest(heights) - heights.begin()),
                  pose.values[up], 0};
    // Where the brow is steeper than its rectangle is high, it turns less as well.
    const std::size_t turn = find_sided_move("brow", side, "turn");
    Pose other = pose;
    other.values[up] = is_top ? box.lowest : box.highest;
    const auto is_all_inside = [&](const Pose& tried) {
      const auto [least, most] = std::ranges::minmax(compute_heights(face, box, tried));
      return least >= box.bottom_mm - kSlack_mm && most <= box.top_mm + kSlack_mm;
    };
    if (!is_inside(other)) {
      other.values[turn] = find_held(other, turn, 0, is_all_inside);
      pose = other;
    } else {
      pose.values[up] = find_held(pose, up, other.values[up], is_inside);
    }
    hold.held_up = pose.values[up];
    if (holds != nullptr) holds->push_back(hold);
  }
}

// Whether a field belongs to lips or chin, which the level stops; all else carries it.
bool is_stopped(const std::vector<SignedMove>& drivers) {
  return std::ranges::any_of(drivers, [](const SignedMove& driver) {
    return kMoves[driver.move].of == Area::lips || kMoves[driver.move].of == Area::chin;
  });
}

// How far a field and its mirror image take a point of the cage: added to each other first, so that mirrored
// poses give mirrored sums to the last bit.
glm::dvec3 compute_way(const DrivenField& driven, const Pose& pose, std::uint32_t point) {
  const glm::dvec3 here = compute_drive(driven.drivers, driven.yields, pose) * driven.field[point];
  if (driven.mirror_drivers.empty()) return here;
  return here + compute_drive(driven.mirror_drivers, driven.mirror_yields, pose) * driven.mirror_field[point];
}

// How far all but lips and chin raise a point of the cage, muscles and units among them.
double sum_carrying_rises(const NeutralHead& head, const Face& face, const Pose& pose, std::uint32_t point) {
  double rise = 0;
  for (const DrivenField& driven : face.fields)
    if (!is_stopped(driven.drivers)) rise += compute_way(driven, pose, point).y;
  for (const std::vector<DrivenField>* fields : list_doctrine_fields(head, face, pose))
    for (const DrivenField& driven : *fields) rise += compute_way(driven, pose, point).y;
  return rise;
}

LipStop compute_lip_stop(const NeutralHead& head, const Face& face, const Pose& pose,
                         const LipColumn& column) {
  const auto carry = [&](std::uint32_t point) {
    return head.cage.points[point].y + sum_carrying_rises(head, face, pose, point);
  };
  const double upper = carry(column.upper_contact), lower = carry(column.lower_contact);
  return {upper + std::min(0.0, *face.match_level_mm), lower + std::max(0.0, *face.match_level_mm),
          0.5 * (upper + lower) + *face.match_level_mm};
}

// Where the lower lip's middle comes to.
double compute_lower_lip_mm(const NeutralHead& head, const Face& face, const Pose& pose) {
  const std::uint32_t point = face.lips.front().lower_contact;
  glm::dvec3 at = head.cage.points[point];
  for (const DrivenField& driven : face.fields) at += compute_way(driven, pose, point);
  for (const std::vector<DrivenField>* fields : list_doctrine_fields(head, face, pose))
    for (const DrivenField& driven : *fields) at += compute_way(driven, pose, point);
  const double open = pose.values[*find_move("chin", Side::none, "down")];
  const double weight = compute_jaw_share(face.jaw, point, compute_shut(pose));
  return move_jaw_point(face.jaw, at, open * weight, compute_straight(pose) * weight).y;
}

}  // namespace

std::vector<glm::dvec3> find_eye_corners(const Face& face, const std::vector<glm::dvec3>& points) {
  std::vector<glm::dvec3> corners;
  for (const EyeCorner& corner : face.eye_corners) corners.push_back(sample_row(corner.row, points));
  return corners;
}

void keep_eye_corners(const Face& face, const std::vector<glm::dvec3>& before,
                      std::vector<glm::dvec3>& points) {
  const std::vector<glm::dvec3> now = find_eye_corners(face, points);
  for (std::size_t i = 0; i < now.size(); ++i)
    for (const std::uint32_t point : face.eye_corners[i].points)
      points[point] += (before[i] - now[i]) / face.eye_corners[i].share;
}

std::vector<BrowBox> build_brow_boxes(const NeutralHead& head, const Face& face, const LimitShares& limits) {
  std::vector<BrowBox> boxes;
  for (const Side side : {Side::left, Side::right}) {
    BrowBox box;
    const auto measure = [&](const std::vector<glm::dvec3>& points) {
      BrowBox::Heights heights{};
      for (std::size_t p = 0; p < BrowBox::kPoints && !points.empty(); ++p) {
        const std::uint32_t left = find_point(head.cage, kBrowPoints[p]);
        const std::uint32_t point = side == Side::left ? left : head.cage.mirror[left];
        heights[p] = sample_row(compute_limit_row(*head.surface, point), points).y;
      }
      return heights;
    };
    box.rest_mm = measure(head.cage.points);
    for (const DrivenField& driven : face.fields) {
      box.rises_mm.push_back(measure(driven.field));
      box.mirror_rises_mm.push_back(measure(driven.mirror_field));
    }
    const std::size_t up = find_sided_move("brow", side, "up");
    Pose pose;
    box.highest = pose.values[up] = limits.plus[up];
    box.top_mm = std::ranges::max(compute_heights(face, box, stiffen_pose(face, pose)));
    box.lowest = pose.values[up] = -limits.minus[up];
    box.bottom_mm = std::ranges::min(compute_heights(face, box, stiffen_pose(face, pose)));
    boxes.push_back(std::move(box));
  }
  return boxes;
}

Pose hold_brows(const Face& face, const Pose& asked, std::vector<BrowHold>* holds) {
  Pose pose = asked;
  if (!face.brow_boxes.empty())
    for (const Side side : {Side::left, Side::right}) hold_brow(face, side, pose, holds);
  return pose;
}

std::vector<BrowHold> find_brow_holds(const Face& face, const LimitShares& limits, const Pose& pose) {
  std::vector<BrowHold> holds;
  hold_brows(face, stiffen_pose(face, apply_limits(limits, pose)), &holds);
  // As the author counts: in shares of the head's own limits.
  for (BrowHold& hold : holds) {
    const std::size_t up = find_sided_move("brow", hold.side, "up");
    hold.asked_up = pose.values[up];
    const double share = (hold.held_up > 0 ? limits.plus : limits.minus)[up];
    if (share > 0) hold.held_up /= share;
  }
  return holds;
}

std::string describe_hold(const BrowHold& hold) {
  const std::size_t up = find_sided_move("brow", hold.side, "up");
  const auto limit = std::ranges::find_if(list_limits(), [&](const LimitName& name) {
    return name.move == up && (name.sign > 0) == hold.is_top;
  });
  return fmt::format("{}.up is {:.3g}; its {} reaches {}, and it goes to {:.3g}", find_area_key(kMoves[up]),
                     hold.asked_up, kBrowPointWords[hold.point], limit->thesis, hold.held_up);
}

Pose hold_chin(const NeutralHead& head, const Face& face, const Pose& asked) {
  const std::size_t up = *find_move("chin", Side::none, "up");
  if (!face.match_level_mm || asked.values[up] <= 0) return asked;
  Pose pose = asked;
  const auto is_inside = [&](const Pose& tried) {
    return compute_lower_lip_mm(head, face, tried) <=
           compute_lip_stop(head, face, tried, face.lips.front()).lower_mm;
  };
  if (!is_inside(pose)) pose.values[up] = find_held(pose, up, 0, is_inside);
  return pose;
}

std::vector<LipStop> compute_lip_stops(const NeutralHead& head, const Face& face, const Pose& pose) {
  std::vector<LipStop> stops;
  if (!face.match_level_mm) return stops;
  for (const LipColumn& column : face.lips) stops.push_back(compute_lip_stop(head, face, pose, column));
  return stops;
}

}  // namespace mien

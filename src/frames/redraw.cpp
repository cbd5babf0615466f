#include "frames/redraw.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/smooth.hpp"
#include "head/cage.hpp"
#include "timeline/head_turn.hpp"

namespace mien {

namespace {

constexpr double kMostStretch = 0.055, kMostSquash = 0.045;
constexpr double kThinner = 0.75,
                 kFlatter = 0.5;  // of the stretch: what grows in height loses in width and depth

double get_value(const Pose& pose, std::string_view area, Side side, std::string_view move) {
  return pose.values[*find_move(area, side, move)];
}

// Not jaw and lips, whose ways are those of speech, and not the gaze, which is aimed.
bool comes_early(std::string_view area) { return area == "brow" || area == "lid" || area == "corner"; }

// A lip that is raised under low brows is disgust, which skin tells by the folds beside the nose: a face
// without them tells it by all that is drawn, inner ends of the brows, narrow eyes, corners drawn wide and
// down. Whose jaw is open shouts.
void add_sneer(double sneer, Pose& pose) {
  constexpr double kTurn = -0.5, kLid = 0.3, kUp = -0.4, kOut = 0.35;
  constexpr double kLip = 0.5;  // of its own way
  const double lip = get_value(pose, "lips", Side::none, "upper") *
                     std::clamp(1 - get_value(pose, "chin", Side::none, "down"), 0.0, 1.0);
  double most_share = 0;
  for (const Side side : {Side::left, Side::right}) {
    const double share = sneer * std::clamp(std::min(lip, -get_value(pose, "brow", side, "up")), 0.0, 1.0);
    const auto add = [&](const char* area, const char* move, double by) {
      double& value = pose.values[*find_move(area, side, move)];
      const double least = std::min(-1.0, value), most = std::max(1.0, value);
      value = std::clamp(value + share * by, least, most);
    };
    add("brow", "turn", kTurn);
    add("lid", "lower", kLid);
    add("corner", "up", kUp);
    add("corner", "out", kOut);
    most_share = std::max(most_share, share);
  }
  pose.values[*find_move("lips", Side::none, "upper")] *= 1 + kLip * std::min(1.0, 2 * most_share);
}

glm::dvec3 stretch_point(const Redraw& redraw, double stretch, const glm::dvec3& p) {
  const double share =
      p.y >= redraw.chin_mm ? stretch : stretch * smooth_step(redraw.floor_mm, redraw.chin_mm, p.y);
  return {p.x * (1 - kThinner * share), redraw.floor_mm + (p.y - redraw.floor_mm) * (1 + stretch),
          p.z * (1 - kFlatter * share)};
}

// The turn of whatever goes so far with the head; the shares between are few enough to have a table.
class TurnTable {
 public:
  TurnTable(const Face& face, const TurnKey& turn) {
    for (std::size_t i = 0; i < turns_.size(); ++i)
      turns_[i] = compute_turn(face.turn_pivot, turn, static_cast<double>(i) / kLast);
  }
  glm::dvec3 turn(const glm::dvec3& point, double share) const {
    const double at = std::clamp(share, 0.0, 1.0) * kLast;
    const auto i = std::min(static_cast<std::size_t>(at), std::size_t{kLast - 1});
    const auto turned = [&](std::size_t k) { return glm::dvec3(turns_[k] * glm::dvec4(point, 1)); };
    return share >= 1 ? turned(kLast) : glm::mix(turned(i), turned(i + 1), at - static_cast<double>(i));
  }

 private:
  static constexpr int kLast = 32;
  std::array<glm::dmat4, kLast + 1> turns_;
};

}  // namespace

Redraw build_redraw(const NeutralHead& head, const Face& face) {
  Redraw redraw;
  redraw.lens = build_lens(head);
  redraw.jaw_stretch = head.design.jaw_stretch;
  redraw.brow_stretch = head.design.brow_stretch;
  redraw.early = head.design.early;
  redraw.lid_hood = head.design.lid_hood;
  redraw.floor_mm = compute_bounds(head.skin.positions).low.y;
  redraw.chin_mm = head.cage.points[find_point(head.cage, "m12_D1")].y;
  if (redraw.is_on()) redraw.turn_shares = spread_over_surface(*head.surface, face.turn_weights);
  return redraw;
}

Pose redraw_pose(const Redraw& redraw, const Pose& pose) {
  constexpr double kShut = -1;
  constexpr double kSneer = 1.6;  // of a face that tells half a feeling as early as comic's: all of it
  if (redraw.lid_hood == 0 && redraw.early == 0) return pose;
  Pose hooded = pose;
  for (std::size_t i = 0; i < kMoveCount; ++i)
    if (comes_early(kMoves[i].area)) {
      double& value = hooded.values[i];
      value *= 1 + redraw.early * std::max(0.0, 1 - std::abs(value));
    }
  if (redraw.early != 0) add_sneer(kSneer * redraw.early, hooded);
  for (const Side side : {Side::left, Side::right}) {
    // Inner ends down alone are doubt, the whole brow down alone is thought: both together are anger.
    const double low = -0.5 * (get_value(pose, "brow", side, "up") + get_value(pose, "brow", side, "turn"));
    double& upper = hooded.values[*find_move("lid", side, "upper")];
    upper += redraw.lid_hood * std::clamp(low, 0.0, 1.0) * std::min(0.0, kShut - upper);
  }
  return hooded;
}

double compute_stretch(const Redraw& redraw, const Pose& pose) {
  if (redraw.jaw_stretch == 0 && redraw.brow_stretch == 0) return 0;
  const double brows =
      0.5 * (get_value(pose, "brow", Side::left, "up") + get_value(pose, "brow", Side::right, "up"));
  return std::clamp(
      redraw.jaw_stretch * get_value(pose, "chin", Side::none, "down") + redraw.brow_stretch * brows,
      -kMostSquash, kMostStretch);
}

double compute_most_stretch(const Redraw& redraw) {
  return std::min(kMostStretch, redraw.jaw_stretch + redraw.brow_stretch);
}

glm::dmat4 compute_stretching(const Redraw& redraw, double stretch) {
  glm::dmat4 matrix(1);
  matrix[0][0] = 1 - kThinner * stretch;
  matrix[1][1] = 1 + stretch;
  matrix[2][2] = 1 - kFlatter * stretch;
  matrix[3][1] = -redraw.floor_mm * stretch;
  return matrix;
}

glm::dvec3 redraw_point(const Redraw& redraw, double stretch, const glm::dvec3& point) {
  const glm::dvec3 bent = bend(redraw.lens, point);
  return stretch == 0 ? bent : stretch_point(redraw, stretch, bent);
}

void redraw_slots(const Redraw& redraw, double stretch, const Surface& surface, const Face& face,
                  const TurnKey& turn, std::vector<Twin>& places) {
  std::optional<TurnTable> table;
  if (is_turned(turn)) table.emplace(face, turn);
  const auto place = [&](Float4& slot, double share) {
    glm::dvec3 p = redraw_point(redraw, stretch, glm::dvec3(unpack(slot)));
    if (table) p = table->turn(p, share);
    slot = pack(glm::vec3(p));
  };
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double share = redraw.turn_shares[surface.pairs[i].left];
    place(places[i].left, share);
    place(places[i].right, share);
  }
}

void redraw_part(const Redraw& redraw, double stretch, const Mesh& rest, const glm::dmat4& head_from_rest,
                 const glm::dmat4& turned, PartShape& shape) {
  constexpr double kStep_mm = 0.05;  // along the surface, to see how its normal turns
  const glm::dmat3 axes(head_from_rest), world(turned);
  const glm::dvec3 evenly(1 - kThinner * stretch, 1 + stretch, 1 - kFlatter * stretch);
  shape.positions.resize(rest.positions.size());
  shape.normals.resize(rest.positions.size());
  for (std::size_t i = 0; i < rest.positions.size(); ++i) {
    const glm::dvec3 p(head_from_rest * glm::dvec4(glm::dvec3(rest.positions[i]), 1));
    const glm::dvec3 normal = axes * glm::dvec3(rest.normals[i]);
    if (p.y >= redraw.chin_mm && bend(redraw.lens, p) == p) {  // out of its reach, and stretched evenly
      shape.positions[i] = glm::vec3(turned * glm::dvec4(stretch_point(redraw, stretch, p), 1));
      shape.normals[i] = glm::vec3(world * glm::normalize(normal / evenly));
      continue;
    }
    const glm::dvec3 aside = std::abs(normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 one = glm::normalize(glm::cross(aside, normal)), other = glm::cross(normal, one);
    const glm::dvec3 at = redraw_point(redraw, stretch, p);
    const auto along = [&](const glm::dvec3& way) {
      return redraw_point(redraw, stretch, p + kStep_mm * way) - at;
    };
    shape.positions[i] = glm::vec3(turned * glm::dvec4(at, 1));
    shape.normals[i] = glm::vec3(world * glm::normalize(glm::cross(along(one), along(other))));
  }
}

}  // namespace mien

#include "frames/move_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <tuple>

#include "core/pool.hpp"

namespace mien {

namespace {

bool is_left_out(const ShapeRequest& request, std::size_t vertex) {
  return !request.is_left_out.empty() && request.is_left_out[vertex];
}

MoveShape sample_shape(const PlaceVertices& place, std::size_t move, double value) {
  Pose pose;
  pose.values[move] = value;
  return {value, place(pose)};
}

struct Sampling {
  const PlaceVertices& place;
  const ShapeRequest& request;
  std::size_t move;
};

float compute_worst_mm(const ShapeRequest& request, const std::vector<glm::vec3>& truth,
                       const std::vector<glm::vec3>& told) {
  float worst = 0;
  for (std::size_t v = 0; v < truth.size(); ++v)
    if (!is_left_out(request, v)) worst = std::max(worst, glm::distance(truth[v], told[v]));
  return worst;
}

// Shapes between `low` and `high` (left out), so many that the straight way between them is near enough.
void halve(const Sampling& sampling, const MoveShape& low, const MoveShape& high, int depth,
           std::vector<MoveShape>& shapes) {
  if (depth == 0) return;
  MoveShape middle = sample_shape(sampling.place, sampling.move, 0.5 * (low.value + high.value));
  std::vector<glm::vec3> straight = low.positions;
  for (std::size_t v = 0; v < straight.size(); ++v)
    straight[v] = 0.5f * (low.positions[v] + high.positions[v]);
  if (compute_worst_mm(sampling.request, middle.positions, straight) <= sampling.request.tolerance_mm) return;
  halve(sampling, low, middle, depth - 1, shapes);
  shapes.push_back(middle);
  halve(sampling, middle, high, depth - 1, shapes);
}

std::vector<MoveShape> sample_shapes(const Sampling& sampling, const std::vector<glm::vec3>& neutral) {
  const MoveInfo& info = kMoves[sampling.move];
  const MoveShape rest{0, neutral};
  // A move of one end has as many shapes as one of two, or a sneer is off where its skin is stopped.
  const int depth = sampling.request.most_halvings + (info.low < 0 ? 0 : 1);
  std::vector<MoveShape> shapes;
  if (info.low < 0) {
    MoveShape low = sample_shape(sampling.place, sampling.move, info.low);
    shapes.push_back(low);
    halve(sampling, low, rest, depth, shapes);
  }
  MoveShape high = sample_shape(sampling.place, sampling.move, info.high);
  halve(sampling, rest, high, depth, shapes);
  shapes.push_back(std::move(high));
  return shapes;
}

JointTurn build_turn(const Figure& figure, std::size_t move, const glm::dvec3& axis, double plus_rad,
                     double minus_rad) {
  JointTurn turn{move, axis, plus_rad, minus_rad, compute_move_reach(figure, move, 1), 1, glm::dvec3(0)};
  if (kMoves[move].low < 0) turn.minus_reach = compute_move_reach(figure, move, -1);
  return turn;
}

std::vector<std::size_t> list_mounted(const Figure& figure, Mount mount) {
  std::vector<std::size_t> parts;
  for (std::size_t i = 0; i < figure.parts.size(); ++i)
    if (figure.parts[i].mount == mount) parts.push_back(i);
  return parts;
}

Joint build_eye_joint(const Figure& figure, Side side) {
  const bool is_left = side == Side::left;
  const Face& face = figure.face;
  Joint joint;
  joint.name = is_left ? "eye_left" : "eye_right";
  joint.pivot_mm = figure.head.eye.centre * glm::dvec3(is_left ? 1 : -1, 1, 1);
  joint.turns = {build_turn(figure, find_move(Area::eye, side, "side").value(), {0, 1, 0}, face.eye_side_rad,
                            face.eye_side_rad),
                 build_turn(figure, find_move(Area::eye, side, "up").value(), {-1, 0, 0}, face.eye_up_rad,
                            face.eye_down_rad)};
  joint.parts = list_mounted(figure, is_left ? Mount::eye_left : Mount::eye_right);
  return joint;
}

Joint build_jaw_joint(const Figure& figure) {
  const JawRig& jaw = figure.face.jaw;
  Joint joint;
  joint.name = "jaw";
  joint.pivot_mm = jaw.axis;
  joint.turns = {
      build_turn(figure, find_move(Area::chin, Side::none, "down").value(), {1, 0, 0}, jaw.open_rad, 0)};
  joint.turns.front().shift_mm = jaw.forward;
  for (const auto& [area, move, way] : {std::tuple{Area::jaw, "side", jaw.aside},
                                        {Area::jaw, "forward", jaw.protruded},
                                        {Area::lips, "roll_lower", jaw.rolled}}) {
    joint.turns.push_back(build_turn(figure, find_move(area, Side::none, move).value(), {1, 0, 0}, 0, 0));
    joint.turns.back().shift_mm = way;
  }
  joint.turns.push_back(
      build_turn(figure, find_move(Area::chin, Side::none, "straight").value(), {1, 0, 0}, 0, 0));
  joint.turns.back().shift_mm = {0, -jaw.straight_mm, 0};
  joint.turns.back().is_rest_of_first = true;
  joint.parts = list_mounted(figure, Mount::jaw);
  return joint;
}

}  // namespace

std::vector<MoveShapes> sample_move_shapes(const PlaceVertices& place, const std::vector<glm::vec3>& neutral,
                                           const ShapeRequest& request) {
  std::vector<MoveShapes> moves(kMoveCount);
  for_each_index(kMoveCount, count_workers(), [&](std::size_t m, int) {
    moves[m] = {m, sample_shapes({place, request, m}, neutral)};
  });
  return moves;
}

double compute_shape_weight(const std::vector<double>& values, std::size_t i, double value) {
  const double at = values[i];
  const double before = i > 0 && !(values[i - 1] < 0 && at > 0) ? values[i - 1] : (at > 0 ? 0 : at - 1);
  const double after =
      i + 1 < values.size() && !(at < 0 && values[i + 1] > 0) ? values[i + 1] : (at < 0 ? 0 : at + 1);
  return std::clamp(value <= at ? (value - before) / (at - before) : (after - value) / (after - at), 0.0,
                    1.0);
}

std::vector<double> list_shape_values(const MoveShapes& move) {
  std::vector<double> values;
  for (const MoveShape& shape : move.shapes) values.push_back(shape.value);
  return values;
}

std::vector<glm::vec3> blend_shapes(const std::vector<glm::vec3>& neutral, const MoveShapes& move,
                                    double value) {
  const std::vector<double> values = list_shape_values(move);
  for (const MoveShape& shape : move.shapes)
    if (shape.value == value) return shape.positions;
  std::vector<glm::vec3> blended = neutral;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto weight = static_cast<float>(compute_shape_weight(values, i, value));
    if (weight == 0) continue;
    const std::vector<glm::vec3>& positions = move.shapes[i].positions;
    for (std::size_t v = 0; v < blended.size(); ++v) blended[v] += weight * (positions[v] - neutral[v]);
  }
  return blended;
}

VertexOffsets compute_offsets(const std::vector<glm::vec3>& from, const std::vector<glm::vec3>& to,
                              const std::vector<double>& slight_mm) {
  VertexOffsets found;
  for (std::uint32_t v = 0; v < from.size(); ++v) {
    const glm::vec3 offset = to[v] - from[v];
    if (glm::length(offset) <= slight_mm[v]) continue;
    found.vertices.push_back(v);
    found.offsets.push_back(offset);
  }
  return found;
}

double measure_between_mm(const PlaceVertices& place, const std::vector<glm::vec3>& neutral,
                          const MoveShapes& move, const ShapeRequest& request, int steps) {
  std::vector<double> values = list_shape_values(move);
  values.insert(std::upper_bound(values.begin(), values.end(), 0.0), 0.0);
  float worst = 0;
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    for (int step = 1; step < steps; ++step) {
      const double value = std::lerp(values[i], values[i + 1], double(step) / steps);
      worst = std::max(worst, compute_worst_mm(request, sample_shape(place, move.move, value).positions,
                                               blend_shapes(neutral, move, value)));
    }
  }
  return worst;
}

std::vector<BentPart> list_bent_parts(const Figure& figure) {
  std::vector<BentPart> parts;
  std::size_t first = 0;
  for (std::size_t i = 0; i < figure.model.parts.size(); ++i) {
    const Part& part = figure.model.parts[i];
    if (part.is_rigid) continue;
    parts.push_back({i, first, part.rest.positions.size()});
    first += part.rest.positions.size();
  }
  return parts;
}

PlaceVertices place_bent_parts(const Figure& figure, bool has_folds) {
  return [&figure, has_folds, parts = list_bent_parts(figure)](const Pose& pose) {
    DeformBuffers buffers;
    buffers.has_folds = has_folds;
    Drawing drawing;
    deform_figure(figure, pose, TurnKey{}, buffers, drawing);
    std::vector<glm::vec3> positions;
    for (const BentPart& bent : parts) {
      const std::vector<glm::vec3>& own = drawing.parts[bent.part].positions;
      positions.insert(positions.end(), own.begin(), own.end());
    }
    return positions;
  };
}

std::vector<Joint> list_joints(const Figure& figure) {
  return {build_eye_joint(figure, Side::left), build_eye_joint(figure, Side::right), build_jaw_joint(figure)};
}

double compute_move_reach(const Figure& figure, std::size_t move, int sign) {
  Pose pose;
  pose.values[move] = sign;
  return std::abs(apply_limits(figure.limits, pose).values[move]);
}

glm::dmat4 place_joint(const Joint& joint, const Pose& pose) {
  glm::dvec3 shift(0);
  glm::dmat4 turned(1);
  const auto find_value = [&](const JointTurn& turn) {
    const double asked = pose.values[turn.move];
    return asked * (asked > 0 ? turn.plus_reach : turn.minus_reach);
  };
  for (const JointTurn& turn : joint.turns) {
    const double room = turn.is_rest_of_first ? std::max(0.0, 1 - find_value(joint.turns.front())) : 1;
    const double value = room * find_value(turn);
    shift += value * turn.shift_mm;
    turned = glm::rotate(turned, value * (value > 0 ? turn.plus_rad : turn.minus_rad), turn.axis);
  }
  return glm::translate(glm::dmat4(1), joint.pivot_mm + shift) * turned *
         glm::translate(glm::dmat4(1), -joint.pivot_mm);
}

}  // namespace mien

#include "frames/bust_controls.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/pool.hpp"
#include "frames/move_shapes.hpp"

namespace mien {

namespace {

constexpr double kNothing_mm = 1e-4;  // below the decimals of any file

// What controls are built from and into.
struct Work {
  const BustBody& body;
  const Figure& figure;
  std::vector<bool> is_placed;  // by a patch's formula
  std::vector<bool> is_rim;     // what the formulas begin with: teeth's edges are so steep that slight counts
  PosableBust& controls;
  std::vector<std::vector<glm::vec3>> shapes;  // all that matters of what was sampled
};

using Shape = std::vector<glm::vec3>;

std::vector<bool> list_placed(const BustBody& body) {
  std::vector<bool> is_placed(body.kept.size(), false);
  for (const Patch* patch : {&body.eyes[0], &body.eyes[1], &body.mouth})
    std::fill_n(is_placed.begin() + patch->first, patch->vertex_count(), true);
  return is_placed;
}

std::vector<bool> list_rims(const BustBody& body) {
  std::vector<bool> is_rim(body.kept.size(), false);
  for (const Patch* patch : {&body.eyes[0], &body.eyes[1], &body.mouth})
    for (const std::vector<std::uint32_t>* rim : {&patch->upper, &patch->lower})
      for (const std::uint32_t v : *rim) is_rim[v] = true;
  return is_rim;
}

// What counts as nothing of each vertex: all of what a formula places; little beside its rims.
std::vector<double> list_slight_mm(const Work& work, double slight_mm) {
  std::vector<double> slight(work.is_placed.size(), slight_mm);
  for (std::size_t v = 0; v < slight.size(); ++v) {
    if (work.is_rim[v]) slight[v] = kNothing_mm;
    if (work.is_placed[v]) slight[v] = INFINITY;
  }
  return slight;
}

glm::vec2 compute_gaze_angles(const glm::dmat3& gaze) {
  const glm::dvec3 to = gaze * glm::dvec3(0, 0, 1);
  return {std::atan2(to.x, to.z), std::asin(std::clamp(to.y, -1.0, 1.0))};
}

std::size_t add_state(Work& work, BustState state) {
  work.controls.states.push_back(std::move(state));
  return work.controls.states.size() - 1;
}

void add_moves(Work& work, double tolerance_mm) {
  ShapeRequest request;
  request.tolerance_mm = tolerance_mm;
  request.is_left_out = work.is_placed;
  const PlaceVertices place = [&](const Pose& pose) { return place_straight(work.body, work.figure, pose); };
  const std::vector<double> nothing = list_slight_mm(work, kNothing_mm);
  for (MoveShapes& sampled : sample_move_shapes(place, work.controls.rest, request)) {
    BustMove& move = work.controls.moves.emplace_back();
    const MoveInfo& info = kMoves[sampled.move];
    move.area = std::string(info.area);
    if (info.side != Side::none) move.area += info.side == Side::left ? ".left" : ".right";
    move.move = std::string(info.move);
    move.meaning = std::string(info.meaning);
    move.low = info.low;
    move.high = info.high;
    for (const MoveShape& shape : sampled.shapes) {
      move.values.push_back(shape.value);
      move.states.push_back(add_state(work, compute_offsets(work.controls.rest, shape.positions, nothing)));
    }
    if (info.low < 0) work.shapes.push_back(std::move(sampled.shapes.front().positions));
    work.shapes.push_back(std::move(sampled.shapes.back().positions));
    move.has_slider = info.of != Area::tongue;  // a mound behind the lips
    move.reach_high = compute_move_reach(work.figure, sampled.move, 1);
    move.reach_low = info.low < 0 ? compute_move_reach(work.figure, sampled.move, -1) : 1;
  }
}

void add_expressions(Work& work, const std::vector<NamedPose>& expressions, double slight_mm) {
  std::vector<BustState> states(expressions.size());
  std::vector<BustExpression> added(expressions.size());
  std::vector<Shape> shapes(expressions.size());
  const std::vector<double> slight = list_slight_mm(work, slight_mm);
  for_each_index(expressions.size(), count_workers(), [&](std::size_t i, int) {
    const Pose& pose = expressions[i].pose;
    BustExpression& expression = added[i];
    expression.name = expressions[i].name;
    for (std::size_t m = 0; m < kMoveCount; ++m)
      expression.values.push_back(std::clamp(pose.values[m], kMoves[m].low, kMoves[m].high));
    const Shape sum = sum_bust_states(work.controls, expression.values);
    shapes[i] = place_straight(work.body, work.figure, pose);
    states[i] = compute_offsets(sum, shapes[i], slight);
    const Pose held = limit_pose(work.figure, pose);
    const std::size_t chin = find_move(Area::chin, Side::none, "down").value();
    expression.open = stiffen_pose(work.figure.face, held).values[chin];
    for (const Side side : {Side::left, Side::right})
      expression.gaze_rad[side == Side::left ? 0 : 1] =
          compute_gaze_angles(compute_gaze(work.figure.face, held, side));
  });
  for (std::size_t i = 0; i < expressions.size(); ++i) {
    added[i].state = add_state(work, std::move(states[i]));
    work.shapes.push_back(std::move(shapes[i]));
    work.controls.expressions.push_back(std::move(added[i]));
  }
}

// From the head's space to the print's, without the shift.
glm::vec3 turn_upright(const glm::vec3& p) { return {p.x, -p.z, p.y}; }

BustGrid compute_grid(const Patch& patch) { return {patch.upper, patch.lower, patch.first, kPatchRows}; }

BustEye compute_eye(const BustBody& body, std::size_t i) {
  const CarvedEye& eye = body.carved[i];
  const double scale = body.print_per_head;
  return {compute_grid(body.eyes[i]),
          turn_upright(eye.centre - body.origin) * body.print_per_head,
          eye.radius_mm * scale,
          eye.iris_mm * scale,
          eye.iris_depth_mm * scale,
          eye.pupil_depth_mm * scale,
          eye.slit_mm * scale,
          eye.line_mm * scale,
          eye.light};
}

BustMouth compute_mouth(const BustBody& body, const Joint& jaw) {
  const float scale = body.print_per_head;
  const CarvedMouth& carved = body.carved_mouth;
  const glm::vec2 origin(body.origin.y, body.origin.z);
  BustMouth mouth;
  mouth.grid = compute_grid(body.mouth);
  mouth.reach_mm = kToothReach_mm * scale;
  const auto list = [&](const std::array<glm::vec2, kToothSamples>& row) {
    std::vector<glm::vec2> points;
    for (const glm::vec2& p : row)
      points.push_back(p.y == kNoTooth_mm ? glm::vec2(0, kNoTooth_mm) : (p - origin) * scale);
    return points;
  };
  mouth.upper_edge = list(carved.upper.edge);
  mouth.upper_front = list(carved.upper.front);
  mouth.lower_edge = list(carved.lower.edge);
  mouth.lower_front = list(carved.lower.front);
  mouth.tongue = turn_upright(carved.tongue.centre - body.origin) * scale;
  const glm::vec3 radius = carved.tongue.radius * scale;
  mouth.tongue_radius = {radius.x, radius.z, radius.y};
  mouth.line_mm = carved.line_mm * scale;
  const JointTurn& open = jaw.turns.front();
  mouth.jaw_axis = (glm::vec2(float(jaw.pivot_mm.y), float(jaw.pivot_mm.z)) - origin) * scale;
  mouth.jaw_open_rad = open.plus_rad;
  mouth.jaw_forward = glm::vec2(float(open.shift_mm.y), float(open.shift_mm.z)) * scale;
  return mouth;
}

BustLens compute_lens(const BustBody& body) {
  const Lens& lens = body.lens;
  const glm::dvec3 middle = (lens.centre - glm::dvec3(body.origin)) * double(body.print_per_head);
  return {{middle.x, -middle.z, middle.y},
          lens.radius_mm * body.print_per_head,
          lens.taller,
          lens.full,
          lens.end,
          lens.flat,
          true};
}

}  // namespace

std::vector<glm::vec3> sum_bust_states(const PosableBust& controls, const std::vector<double>& values) {
  std::vector<glm::vec3> sum = controls.rest;
  const auto add = [&](std::size_t state, double weight) {
    const BustState& s = controls.states[state];
    for (std::size_t i = 0; i < s.vertices.size(); ++i) sum[s.vertices[i]] += s.offsets[i] * float(weight);
  };
  for (std::size_t m = 0; m < kMoveCount; ++m) {
    const double value = values[m];
    const BustMove& move = controls.moves[m];
    if (value == 0) continue;
    for (std::size_t i = 0; i < move.values.size(); ++i)
      if (const double weight = compute_shape_weight(move.values, i, value); weight > 0)
        add(move.states[i], weight);
  }
  return sum;
}

std::vector<Shape> add_bust_controls(const BustBody& body, const Figure& figure,
                                     const std::vector<NamedPose>& expressions, double tolerance_mm,
                                     double slight_mm, PosableBust& bust) {
  Work work{body, figure, list_placed(body), list_rims(body), bust, {}};
  bust.triangles = body.triangles;
  bust.foot = body.foot;
  bust.mm_per_head_mm = body.print_per_head;
  bust.rest = place_straight(body, figure, Pose{});
  work.shapes.push_back(bust.rest);
  add_moves(work, tolerance_mm);
  add_expressions(work, expressions, slight_mm);
  const Stand other = body.stand == Stand::foot ? Stand::flat : Stand::foot;
  Shape shape = place_straight(body, figure, Pose{}, other);
  bust.other_stand = add_state(work, compute_offsets(bust.rest, shape, list_slight_mm(work, kNothing_mm)));
  bust.other_foot_mm = shape[body.foot.front()].z;
  work.shapes.push_back(std::move(shape));
  for (std::size_t i = 0; i < 2; ++i) bust.eyes[i] = compute_eye(body, i);
  const std::vector<Joint> joints = list_joints(figure);  // both eyes' limits are the same
  const JointTurn &side = joints[kLeftEyeJoint].turns[kSideTurn], &up = joints[kLeftEyeJoint].turns[kUpTurn];
  bust.mouth = compute_mouth(body, joints[kJawJoint]);
  bust.gaze_side_rad = side.plus_rad;
  bust.gaze_up_rad = up.plus_rad;
  bust.gaze_down_rad = up.minus_rad;
  if (body.lens.is_on()) bust.lens = compute_lens(body);
  for (Shape& one : work.shapes) bend_print(body, one);
  return std::move(work.shapes);
}

}  // namespace mien

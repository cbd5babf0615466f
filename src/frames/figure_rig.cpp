#include "frames/figure_rig.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numeric>

#include "head/surface.hpp"
#include "timeline/head_turn.hpp"

namespace mien {

namespace {

constexpr std::array kFaceMounts{Mount::eye_left, Mount::eye_right, Mount::jaw};  // as list_joints has them
constexpr float kSlight_mm = 0.01f;  // no offset is written for less

RigJoint build_neck_joint(int step, int steps, const glm::dvec3& pivot) {
  std::string name = step == 0 ? "shoulders" : step == steps ? "head" : "neck";
  if (name == "neck" && steps > 2) name += fmt::format("_{}", step);
  return {name, step - 1, pivot};
}

JointShare share_neck(float share, int steps) {
  const float at = std::clamp(share, 0.0f, 1.0f) * static_cast<float>(steps);
  const int step = std::min(static_cast<int>(at), steps - 1);
  return {static_cast<std::uint8_t>(step), static_cast<std::uint8_t>(step + 1),
          at - static_cast<float>(step)};
}

// How much of the head's turn each vertex of the skin takes: those that are added for fine relief, too.
std::vector<float> spread_turn(const Figure& figure) {
  std::vector<float> shares = spread_over_surface(*figure.head.surface, figure.face.turn_weights);
  for (const auto& [a, b] : figure.folds.skin.parents) shares.push_back(0.5f * (shares[a] + shares[b]));
  return shares;
}

// Hairs go with the place that they stand on.
std::vector<JointShare> share_strands(const Figure& figure, const HeadPart& bound, std::size_t count,
                                      const std::vector<float>& skin, int steps) {
  std::vector<JointShare> shares(count, share_neck(1, steps));
  for (const Binding& binding : bound.bindings) {
    const Triangle& triangle = figure.head.skin.triangles[binding.triangle];
    float share = 0;
    for (int k = 0; k < 3; ++k) share += binding.barycentric[k] * skin[triangle[k]];
    std::fill_n(shares.begin() + binding.first, binding.count, share_neck(share, steps));
  }
  return shares;
}

void build_rig_parts(const Figure& figure, int steps, FigureRig& built) {
  const std::vector<float> skin = spread_turn(figure);
  for (std::size_t i = 0; i < figure.parts.size(); ++i) {
    const HeadPart& bound = figure.parts[i];
    const Part& part = figure.model.parts[i];
    RigPart& rigged = built.rig.parts.emplace_back();
    const auto mount = std::ranges::find(kFaceMounts, bound.mount);
    rigged.joint = built.head_joint;
    if (mount != kFaceMounts.end()) rigged.joint += 1 + static_cast<int>(mount - kFaceMounts.begin());
    // A design squashes and stretches what is rigid otherwise.
    const bool is_bent = !part.is_rigid || part.may_bend || figure.redraw.is_on() ||
                         (!built.has_jaw && bound.mount == Mount::jaw);
    if (!is_bent) continue;
    const std::size_t count = part.rest.positions.size();
    if (part.is_rigid && part.may_bend && built.has_jaw) {  // the tongue bends where its joint has it
      const auto joint = static_cast<std::uint8_t>(rigged.joint);
      rigged.shares.assign(count, {joint, joint, 0});
      continue;
    }
    if (bound.mount == Mount::skin)
      for (const float share : skin) rigged.shares.push_back(share_neck(share, steps));
    else if (bound.mount == Mount::strands)
      rigged.shares = share_strands(figure, bound, count, skin, steps);
    else
      rigged.shares.assign(count, share_neck(1, steps));
  }
}

// Offsets of the normals that a target gives to the part's own triangles.
std::vector<glm::vec3> compute_normal_offsets(const Part& part, const std::vector<glm::vec3>& from,
                                              const VertexOffsets& places) {
  Mesh mesh{part.rest.positions, {}, part.rest.triangles};
  for (std::size_t i = 0; i < places.vertices.size(); ++i)
    mesh.positions[places.vertices[i]] += places.offsets[i];
  update_normals(mesh);
  std::vector<glm::vec3> normals;
  for (const std::uint32_t v : places.vertices) normals.push_back(mesh.normals[v] - from[v]);
  return normals;
}

void add_target(const Figure& figure, const std::vector<BentPart>& bent,
                const std::vector<glm::vec3>& plain_normals, const std::vector<glm::vec3>& neutral,
                const std::vector<glm::vec3>& shape, bool is_pose, Rig& rig) {
  const std::size_t name = rig.targets.size() - 1;
  for (const BentPart& own : bent) {
    RigTarget target{name, {}, {}};
    for (std::uint32_t v = 0; v < own.count; ++v) {
      const glm::vec3 offset = shape[own.first + v] - neutral[own.first + v];
      if (glm::length(offset) <= kSlight_mm) continue;
      target.places.vertices.push_back(v);
      target.places.offsets.push_back(offset);
    }
    // A pose that nothing here does is on the skin all the same: programs look for its name.
    if (target.places.vertices.empty() && own.part == 0 && is_pose) target.places = {{0}, {glm::vec3(0)}};
    if (target.places.vertices.empty()) continue;
    if (own.part == 0)
      target.normals = compute_normal_offsets(figure.model.parts[0], plain_normals, target.places);
    rig.parts[own.part].targets.push_back(std::move(target));
  }
}

std::vector<glm::vec3> compute_plain_normals(const Part& part) {
  Mesh mesh{part.rest.positions, {}, part.rest.triangles};
  update_normals(mesh);
  return mesh.normals;
}

// What the tongue does in an open mouth, freed of the jaw that carries it: in a shut one it stays where it
// is.
void add_tongue_target(const Figure& figure, std::size_t move, double value, Rig& rig) {
  constexpr double kOpen = 0.6;  // of the jaw's way
  if (kMoves[move].of != Area::tongue) return;
  Pose pose;
  pose.values[move] = value;
  pose.values[find_move(Area::chin, Side::none, "down").value()] = kOpen;
  DeformBuffers buffers;
  Drawing drawing;
  deform_figure(figure, pose, TurnKey{}, buffers, drawing);
  for (std::size_t i = 0; i < figure.model.parts.size(); ++i) {
    const Part& part = figure.model.parts[i];
    const PartShape& shape = drawing.parts[i];
    if (!part.may_bend || is_carried(part, shape)) continue;
    const glm::dmat4 rest_from_world = glm::inverse(glm::dmat4(shape.world_from_rest));
    RigTarget target{rig.targets.size() - 1, {}, {}};
    for (std::uint32_t v = 0; v < shape.positions.size(); ++v) {
      const glm::vec3 offset =
          glm::vec3(rest_from_world * glm::dvec4(shape.positions[v], 1)) - part.rest.positions[v];
      if (glm::length(offset) <= kSlight_mm) continue;
      target.places.vertices.push_back(v);
      target.places.offsets.push_back(offset);
    }
    if (!target.places.vertices.empty()) rig.parts[i].targets.push_back(std::move(target));
  }
}

void add_move_targets(const Figure& figure, const FigureRigRequest& request, FigureRig& built) {
  if (!request.has_moves || !request.poses.empty()) return;
  const PlaceVertices place = place_bent_parts(figure, true);
  const std::vector<glm::vec3> neutral = place(Pose{});
  const std::vector<BentPart> bent = list_bent_parts(figure);
  const std::vector<glm::vec3> normals = compute_plain_normals(figure.model.parts[0]);
  built.moves = sample_move_shapes(place, neutral, request.shapes);
  for (MoveShapes& move : built.moves) {
    built.first_target.push_back(built.rig.targets.size());
    for (MoveShape& shape : move.shapes) {
      built.rig.targets.push_back(name_move_target(move.move, shape.value));
      add_target(figure, bent, normals, neutral, shape.positions, false, built.rig);
      add_tongue_target(figure, move.move, shape.value, built.rig);
      shape.positions = {};
    }
  }
}

void add_pose_targets(const Figure& figure, const std::vector<TargetPose>& poses, FigureRig& built) {
  if (poses.empty()) return;
  const std::vector<BentPart> bent = list_rig_bent_parts(built, figure.model);
  const auto place = [&](const Pose& pose) {
    DeformBuffers buffers;
    Drawing drawing;
    deform_figure(figure, pose, TurnKey{}, buffers, drawing);
    return list_bent_places(bent, figure.model, drawing);
  };
  const std::vector<glm::vec3> neutral = place(Pose{});
  const std::vector<glm::vec3> normals = compute_plain_normals(figure.model.parts[0]);
  for (const TargetPose& target : poses) {
    built.rig.targets.push_back(target.name);
    add_target(figure, bent, normals, neutral, place(target.pose), true, built.rig);
  }
  built.poses = poses;
}

double dot_poses(const Pose& a, const Pose& b) {
  return std::inner_product(a.values.begin(), a.values.end(), b.values.begin(), 0.0);
}

}  // namespace

std::string name_move_target(std::size_t move, double value) {
  const MoveInfo& info = kMoves[move];
  std::string name = name_way(move, value);
  if (const double end = value > 0 ? info.high : info.low; value != end)
    name += fmt::format("@{:g}", std::round(1e4 * value / end) / 100);
  return name;
}

FigureRig build_figure_rig(const Figure& figure, const FigureRigRequest& request) {
  FigureRig built;
  built.head_joint = request.neck_steps;
  built.has_jaw = request.poses.empty();
  for (int step = 0; step <= request.neck_steps; ++step)
    built.rig.joints.push_back(build_neck_joint(step, request.neck_steps, figure.face.turn_pivot));
  for (const Joint& joint : list_joints(figure))
    built.rig.joints.push_back({joint.name, built.head_joint, joint.pivot_mm});
  build_rig_parts(figure, request.neck_steps, built);
  add_move_targets(figure, request, built);
  add_pose_targets(figure, request.poses, built);
  return built;
}

// The shares of poses, 0 to 1, whose sum is nearest to `pose`: coordinate descent on the least squares, with
// a slight cost for shares, so that there is one answer and it changes steadily with the pose.
std::vector<double> share_poses(const std::vector<TargetPose>& poses, const Pose& pose) {
  constexpr int kRounds = 200;
  constexpr double kCost = 1e-5;
  std::vector<double> shares(poses.size(), 0);
  Pose left = pose;
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const double square = dot_poses(poses[i].pose, poses[i].pose);
      if (square == 0) continue;
      const double asked = (dot_poses(left, poses[i].pose) + shares[i] * square) / (square + kCost);
      const double share = std::clamp(asked, 0.0, 1.0);
      for (std::size_t m = 0; m < kChannelCount; ++m)
        left.values[m] -= (share - shares[i]) * poses[i].pose.values[m];
      shares[i] = share;
    }
  }
  return shares;
}

double measure_unshared(const std::vector<TargetPose>& poses, const Pose& pose) {
  const std::vector<double> shares = share_poses(poses, pose);
  double worst = 0;
  for (std::size_t m = 0; m < kChannelCount; ++m) {
    double left = pose.values[m];
    for (std::size_t i = 0; i < poses.size(); ++i) left -= shares[i] * poses[i].pose.values[m];
    worst = std::max(worst, std::abs(left));
  }
  return worst;
}

std::vector<float> compute_target_weights(const FigureRig& rig, const Pose& pose) {
  std::vector<float> weights(rig.rig.targets.size(), 0);
  for (const MoveShapes& move : rig.moves) {
    const double value = pose.values[move.move];
    if (value == 0) continue;
    const std::vector<double> values = list_shape_values(move);
    for (std::size_t i = 0; i < values.size(); ++i)
      weights[rig.first_target[move.move] + i] = static_cast<float>(compute_shape_weight(values, i, value));
  }
  const std::vector<double> shares = share_poses(rig.poses, pose);
  for (std::size_t i = 0; i < shares.size(); ++i) weights[i] = static_cast<float>(shares[i]);
  return weights;
}

std::vector<JointPlace> place_joints(const FigureRig& rig, const Figure& figure, const Pose& pose,
                                     const TurnKey& turn) {
  std::vector<glm::dmat4> worlds;  // of the joints themselves
  std::vector<JointPlace> places;
  for (int j = 0; j < static_cast<int>(rig.rig.joints.size()); ++j) {
    const RigJoint& joint = rig.rig.joints[j];
    glm::dmat4 world = compute_turn(figure.face.turn_pivot, turn, std::min(1.0, double(j) / rig.head_joint));
    if (j > rig.head_joint) {
      const Mount mount = kFaceMounts[j - rig.head_joint - 1];
      if (mount != Mount::jaw || rig.has_jaw) world = world * compute_motion(figure, mount, pose);
    }
    worlds.push_back(glm::translate(world, joint.at_mm));
    const glm::dmat4 own = joint.parent < 0 ? worlds[j] : glm::inverse(worlds[joint.parent]) * worlds[j];
    places.push_back({glm::normalize(glm::quat_cast(glm::dmat3(own))), glm::dvec3(own[3])});
  }
  return places;
}

std::vector<BentPart> list_rig_bent_parts(const FigureRig& rig, const Model& model) {
  std::vector<BentPart> parts;
  std::size_t first = 0;
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    if (rig.rig.parts[i].shares.empty()) continue;
    parts.push_back({i, first, model.parts[i].rest.positions.size()});
    first += parts.back().count;
  }
  return parts;
}

std::vector<glm::vec3> list_bent_places(const std::vector<BentPart>& bent, const Model& model,
                                        const Drawing& drawing) {
  std::vector<glm::vec3> places;
  places.reserve(bent.back().first + bent.back().count);
  for (const BentPart& own : bent) {
    const PartShape& shape = drawing.parts[own.part];
    const Part& part = model.parts[own.part];
    if (is_carried(part, shape))
      for (const glm::vec3& rest : part.rest.positions)
        places.emplace_back(shape.world_from_rest * glm::vec4(rest, 1));
    else
      places.insert(places.end(), shape.positions.begin(), shape.positions.end());
  }
  return places;
}

}  // namespace mien

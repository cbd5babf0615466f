// A figure as a rig: what deform_figure does, told as joints and targets for programs that have no face.
//
// Joints   "shoulders", the neck in steps up to the "head", and below it "eye_left", "eye_right" and "jaw".
//          The neck's steps stand in one place, the top of the neck: each turns by a share of the head's
//          angles, as the skin between chest and skull does.
// Targets  For each move of the areas one a way, by its limit's name: "brow.left.up", "brow.left.down"; of
//          ways that are not straight more on the way, "lid.left.shut@50" at half the value. Weights are
//          those of frames/move_shapes.hpp.
// Error    At a target's own value, of one move alone, that of the format's numbers. Moves that meet add up
//          here and push each other in the face: clip/rig_take.hpp adds targets that mend it.
#pragma once

#include "core/rig.hpp"
#include "frames/figure.hpp"
#include "frames/move_shapes.hpp"

namespace mien {

struct TargetPose {
  std::string name;
  Pose pose;
};

struct FigureRigRequest {
  ShapeRequest shapes;            // how near the straight ways between targets are to the face's own
  bool has_moves = true;          // targets of moves; false: none, but those of `poses`
  std::vector<TargetPose> poses;  // a target each; what the jaw carries bends with them, and its joint rests
  int neck_steps = 8;             // from the shoulders to the head
};

// A figure's rig, and what its targets are of.
struct FigureRig {
  Rig rig;
  int head_joint = 0;                     // behind it the face's: "eye_left", "eye_right", "jaw"
  bool has_jaw = true;                    // the jaw's joint turns
  std::vector<MoveShapes> moves;          // without their places
  std::vector<std::size_t> first_target;  // of each move, in the order of its shapes
  std::vector<TargetPose> poses;
};

// About a second.
FigureRig build_figure_rig(const Figure& figure, const FigureRigRequest& request);

// The weights of the targets in a pose: those of frames/move_shapes.hpp for moves; of poses the shares, 0 to
// 1, that come nearest to it together (least squares). Targets behind them get 0.
std::vector<float> compute_target_weights(const FigureRig& rig, const Pose& pose);

// The shares, 0 to 1, of poses whose sum is nearest to `pose`; and how much of a move it misses at worst.
std::vector<double> share_poses(const std::vector<TargetPose>& poses, const Pose& pose);
double measure_unshared(const std::vector<TargetPose>& poses, const Pose& pose);

// Where the joints are in a pose and a turn of the head.
std::vector<JointPlace> place_joints(const FigureRig& rig, const Figure& figure, const Pose& pose,
                                     const TurnKey& turn);

// The parts that the rig bends, one behind the other, and where a drawing has all their vertices.
std::vector<BentPart> list_rig_bent_parts(const FigureRig& rig, const Model& model);
std::vector<glm::vec3> list_bent_places(const std::vector<BentPart>& bent, const Model& model,
                                        const Drawing& drawing);

// What a target is called: "lid.left.shut@50".
std::string name_move_target(std::size_t move, double value);

}  // namespace mien

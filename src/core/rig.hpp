// A model that poses itself in programs that know no face of ours: joints to turn, targets to blend, and what
// both do in time. Millimetres, right-handed: x to the character's left, y up, z forward.
//
// A vertex of a bent part lies at   sum over its joints of share x joint x (rest + sum of weight x target's
// offset), a joint being what it does to the rest's space; a rigid part goes with one joint. That is "linear
// blend skinning after morph targets", as glTF 2.0, USD and game engines have it.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <vector>

#include "core/model.hpp"
#include "core/offsets.hpp"

namespace mien {

struct RigJoint {
  std::string name;     // a lower-case identifier
  int parent = -1;      // before it in the list; -1: the stage
  glm::dvec3 at_mm{0};  // at rest, in the world; nothing is turned at rest
};

// Which of two joints carries a vertex: the second by `share`, the first by the rest.
struct JointShare {
  std::uint8_t first = 0, second = 0;
  float share = 0;
};

struct RigTarget {
  std::size_t name = 0;            // in Rig::targets
  VertexOffsets places;            // of the part's vertices at weight 1
  std::vector<glm::vec3> normals;  // offsets of the same vertices' normals; or empty
};

struct RigPart {
  int joint = 0;                   // of a rigid part
  std::vector<JointShare> shares;  // of a bent one, one a vertex; empty: it is rigid
  std::vector<RigTarget> targets;  // those that move it
};

struct Rig {
  std::vector<RigJoint> joints;
  std::vector<std::string> targets;  // names
  std::vector<RigPart> parts;        // in the order of Model::parts
};

// A joint in its parent's space.
struct JointPlace {
  glm::dquat turn{1, 0, 0, 0};
  glm::dvec3 at_mm{0};
};

struct RigPose {
  std::vector<JointPlace> joints;  // in the order of Rig::joints
  std::vector<float> weights;      // in the order of Rig::targets
};

// Between two times joints turn the shorter way (slerp), and all else goes straight.
struct RigTake {
  std::vector<double> times_s;  // rising
  std::vector<RigPose> poses;   // one a time
};

RigPose blend_poses(const RigPose& from, const RigPose& to, double share);

// What each joint does to the rest's space: world from rest.
std::vector<glm::dmat4> compute_joint_worlds(const Rig& rig, const RigPose& pose);

// Where the vertices of a part lie. `rest` are those of the model's part.
std::vector<glm::vec3> place_rig_part(const RigPart& part, const std::vector<glm::vec3>& rest,
                                      const std::vector<float>& weights,
                                      const std::vector<glm::dmat4>& worlds);

// Linear blend skinning of one vertex: world from rest.
glm::dmat4 blend_joints(const JointShare& share, const std::vector<glm::dmat4>& worlds);

}  // namespace mien

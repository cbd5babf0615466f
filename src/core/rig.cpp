#include "core/rig.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace mien {

RigPose blend_poses(const RigPose& from, const RigPose& to, double share) {
  RigPose pose = from;
  for (std::size_t j = 0; j < pose.joints.size(); ++j) {
    pose.joints[j].turn = glm::slerp(from.joints[j].turn, to.joints[j].turn, share);
    pose.joints[j].at_mm = glm::mix(from.joints[j].at_mm, to.joints[j].at_mm, share);
  }
  for (std::size_t t = 0; t < pose.weights.size(); ++t)
    pose.weights[t] += static_cast<float>(share) * (to.weights[t] - from.weights[t]);
  return pose;
}

std::vector<glm::dmat4> compute_joint_worlds(const Rig& rig, const RigPose& pose) {
  std::vector<glm::dmat4> worlds;
  for (std::size_t j = 0; j < rig.joints.size(); ++j) {
    const JointPlace& place = pose.joints[j];
    const glm::dmat4 own = glm::translate(glm::dmat4(1), place.at_mm) * glm::mat4_cast(place.turn);
    const int parent = rig.joints[j].parent;
    worlds.push_back(parent < 0 ? own : worlds[parent] * own);
  }
  for (std::size_t j = 0; j < rig.joints.size(); ++j)
    worlds[j] = glm::translate(worlds[j], -rig.joints[j].at_mm);
  return worlds;
}

glm::dmat4 blend_joints(const JointShare& share, const std::vector<glm::dmat4>& worlds) {
  if (share.share == 0) return worlds[share.first];
  return worlds[share.first] * (1.0 - share.share) + worlds[share.second] * double(share.share);
}

std::vector<glm::vec3> place_rig_part(const RigPart& part, const std::vector<glm::vec3>& rest,
                                      const std::vector<float>& weights,
                                      const std::vector<glm::dmat4>& worlds) {
  std::vector<glm::vec3> places = rest;
  for (const RigTarget& target : part.targets) {
    const float weight = weights[target.name];
    if (weight == 0) continue;
    for (std::size_t i = 0; i < target.places.vertices.size(); ++i)
      places[target.places.vertices[i]] += weight * target.places.offsets[i];
  }
  for (std::size_t v = 0; v < places.size(); ++v) {
    const glm::dvec4 place(places[v], 1);
    places[v] =
        part.shares.empty() ? worlds[part.joint] * place : blend_joints(part.shares[v], worlds) * place;
  }
  return places;
}

}  // namespace mien

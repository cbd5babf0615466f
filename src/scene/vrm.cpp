// Sources: VRMC_vrm-1.0 (meta, humanoid, expressions, lookAt), VRM Consortium; a body's proportions after
// Loomis' figure of eight heads, here about 7.
#include "scene/vrm.hpp"

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "scene/gltf_buffer.hpp"
#include "scene/gltf_model.hpp"
#include "scene/title.hpp"

namespace mien {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kLicence = "https://vrm.dev/licenses/1.0/";

// A bone without a body, mm from the top of the neck: x to the character's left, y up.
struct BareBone {
  const char* name;
  const char* parent;  // before it; empty: the stage
  glm::dvec3 at_mm;
};

// The arms stand out to the sides, as the format wants a body at rest.
constexpr double kHipsHeight_mm = 900;
const std::array kBareBones{
    BareBone{"hips", "", {0, -560, -20}},
    BareBone{"spine", "hips", {0, -430, -25}},
    BareBone{"chest", "spine", {0, -250, -25}},
    BareBone{"leftUpperArm", "chest", {170, -90, -20}},
    BareBone{"leftLowerArm", "leftUpperArm", {440, -90, -20}},
    BareBone{"leftHand", "leftLowerArm", {690, -90, -20}},
    BareBone{"rightUpperArm", "chest", {-170, -90, -20}},
    BareBone{"rightLowerArm", "rightUpperArm", {-440, -90, -20}},
    BareBone{"rightHand", "rightLowerArm", {-690, -90, -20}},
    BareBone{"leftUpperLeg", "hips", {90, -600, -20}},
    BareBone{"leftLowerLeg", "leftUpperLeg", {90, -1010, -20}},
    BareBone{"leftFoot", "leftLowerLeg", {90, -1400, -20}},
    BareBone{"rightUpperLeg", "hips", {-90, -600, -20}},
    BareBone{"rightLowerLeg", "rightUpperLeg", {-90, -1010, -20}},
    BareBone{"rightFoot", "rightLowerLeg", {-90, -1400, -20}},
};

struct FaceBone {
  const char* name;   // in VRM
  const char* joint;  // of the rig
};
constexpr std::array kFaceBones{FaceBone{"neck", "neck"}, FaceBone{"head", "head"},
                                FaceBone{"leftEye", "eye_left"}, FaceBone{"rightEye", "eye_right"},
                                FaceBone{"jaw", "jaw"}};

// Feelings move lids and lips too: what an application adds there gives way as far as they are shown.
constexpr std::array kFeelings{"happy", "angry", "sad", "relaxed", "surprised"};

std::size_t find_joint(const Rig& rig, const char* name) {
  const auto found = std::ranges::find(rig.joints, name, &RigJoint::name);
  if (found == rig.joints.end()) throw RunError("internal: a rig without a joint that VRM needs");
  return found - rig.joints.begin();
}

void set_translation(tinygltf::Node& node, const glm::dvec3& at_mm) {
  node.translation = {at_mm.x / 1000, at_mm.y / 1000, at_mm.z / 1000};
}

// Adds the bare bones above the rig's joints; the nodes of all bones by VRM's names.
Json add_bones(const VrmScene& scene, GltfModel& built) {
  tinygltf::Model& model = built.model;
  const std::size_t shoulders = find_joint(scene.rig, "shoulders");
  const int top = built.first_joint + static_cast<int>(shoulders);
  std::erase(model.scenes[0].nodes, top);
  Json bones;
  std::map<std::string, glm::dvec3> places;
  for (const BareBone& bone : kBareBones) {
    const std::string parent = bone.parent;
    tinygltf::Node node;
    node.name = bone.name;
    // Feet stand on the ground, which is the stage's.
    set_translation(node, parent.empty() ? glm::dvec3(0, kHipsHeight_mm, 0) : bone.at_mm - places[parent]);
    const int self = static_cast<int>(model.nodes.size());
    model.nodes.push_back(node);
    places[bone.name] = bone.at_mm;
    bones[bone.name] = {{"node", self}};
    if (parent.empty())
      model.scenes[0].nodes.push_back(self);
    else
      model.nodes[bones[parent]["node"].get<int>()].children.push_back(self);
  }
  set_translation(model.nodes[top], -places["chest"]);
  model.nodes[bones["chest"]["node"].get<int>()].children.push_back(top);
  for (const FaceBone& bone : kFaceBones)
    bones[bone.name] = {{"node", built.first_joint + static_cast<int>(find_joint(scene.rig, bone.joint))}};
  return bones;
}

Json build_expression(const VrmScene& scene, const GltfModel& built, std::size_t name) {
  Json binds = Json::array();
  for (std::size_t i = 0; i < scene.rig.parts.size(); ++i) {
    const std::vector<RigTarget>& targets = scene.rig.parts[i].targets;
    const auto found = std::ranges::find(targets, name, &RigTarget::name);
    if (found == targets.end() || built.node_of_part[i] < 0) continue;
    binds.push_back({{"node", built.node_of_part[i]}, {"index", found - targets.begin()}, {"weight", 1.0}});
  }
  const bool is_feeling = std::ranges::find(kFeelings, scene.rig.targets[name]) != kFeelings.end();
  const char* rule = is_feeling ? "blend" : "none";
  return {{"morphTargetBinds", binds},
          {"isBinary", false},
          {"overrideBlink", rule},
          {"overrideLookAt", "none"},
          {"overrideMouth", rule}};
}

Json build_meta(const VrmScene& scene) {
  const std::string author = clean_title(scene.author), licence = clean_title(scene.licence);
  Json meta{{"name", clean_title(scene.title)}, {"version", "1"}};
  meta["authors"] = Json::array({author.empty() ? "unknown" : author});
  if (licence.starts_with("http"))
    meta["otherLicenseUrl"] = licence;
  else if (!licence.empty())
    meta["copyrightInformation"] = licence;
  meta["licenseUrl"] = kLicence;
  return meta;
}

Json build_look_at(const VrmScene& scene) {
  const glm::dvec3 head = scene.rig.joints[find_joint(scene.rig, "head")].at_mm;
  const glm::dvec3 offset = (scene.eyes_mm - head) / 1000.0;
  constexpr double kAll_deg = 90;
  const auto map = [&](double most_deg) {
    return Json{{"inputMaxValue", kAll_deg}, {"outputScale", most_deg}};
  };
  return {{"type", "bone"},
          {"offsetFromHeadBone", {offset.x, offset.y, offset.z}},
          {"rangeMapHorizontalInner", map(scene.eye_side_deg)},
          {"rangeMapHorizontalOuter", map(scene.eye_side_deg)},
          {"rangeMapVerticalDown", map(scene.eye_down_deg)},
          {"rangeMapVerticalUp", map(scene.eye_up_deg)}};
}

}  // namespace

tinygltf::Value to_gltf_value(const Json& json) {
  if (json.is_object()) {
    tinygltf::Value::Object object;
    for (const auto& [key, value] : json.items()) object[key] = to_gltf_value(value);
    return tinygltf::Value(object);
  }
  if (json.is_array()) {
    tinygltf::Value::Array array;
    for (const Json& value : json) array.push_back(to_gltf_value(value));
    return tinygltf::Value(array);
  }
  if (json.is_boolean()) return tinygltf::Value(json.get<bool>());
  if (json.is_number_integer()) return tinygltf::Value(json.get<int>());
  if (json.is_number()) return tinygltf::Value(json.get<double>());
  return tinygltf::Value(json.get<std::string>());
}

std::string build_vrm(const VrmScene& scene) {
  const auto rest = [&] {
    RigPose pose;
    for (const RigJoint& joint : scene.rig.joints)
      pose.joints.push_back(
          {{1, 0, 0, 0},
           joint.at_mm - (joint.parent < 0 ? glm::dvec3(0) : scene.rig.joints[joint.parent].at_mm)});
    pose.weights.resize(scene.rig.targets.size(), 0);
    return pose;
  }();
  const RigTake take{{0}, {rest}};
  GltfModel built = build_gltf_model({scene.model, scene.rig, take, scene.title, scene.paint});
  Json vrm{{"specVersion", "1.0"}, {"meta", build_meta(scene)}};
  vrm["humanoid"] = {{"humanBones", add_bones(scene, built)}};
  vrm["lookAt"] = build_look_at(scene);
  Json presets;
  for (std::size_t t = 0; t < scene.rig.targets.size(); ++t)
    presets[scene.rig.targets[t]] = build_expression(scene, built, t);
  vrm["expressions"] = {{"preset", presets}};
  built.model.extensions["VRMC_vrm"] = to_gltf_value(vrm);
  built.model.extensionsUsed.emplace_back("VRMC_vrm");
  return write_gltf_model(built.model, true);
}

}  // namespace mien

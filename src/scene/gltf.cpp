#include "scene/gltf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "core/error.hpp"
#include "scene/gltf_buffer.hpp"
#include "scene/gltf_model.hpp"
#include "scene/surface_look.hpp"
#include "scene/title.hpp"

namespace mien {

namespace {

constexpr float kMetres = 0.001f;  // of a millimetre
constexpr int kVertices = TINYGLTF_TARGET_ARRAY_BUFFER;

struct GltfWork {
  const GltfScene& scene;
  std::map<std::string, int> materials;
  GltfModel& built;
  tinygltf::Model& model;
};

// A part as glTF draws it: a vertex has one colour, so that where triangles have shades of their own it is
// there once for each. `from` tells the part's vertex that each is.
struct DrawnPart {
  std::vector<std::uint32_t> from;
  std::vector<Triangle> triangles;
  std::vector<glm::u8vec4> colours;
  std::vector<std::vector<std::uint32_t>> drawn_as;  // of each vertex of the part
};

// As its atlas has it: a vertex of the cut is there twice.
DrawnPart draw_painted(const Part& part, const Atlas& atlas) {
  DrawnPart drawn{atlas.vertices, atlas.triangles, {}, {}};
  drawn.drawn_as.resize(part.rest.positions.size());
  for (std::uint32_t v = 0; v < atlas.vertices.size(); ++v) drawn.drawn_as[atlas.vertices[v]].push_back(v);
  return drawn;
}

// In the part's own order; where triangles have shades, by vertex and then shade.
DrawnPart draw_part(const Part& part, const SurfaceLook& look) {
  DrawnPart drawn;
  const auto find_shade = [&](std::size_t triangle, std::uint32_t vertex) -> std::uint16_t {
    if (!part.triangle_shade.empty()) return part.triangle_shade[triangle];
    return part.shade.empty() ? 0 : part.shade[vertex];
  };
  std::vector<std::set<std::uint16_t>> shades(part.rest.positions.size());
  for (std::size_t t = 0; t < part.rest.triangles.size(); ++t)
    for (const std::uint32_t v : part.rest.triangles[t]) shades[v].insert(find_shade(t, v));
  drawn.drawn_as.resize(shades.size());
  for (std::uint32_t v = 0; v < shades.size(); ++v) {
    if (shades[v].empty()) shades[v].insert(0);  // no triangle has it; it keeps its number
    for (const std::uint16_t shade : shades[v]) {
      drawn.drawn_as[v].push_back(static_cast<std::uint32_t>(drawn.from.size()));
      drawn.from.push_back(v);
      drawn.colours.emplace_back(glm::round(255.0f * compute_vertex_colour(part, look, v, shade)));
    }
  }
  for (std::size_t t = 0; t < part.rest.triangles.size(); ++t) {
    Triangle triangle = part.rest.triangles[t];
    for (std::uint32_t& v : triangle) {
      const auto at = std::distance(shades[v].begin(), shades[v].find(find_shade(t, v)));
      v = drawn.drawn_as[v][at];
    }
    drawn.triangles.push_back(triangle);
  }
  return drawn;
}

template <typename T>
std::vector<T> pick(const std::vector<T>& of, const std::vector<std::uint32_t>& from) {
  std::vector<T> picked;
  picked.reserve(from.size());
  for (const std::uint32_t v : from) picked.push_back(of[v]);
  return picked;
}

tinygltf::Value make_names(const Rig& rig, const std::vector<RigTarget>& targets) {
  tinygltf::Value::Array names;
  for (const RigTarget& target : targets) names.emplace_back(rig.targets[target.name]);
  return tinygltf::Value(tinygltf::Value::Object{{"targetNames", tinygltf::Value(names)}});
}

int take_material(GltfWork& work, const std::string& name, const SurfaceLook& look) {
  const auto [found, is_new] = work.materials.emplace(name, static_cast<int>(work.model.materials.size()));
  if (!is_new) return found->second;
  tinygltf::Material material;
  material.name = name;
  material.pbrMetallicRoughness.metallicFactor = 0;
  material.pbrMetallicRoughness.roughnessFactor = look.roughness;
  material.doubleSided = look.is_two_sided;
  if (look.alpha < 1) material.alphaMode = "BLEND";
  work.model.materials.push_back(material);
  return found->second;
}

// The picture of a part's material.
void paint_material(tinygltf::Model& model, const GltfPaint& paint, int material) {
  tinygltf::Image image;
  image.name = "skin";
  image.mimeType = "image/png";
  image.bufferView = add_view(model, paint.png);
  model.images.push_back(image);
  tinygltf::Texture texture;
  texture.source = static_cast<int>(model.images.size()) - 1;
  model.textures.push_back(texture);
  model.materials[material].pbrMetallicRoughness.baseColorTexture.index =
      static_cast<int>(model.textures.size()) - 1;
}

// glTF's pictures begin at the top.
std::vector<glm::vec2> flip_places(const std::vector<glm::vec2>& places) {
  std::vector<glm::vec2> flipped;
  for (const glm::vec2& place : places) flipped.emplace_back(place.x, 1 - place.y);
  return flipped;
}

// Of a drawn vertex the joints and their shares.
void add_skin_weights(tinygltf::Model& model, const std::vector<JointShare>& shares,
                      tinygltf::Primitive& primitive) {
  constexpr int kAll = 65535;
  std::vector<glm::u8vec4> joints;
  std::vector<glm::u16vec4> weights;
  for (const JointShare& share : shares) {
    const auto second = static_cast<int>(std::lround(kAll * share.share));
    // A joint without a share is told as 0.
    joints.emplace_back(second < kAll ? share.first : 0, second > 0 ? share.second : 0, 0, 0);
    weights.emplace_back(kAll - second, second, 0, 0);
  }
  primitive.attributes["JOINTS_0"] = add_bytes(model, joints, false, kVertices);
  primitive.attributes["WEIGHTS_0"] = add_shares(model, weights, kVertices);
}

// The same offsets at the drawn vertices, rising.
VertexOffsets draw_offsets(const DrawnPart& drawn, const std::vector<std::uint32_t>& vertices,
                           const std::vector<glm::vec3>& offsets, float scale) {
  std::vector<std::pair<std::uint32_t, glm::vec3>> all;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (const std::uint32_t v : drawn.drawn_as[vertices[i]]) all.emplace_back(v, scale * offsets[i]);
  std::ranges::sort(all, {}, &std::pair<std::uint32_t, glm::vec3>::first);
  VertexOffsets told;
  for (const auto& [v, offset] : all) {
    told.vertices.push_back(v);
    told.offsets.push_back(offset);
  }
  return told;
}

// All of them, in their order, also one whose vertices no triangle has.
void add_targets(tinygltf::Model& model, const DrawnPart& drawn, const std::vector<RigTarget>& targets,
                 tinygltf::Primitive& primitive) {
  const bool has_normals =
      std::ranges::any_of(targets, [](const RigTarget& t) { return !t.normals.empty(); });
  for (const RigTarget& target : targets) {
    VertexOffsets places = draw_offsets(drawn, target.places.vertices, target.places.offsets, kMetres);
    if (places.vertices.empty()) places = {{0}, {glm::vec3(0)}};
    std::map<std::string, int> attributes;
    attributes["POSITION"] = add_sparse_vectors(model, drawn.from.size(), places, true);
    if (has_normals) {
      VertexOffsets normals{{0}, {glm::vec3(0)}};
      if (!target.normals.empty()) normals = draw_offsets(drawn, target.places.vertices, target.normals, 1);
      attributes["NORMAL"] = add_sparse_vectors(model, drawn.from.size(), normals, false);
    }
    primitive.targets.push_back(attributes);
  }
}

void add_part(GltfWork& work, std::size_t index) {
  const Part& part = work.scene.model.parts[index];
  const RigPart& rigged = work.scene.rig.parts[index];
  const SurfaceLook look = find_surface_look(part.material);
  const GltfPaint* paint = work.scene.paint && work.scene.paint->part == index ? work.scene.paint : nullptr;
  const DrawnPart drawn = paint ? draw_painted(part, paint->atlas) : draw_part(part, look);
  if (drawn.triangles.empty()) return;
  tinygltf::Model& model = work.model;
  std::vector<glm::vec3> places = pick(part.rest.positions, drawn.from);
  // A rigid part lies about its joint.
  const bool is_skinned = !rigged.shares.empty();
  const glm::vec3 origin = is_skinned ? glm::vec3(0) : glm::vec3(work.scene.rig.joints[rigged.joint].at_mm);
  for (glm::vec3& place : places) place = kMetres * (place - origin);
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.material = take_material(work, part.material, look);
  primitive.attributes["POSITION"] = add_vectors(model, places, true, kVertices);
  if (!part.rest.normals.empty()) {
    std::vector<glm::vec3> normals = pick(part.rest.normals, drawn.from);
    for (glm::vec3& normal : normals) normal = glm::normalize(normal);
    primitive.attributes["NORMAL"] = add_vectors(model, normals, false, kVertices);
  }
  if (paint) {
    primitive.attributes["TEXCOORD_0"] = add_pairs(model, flip_places(paint->atlas.places), kVertices);
    paint_material(model, *paint, primitive.material);
  } else {
    primitive.attributes["COLOR_0"] = add_bytes(model, drawn.colours, true, kVertices);
  }
  primitive.indices = add_indices(model, drawn.triangles);
  tinygltf::Node node;
  node.name = part.name;
  node.mesh = static_cast<int>(model.meshes.size());
  tinygltf::Mesh mesh;
  mesh.name = part.name;
  if (is_skinned) {
    add_skin_weights(model, pick(rigged.shares, drawn.from), primitive);
    node.skin = 0;
  }
  if (!rigged.targets.empty()) {
    add_targets(model, drawn, rigged.targets, primitive);
    mesh.extras = make_names(work.scene.rig, rigged.targets);
    for (const RigTarget& target : rigged.targets)
      mesh.weights.push_back(work.scene.take.poses.front().weights[target.name]);
  }
  mesh.primitives.push_back(primitive);
  model.meshes.push_back(mesh);
  const int at = static_cast<int>(model.nodes.size());
  model.nodes.push_back(node);
  if (is_skinned)
    model.scenes[0].nodes.push_back(at);
  else
    model.nodes[work.built.first_joint + rigged.joint].children.push_back(at);
  work.built.node_of_part[index] = at;
}

glm::quat to_unit(const glm::dquat& turn) { return glm::quat(glm::normalize(turn)); }

// The joints as they stand in the take's first pose, and the skin that binds vertices to them at rest.
void add_joints(GltfWork& work) {
  tinygltf::Model& model = work.model;
  const Rig& rig = work.scene.rig;
  const RigPose& pose = work.scene.take.poses.front();
  tinygltf::Skin skin;
  skin.name = "rig";
  std::vector<glm::mat4> binds;
  work.built.first_joint = static_cast<int>(model.nodes.size());
  for (std::size_t j = 0; j < rig.joints.size(); ++j) {
    tinygltf::Node node;
    node.name = rig.joints[j].name;
    const glm::dvec3 at = double(kMetres) * pose.joints[j].at_mm;
    const glm::quat turn = to_unit(pose.joints[j].turn);
    node.translation = {at.x, at.y, at.z};
    node.rotation = {turn.x, turn.y, turn.z, turn.w};
    const int self = work.built.first_joint + static_cast<int>(j);
    model.nodes.push_back(node);
    if (rig.joints[j].parent >= 0)
      model.nodes[work.built.first_joint + rig.joints[j].parent].children.push_back(self);
    else
      model.scenes[0].nodes.push_back(self);
    skin.joints.push_back(self);
    glm::mat4 bind(1);
    bind[3] = glm::vec4(-kMetres * glm::vec3(rig.joints[j].at_mm), 1);
    binds.push_back(bind);
  }
  skin.skeleton = work.built.first_joint;
  skin.inverseBindMatrices = add_matrices(model, binds);
  model.skins.push_back(skin);
}

void add_channel(tinygltf::Animation& animation, int times, int values, int node, const char* path) {
  tinygltf::AnimationSampler sampler;
  sampler.input = times;
  sampler.output = values;
  sampler.interpolation = "LINEAR";
  tinygltf::AnimationChannel channel;
  channel.sampler = static_cast<int>(animation.samplers.size());
  channel.target_node = node;
  channel.target_path = path;
  animation.samplers.push_back(sampler);
  animation.channels.push_back(channel);
}

void add_joint_channels(GltfWork& work, int times, tinygltf::Animation& animation) {
  const std::vector<RigPose>& poses = work.scene.take.poses;
  for (std::size_t j = 0; j < work.scene.rig.joints.size(); ++j) {
    std::vector<glm::quat> turns;
    std::vector<glm::vec3> places;
    for (const RigPose& pose : poses) {
      glm::quat turn = to_unit(pose.joints[j].turn);
      if (!turns.empty() && glm::dot(turns.back(), turn) < 0) turn = -turn;
      turns.push_back(turn);
      places.emplace_back(double(kMetres) * pose.joints[j].at_mm);
    }
    const int node = work.built.first_joint + static_cast<int>(j);
    if (std::ranges::any_of(turns, [&](const glm::quat& turn) { return turn != turns.front(); }))
      add_channel(animation, times, add_turns(work.model, turns), node, "rotation");
    if (std::ranges::any_of(places, [&](const glm::vec3& place) { return place != places.front(); }))
      add_channel(animation, times, add_vectors(work.model, places, false, 0), node, "translation");
  }
}

void add_animation(GltfWork& work) {
  const RigTake& take = work.scene.take;
  if (take.poses.size() < 2) return;
  tinygltf::Animation animation;
  animation.name = "take";
  const int times = add_scalars(work.model, {take.times_s.begin(), take.times_s.end()}, true);
  add_joint_channels(work, times, animation);
  for (std::size_t i = 0; i < work.built.node_of_part.size(); ++i) {
    const std::vector<RigTarget>& targets = work.scene.rig.parts[i].targets;
    if (targets.empty() || work.built.node_of_part[i] < 0) continue;
    std::vector<float> weights;
    for (const RigPose& pose : take.poses)
      for (const RigTarget& target : targets) weights.push_back(pose.weights[target.name]);
    add_channel(animation, times, add_scalars(work.model, weights, false), work.built.node_of_part[i],
                "weights");
  }
  work.model.animations.push_back(animation);
}

}  // namespace

GltfModel build_gltf_model(const GltfScene& scene) {
  GltfModel built;
  tinygltf::Model& model = built.model;
  GltfWork work{scene, {}, built, model};
  model.asset.version = "2.0";
  model.asset.generator = fmt::format("mien {}", MIEN_VERSION);
  model.scenes.emplace_back();
  model.scenes[0].name = clean_title(scene.title);
  model.defaultScene = 0;
  built.node_of_part.assign(scene.model.parts.size(), -1);
  add_joints(work);
  for (std::size_t i = 0; i < scene.model.parts.size(); ++i) add_part(work, i);
  add_animation(work);
  return built;
}

std::string write_gltf_model(tinygltf::Model& model, bool is_binary) {
  std::ostringstream bytes;
  if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, bytes, !is_binary, is_binary))
    throw RunError("internal: tinygltf does not write the scene");
  return std::move(bytes).str();
}

std::string build_gltf(const GltfScene& scene, bool is_binary) {
  GltfModel built = build_gltf_model(scene);
  return write_gltf_model(built.model, is_binary);
}

}  // namespace mien

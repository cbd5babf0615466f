#include "exchange/gltf_probe.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <stdexcept>

namespace mien {

namespace {

using Numbers = std::vector<double>;

double read_component(const unsigned char* at, int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_FLOAT: {
      float number;
      std::memcpy(&number, at, 4);
      return number;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: {
      std::uint32_t number;
      std::memcpy(&number, at, 4);
      return number;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: {
      std::uint16_t number;
      std::memcpy(&number, at, 2);
      return number;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return *at;
    default:
      throw std::runtime_error("a component that is not expected");
  }
}

Numbers read_view(const tinygltf::Model& model, int view_index, std::size_t offset, int type,
                  std::size_t count) {
  const tinygltf::BufferView& view = model.bufferViews.at(view_index);
  const std::vector<unsigned char>& bytes = model.buffers.at(view.buffer).data;
  const std::size_t size = tinygltf::GetComponentSizeInBytes(type);
  if (view.byteOffset + offset + count * size > bytes.size())
    throw std::runtime_error("a view past the buffer");
  Numbers numbers;
  for (std::size_t i = 0; i < count; ++i)
    numbers.push_back(read_component(&bytes[view.byteOffset + offset + i * size], type));
  return numbers;
}

Numbers read_numbers(const tinygltf::Model& model, int index) {
  const tinygltf::Accessor& accessor = model.accessors.at(index);
  const int width = tinygltf::GetNumComponentsInType(accessor.type);
  Numbers numbers(accessor.count * width, 0);
  if (accessor.bufferView >= 0)
    numbers =
        read_view(model, accessor.bufferView, accessor.byteOffset, accessor.componentType, numbers.size());
  if (accessor.sparse.isSparse) {
    const auto& sparse = accessor.sparse;
    const Numbers at =
        read_view(model, sparse.indices.bufferView, 0, sparse.indices.componentType, sparse.count);
    const Numbers values = read_view(model, sparse.values.bufferView, 0, accessor.componentType,
                                     std::size_t(sparse.count) * width);
    for (std::size_t i = 0; i < at.size(); ++i)
      for (int k = 0; k < width; ++k) numbers.at(std::size_t(at[i]) * width + k) = values[i * width + k];
  }
  if (accessor.normalized)
    for (double& number : numbers)
      number /= accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? 65535 : 255;
  return numbers;
}

// The output of a sampler at a time.
Numbers sample(const tinygltf::Model& model, const tinygltf::AnimationSampler& sampler, double time_s,
               bool is_turn) {
  const Numbers times = read_numbers(model, sampler.input), values = read_numbers(model, sampler.output);
  const std::size_t width = values.size() / times.size();
  const std::size_t next = std::clamp<std::size_t>(std::ranges::upper_bound(times, time_s) - times.begin(), 1,
                                                   std::max<std::size_t>(times.size() - 1, 1));
  const std::size_t last = std::min(next, times.size() - 1), first = last - (last > 0 ? 1 : 0);
  const double share =
      last == first ? 0 : std::clamp((time_s - times[first]) / (times[last] - times[first]), 0.0, 1.0);
  Numbers at(width);
  for (std::size_t k = 0; k < width; ++k)
    at[k] = std::lerp(values[first * width + k], values[last * width + k], share);
  if (is_turn) {
    const auto take = [&](std::size_t i) {
      return glm::dquat(values[i * 4 + 3], values[i * 4], values[i * 4 + 1], values[i * 4 + 2]);
    };
    const glm::dquat turn = glm::slerp(take(first), take(last), share);
    at = {turn.x, turn.y, turn.z, turn.w};
  }
  return at;
}

struct Stage {
  const tinygltf::Model& model;
  std::map<std::pair<int, std::string>, Numbers> moved;  // by node and path
  std::vector<glm::dmat4> worlds;
};

void place_node(Stage& stage, int index, const glm::dmat4& parent) {
  const tinygltf::Node& node = stage.model.nodes.at(index);
  const auto find = [&](const char* path, const std::vector<double>& rest, Numbers otherwise) {
    const auto found = stage.moved.find({index, path});
    return found != stage.moved.end() ? found->second : !rest.empty() ? rest : std::move(otherwise);
  };
  const Numbers at = find("translation", node.translation, {0, 0, 0});
  const Numbers turn = find("rotation", node.rotation, {0, 0, 0, 1});
  stage.worlds.at(index) = glm::translate(parent, glm::dvec3(at[0], at[1], at[2])) *
                           glm::mat4_cast(glm::normalize(glm::dquat(turn[3], turn[0], turn[1], turn[2])));
  for (const int child : node.children) place_node(stage, child, stage.worlds[index]);
}

std::vector<glm::dvec3> read_vectors(const tinygltf::Model& model, int accessor) {
  const Numbers numbers = read_numbers(model, accessor);
  std::vector<glm::dvec3> vectors;
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    vectors.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  return vectors;
}

std::vector<glm::dvec3> place_mesh(const Stage& stage, int index) {
  const tinygltf::Model& model = stage.model;
  const tinygltf::Node& node = model.nodes[index];
  const tinygltf::Mesh& mesh = model.meshes.at(node.mesh);
  const tinygltf::Primitive& primitive = mesh.primitives.at(0);
  std::vector<glm::dvec3> places = read_vectors(model, primitive.attributes.at("POSITION"));
  const auto found = stage.moved.find({index, "weights"});
  const Numbers weights = found != stage.moved.end() ? found->second : mesh.weights;
  for (std::size_t t = 0; t < primitive.targets.size(); ++t) {
    if (weights.at(t) == 0) continue;
    const std::vector<glm::dvec3> offsets = read_vectors(model, primitive.targets[t].at("POSITION"));
    for (std::size_t v = 0; v < places.size(); ++v) places[v] += weights[t] * offsets.at(v);
  }
  if (node.skin < 0) {
    for (glm::dvec3& place : places) place = 1000.0 * glm::dvec3(stage.worlds[index] * glm::dvec4(place, 1));
    return places;
  }
  const tinygltf::Skin& skin = model.skins.at(node.skin);
  const Numbers binds = read_numbers(model, skin.inverseBindMatrices);
  const Numbers joints = read_numbers(model, primitive.attributes.at("JOINTS_0"));
  const Numbers shares = read_numbers(model, primitive.attributes.at("WEIGHTS_0"));
  std::vector<glm::dmat4> moves;
  for (std::size_t j = 0; j < skin.joints.size(); ++j) {
    glm::dmat4 bind;
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r) bind[c][r] = binds.at(16 * j + 4 * c + r);
    moves.push_back(stage.worlds.at(skin.joints[j]) * bind);
  }
  for (std::size_t v = 0; v < places.size(); ++v) {
    glm::dvec4 placed(0);
    for (int k = 0; k < 4; ++k)
      placed += shares[4 * v + k] * (moves.at(std::size_t(joints[4 * v + k])) * glm::dvec4(places[v], 1));
    places[v] = 1000.0 * glm::dvec3(placed);
  }
  return places;
}

}  // namespace

tinygltf::Model read_gltf(const std::string& bytes) {
  tinygltf::TinyGLTF reader;
  reader.SetImageLoader([](tinygltf::Image*, const int, std::string*, std::string*, int, int,
                           const unsigned char*, int, void*) { return true; },
                        nullptr);
  tinygltf::Model model;
  std::string error, warning;
  const bool is_binary = bytes.starts_with("glTF");
  const bool is_read = is_binary
                           ? reader.LoadBinaryFromMemory(&model, &error, &warning,
                                                         reinterpret_cast<const unsigned char*>(bytes.data()),
                                                         static_cast<unsigned>(bytes.size()))
                           : reader.LoadASCIIFromString(&model, &error, &warning, bytes.data(),
                                                        static_cast<unsigned>(bytes.size()), "");
  if (!is_read || !error.empty() || !warning.empty()) throw std::runtime_error("glTF: " + error + warning);
  return model;
}

std::map<std::string, std::vector<glm::dvec3>> place_gltf(const tinygltf::Model& model, double time_s) {
  Stage stage{model, {}, std::vector<glm::dmat4>(model.nodes.size(), glm::dmat4(1))};
  if (!model.animations.empty())
    for (const tinygltf::AnimationChannel& channel : model.animations[0].channels)
      stage.moved[{channel.target_node, channel.target_path}] = sample(
          model, model.animations[0].samplers.at(channel.sampler), time_s, channel.target_path == "rotation");
  for (const int root : model.scenes.at(0).nodes) place_node(stage, root, glm::dmat4(1));
  std::map<std::string, std::vector<glm::dvec3>> places;
  for (std::size_t i = 0; i < model.nodes.size(); ++i)
    if (model.nodes[i].mesh >= 0) places[model.nodes[i].name] = place_mesh(stage, static_cast<int>(i));
  return places;
}

}  // namespace mien

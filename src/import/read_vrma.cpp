// VRM animation: a binary glTF 2.0 whose extension VRMC_vrm_animation says which node's way each expression
// is (x of its translation is the weight) and which nodes are head and neck. Sources: Khronos, glTF 2.0, 4.4
// (binary) and 3.11 (animations); VRM Consortium, VRMC_vrm_animation 1.0. VRM 1.0's axes are ours: x to the
// character's left, y up, z forward. What is wrong lies in binary data and is told by what it is of.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "import/gltf_ways.hpp"
#include "import/reading.hpp"
#include "import/take_reading.hpp"

namespace mien {

namespace {

constexpr double kVrmRate = 60;

// The ways of the bones that turn the head, from the neck up.
std::vector<GltfWay> read_head_ways(GltfFile& gltf, const GltfJson& extension) {
  std::vector<GltfWay> ways;
  const GltfJson* humanoid = find_json_object(extension, "humanoid");
  const GltfJson* bones = humanoid != nullptr ? find_json_object(*humanoid, "humanBones") : nullptr;
  for (const char* name : {"neck", "head"}) {
    const GltfJson* bone = bones != nullptr ? find_json_object(*bones, name) : nullptr;
    const auto node = bone != nullptr ? find_json_index(*bone, "node") : std::nullopt;
    if (!node) continue;
    if (auto way = read_gltf_way(gltf, *node, "rotation")) ways.push_back(std::move(*way));
  }
  return ways;
}

}  // namespace

Take read_vrma(const std::filesystem::path& file, double fps) {
  const std::string name = file.string();
  GltfFile gltf = open_gltf(name, read_plain_file(file, name, "an animation of VRM", kMostGltfBytes));
  Take take;
  take.file = gltf.file;
  take.mapping = "vrm";
  const GltfJson* extensions = find_json_object(gltf.json, "extensions");
  const GltfJson* extension =
      extensions != nullptr ? find_json_object(*extensions, "VRMC_vrm_animation") : nullptr;
  if (extension == nullptr) fail_file(name, "has no VRMC_vrm_animation; expected an animation of VRM");
  if (find_gltf_list(gltf, "animations").empty()) fail_file(name, "has no animation; expected one of VRM");
  std::vector<GltfWay> ways;
  const GltfJson* expressions = find_json_object(*extension, "expressions");
  for (const char* group : {"preset", "custom"}) {
    const GltfJson* named = expressions != nullptr ? find_json_object(*expressions, group) : nullptr;
    if (named == nullptr) continue;
    for (const auto& [word, value] : named->items()) {
      const auto node = value.is_object() ? find_json_index(value, "node") : std::nullopt;
      if (!node)
        fail_file(gltf.file, fmt::format("expression '{}' names no node; expected an animation of VRM",
                                         show_found(word)));
      auto way = read_gltf_way(gltf, *node, "translation");
      if (!way) continue;
      add_take_channel(take, {gltf.file, 0, {}, 0, 0},
                       std::string(group) == "custom" ? build_arkit_name(word) : word);
      ways.push_back(std::move(*way));
    }
  }
  const std::vector<GltfWay> head = read_head_ways(gltf, *extension);
  double end_s = 0;
  const auto reach = [&](const GltfWay& way) {
    end_s = std::max(end_s, static_cast<double>(way.at_s.back()));
  };
  std::ranges::for_each(ways, reach);
  std::ranges::for_each(head, reach);
  const double rate = fps > 0 ? fps : kVrmRate;
  if (end_s > kMaxTakeTime_s)
    fail_file(name, fmt::format("lasts {:.7g} s; expected {:.7g} s at most", end_s, kMaxTakeTime_s));
  const auto rows = static_cast<std::size_t>(std::ceil(end_s * rate - 1e-6)) + 1;
  for (std::size_t row = 0; row < rows && !ways.empty(); ++row) {
    const double at_s = static_cast<double>(row) / rate;
    if (!begin_take_row(take, {gltf.file, 0, {}, 0, 0}, at_s)) continue;
    take.at_s.push_back(at_s);
    for (const GltfWay& way : ways) {
      std::array<double, 3> place{};
      sample_gltf_way(way, at_s, place);
      take.values.push_back(static_cast<float>(std::clamp(place[0], -1.0, 2.0)));
    }
    if (head.empty()) continue;
    glm::dquat turn(1, 0, 0, 0);
    for (const GltfWay& way : head) turn = turn * sample_gltf_turn(way, at_s);
    take.turn_deg.push_back(find_turn_deg(turn));
  }
  return take;
}

}  // namespace mien

// VRM animation: a binary glTF 2.0 whose extension VRMC_vrm_animation says which node's way each expression
// is (x of its translation is the weight) and which nodes are head and neck. Sources: Khronos, glTF 2.0, 4.4
// (binary) and 3.11 (animations); VRM Consortium, VRMC_vrm_animation 1.0. VRM 1.0's axes are ours: x to the
// character's left, y up, z forward. What is wrong lies in binary data and is told by what it is of.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "import/reading.hpp"
#include "import/take_reading.hpp"
#include "import/vrm_file.hpp"

namespace mien {

namespace {

constexpr double kVrmRate = 60;
constexpr int kFloat = 5126;  // glTF's number of it

// The numbers of an accessor of floats, `width` each.
std::vector<float> read_accessor(const VrmFile& gltf, std::optional<std::size_t> index, std::size_t width) {
  const VrmJson* accessor = index ? find_json_item(gltf.json, "accessors", *index) : nullptr;
  if (accessor == nullptr) fail_vrm_file(gltf, "an animation names numbers that are not there");
  const std::string name = fmt::format("accessor {}", *index);
  const auto view_index = find_json_index(*accessor, "bufferView"),
             count = find_json_index(*accessor, "count");
  const VrmJson* view = view_index ? find_json_item(gltf.json, "bufferViews", *view_index) : nullptr;
  const std::string_view kinds[] = {"", "SCALAR", "", "VEC3", "VEC4"};
  if (view == nullptr || !count || accessor->value("componentType", VrmJson(0)) != VrmJson(kFloat) ||
      accessor->value("type", VrmJson("")) != VrmJson(kinds[width]))
    fail_vrm_file(gltf,
                  fmt::format("{} is no list of {} of floats", name, width == 1 ? "numbers" : "vectors"));
  const std::size_t size = 4 * width, stride = find_json_index(*view, "byteStride").value_or(size);
  const std::size_t begin =
      find_json_index(*view, "byteOffset").value_or(0) + find_json_index(*accessor, "byteOffset").value_or(0);
  const std::size_t all = gltf.binary.size();
  if (*count == 0 || *count > all || stride < size || stride > all || begin > all ||
      (*count - 1) * stride + size > all - begin)
    fail_vrm_file(gltf, fmt::format("{} lies beyond the file's {} bytes of numbers", name, all));
  std::vector<float> numbers;
  for (std::size_t i = 0; i < *count; ++i)
    for (std::size_t j = 0; j < width; ++j) {
      const float number = std::bit_cast<float>(read_vrm_word(gltf.binary, begin + i * stride + 4 * j));
      if (!std::isfinite(number)) fail_vrm_file(gltf, fmt::format("{} has a number that is none", name));
      numbers.push_back(number);
    }
  return numbers;
}

// The way of one node's translation or rotation.
struct NodeWay {
  std::size_t width = 0;
  std::vector<float> at_s, values;
  bool is_stepped = false;
};

std::optional<NodeWay> read_way(const VrmFile& gltf, std::size_t node, std::string_view path,
                                std::size_t width) {
  const VrmJson* animation = find_json_item(gltf.json, "animations", 0);
  if (animation == nullptr || !animation->contains("channels") || !(*animation)["channels"].is_array())
    fail_vrm_file(gltf, "has no animation");
  for (const VrmJson& channel : (*animation)["channels"]) {
    const VrmJson* target = channel.is_object() ? find_json_object(channel, "target") : nullptr;
    if (target == nullptr || find_json_index(*target, "node") != node ||
        target->value("path", VrmJson("")) != VrmJson(path))
      continue;
    const auto index = find_json_index(channel, "sampler");
    const VrmJson* sampler = index ? find_json_item(*animation, "samplers", *index) : nullptr;
    if (sampler == nullptr) fail_vrm_file(gltf, fmt::format("the way of node {} has no sampler", node));
    NodeWay way{width, read_accessor(gltf, find_json_index(*sampler, "input"), 1),
                read_accessor(gltf, find_json_index(*sampler, "output"), width)};
    const VrmJson between = sampler->value("interpolation", VrmJson("LINEAR"));
    way.is_stepped = between == VrmJson("STEP");
    if (between == VrmJson("CUBICSPLINE")) {  // of tangent, value, tangent the value
      std::vector<float> middle;
      for (std::size_t i = width; i + 2 * width <= way.values.size(); i += 3 * width)
        middle.insert(middle.end(), way.values.begin() + static_cast<std::ptrdiff_t>(i),
                      way.values.begin() + static_cast<std::ptrdiff_t>(i + width));
      way.values = std::move(middle);
    }
    if (way.values.size() != way.at_s.size() * width || !std::ranges::is_sorted(way.at_s) || way.at_s[0] < 0)
      fail_vrm_file(
          gltf, fmt::format("the way of node {} has {} times and {} values, or times that do not rise", node,
                            way.at_s.size(), way.values.size() / width));
    return way;
  }
  return std::nullopt;
}

std::array<double, 4> sample_way(const NodeWay& way, double at_s) {
  const auto next = std::ranges::upper_bound(way.at_s, static_cast<float>(at_s)) - way.at_s.begin();
  const auto after = static_cast<std::size_t>(std::min<std::ptrdiff_t>(next, std::ssize(way.at_s) - 1));
  const std::size_t before = next == 0 ? 0 : static_cast<std::size_t>(next - 1);
  const double step = way.at_s[after] - way.at_s[before];
  const double share =
      way.is_stepped || step <= 0 ? 0 : std::clamp((at_s - way.at_s[before]) / step, 0.0, 1.0);
  std::array<double, 4> sampled{};
  // A rotation is told by a quaternion and by its negative alike.
  double dot = 0;
  for (std::size_t i = 0; i < way.width; ++i)
    dot += static_cast<double>(way.values[before * way.width + i]) * way.values[after * way.width + i];
  const double sign = way.width == 4 && dot < 0 ? -1 : 1;
  for (std::size_t i = 0; i < way.width; ++i)
    sampled[i] =
        (1 - share) * way.values[before * way.width + i] + sign * share * way.values[after * way.width + i];
  return sampled;
}

std::array<double, 4> multiply(const std::array<double, 4>& a, const std::array<double, 4>& b) {
  return {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
          a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
          a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
          a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

std::array<float, 3> find_quaternion_turn(std::array<double, 4> q) {
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (length < 1e-9) return {};
  for (double& part : q) part /= length;
  const auto [x, y, z, w] = q;
  return find_turn_deg({1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w),
                        2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w),
                        2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)});
}

// The ways of the bones that turn the head, from the neck up.
std::vector<NodeWay> read_head_ways(const VrmFile& gltf, const VrmJson& extension) {
  std::vector<NodeWay> ways;
  const VrmJson* humanoid = find_json_object(extension, "humanoid");
  const VrmJson* bones = humanoid != nullptr ? find_json_object(*humanoid, "humanBones") : nullptr;
  for (const char* name : {"neck", "head"}) {
    const VrmJson* bone = bones != nullptr ? find_json_object(*bones, name) : nullptr;
    const auto node = bone != nullptr ? find_json_index(*bone, "node") : std::nullopt;
    if (!node) continue;
    if (auto way = read_way(gltf, *node, "rotation", 4)) ways.push_back(std::move(*way));
  }
  return ways;
}

}  // namespace

Take read_vrma(const std::filesystem::path& file, double fps) {
  const VrmFile gltf = open_vrm_file(file, "an animation of VRM");
  Take take;
  take.file = gltf.file;
  take.mapping = "vrm";
  const VrmJson* extensions = find_json_object(gltf.json, "extensions");
  const VrmJson* extension =
      extensions != nullptr ? find_json_object(*extensions, "VRMC_vrm_animation") : nullptr;
  if (extension == nullptr) fail_vrm_file(gltf, "has no VRMC_vrm_animation");
  std::vector<NodeWay> ways;
  const VrmJson* expressions = find_json_object(*extension, "expressions");
  for (const char* group : {"preset", "custom"}) {
    const VrmJson* named = expressions != nullptr ? find_json_object(*expressions, group) : nullptr;
    if (named == nullptr) continue;
    for (const auto& [name, value] : named->items()) {
      const auto node = value.is_object() ? find_json_index(value, "node") : std::nullopt;
      if (!node) fail_vrm_file(gltf, fmt::format("expression '{}' names no node", show_found(name)));
      auto way = read_way(gltf, *node, "translation", 3);
      if (!way) continue;
      add_take_channel(take, {gltf.file, 0, {}, 0, 0},
                       std::string(group) == "custom" ? build_arkit_name(name) : name);
      ways.push_back(std::move(*way));
    }
  }
  const std::vector<NodeWay> head = read_head_ways(gltf, *extension);
  double end_s = 0;
  const auto reach = [&](const NodeWay& way) {
    end_s = std::max(end_s, static_cast<double>(way.at_s.back()));
  };
  std::ranges::for_each(ways, reach);
  std::ranges::for_each(head, reach);
  const double rate = fps > 0 ? fps : kVrmRate;
  if (end_s > kMaxTakeTime_s) fail_vrm_file(gltf, fmt::format("lasts {:.7g} s", end_s));
  const auto rows = static_cast<std::size_t>(std::ceil(end_s * rate - 1e-6)) + 1;
  for (std::size_t row = 0; row < rows && !ways.empty(); ++row) {
    const double at_s = static_cast<double>(row) / rate;
    if (!begin_take_row(take, {gltf.file, 0, {}, 0, 0}, at_s)) continue;
    take.at_s.push_back(at_s);
    for (const NodeWay& way : ways)
      take.values.push_back(static_cast<float>(std::clamp(sample_way(way, at_s)[0], -1.0, 2.0)));
    if (head.empty()) continue;
    std::array<double, 4> turn{0, 0, 0, 1};
    for (const NodeWay& way : head) turn = multiply(turn, sample_way(way, at_s));
    take.turn_deg.push_back(find_quaternion_turn(turn));
  }
  return take;
}

}  // namespace mien

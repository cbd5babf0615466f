#include "import/gltf_ways.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "import/reading.hpp"
#include "import/take_reading.hpp"

namespace mien {

namespace {

struct GltfPath {
  std::string_view name;
  const char* type;
  std::size_t width;
};
constexpr std::array<GltfPath, 3> kPaths{
    {{"translation", "VEC3", 3}, {"rotation", "VEC4", 4}, {"weights", "SCALAR", 1}}};

// The sampler of the first channel that moves the node so; null if none does.
const GltfJson* find_sampler(const GltfFile& gltf, std::size_t node, std::string_view path) {
  for (const GltfJson& animation : find_gltf_list(gltf, "animations")) {
    const auto channels = animation.find("channels"), samplers = animation.find("samplers");
    if (channels == animation.end() || !channels->is_array() || samplers == animation.end() ||
        !samplers->is_array())
      fail_file(gltf.file, "an animation has no channels or no samplers; expected glTF 2.0");
    for (const GltfJson& channel : *channels) {
      const auto target = channel.find("target");
      if (target == channel.end() || !target->is_object() ||
          target->value("node", GltfJson()) != GltfJson(node) ||
          target->value("path", GltfJson()) != GltfJson(path))
        continue;
      const std::size_t index = find_gltf_count(gltf, channel, "sampler", {});
      if (index >= samplers->size() || !(*samplers)[index].is_object())
        fail_file(gltf.file, fmt::format("the way of node {} has no sampler; expected glTF 2.0", node));
      return &(*samplers)[index];
    }
  }
  return nullptr;
}

GltfBetween find_between(const GltfJson& sampler) {
  const GltfJson between = sampler.value("interpolation", GltfJson("LINEAR"));
  if (between == GltfJson("STEP")) return GltfBetween::step;
  return between == GltfJson("CUBICSPLINE") ? GltfBetween::cubic : GltfBetween::linear;
}

std::size_t count_keys_per_time(const GltfWay& way) { return way.between == GltfBetween::cubic ? 3 : 1; }

}  // namespace

std::optional<GltfWay> read_gltf_way(GltfFile& gltf, std::size_t node, std::string_view path) {
  const GltfJson* sampler = find_sampler(gltf, node, path);
  if (sampler == nullptr) return std::nullopt;
  const GltfPath& kind = *std::ranges::find(kPaths, path, &GltfPath::name);
  GltfWay way;
  way.between = find_between(*sampler);
  way.is_turn = path == "rotation";
  way.at_s = read_gltf_floats(gltf, find_gltf_count(gltf, *sampler, "input", {}), "SCALAR", 1);
  way.values = read_gltf_floats(gltf, find_gltf_count(gltf, *sampler, "output", {}), kind.type, kind.width);
  const std::size_t steps = way.at_s.size() * count_keys_per_time(way);
  way.width = path == "weights" && steps > 0 ? way.values.size() / steps : kind.width;
  if (steps == 0 || way.width == 0 || way.values.size() != steps * way.width ||
      !std::ranges::is_sorted(way.at_s) || way.at_s.front() < 0)
    fail_file(gltf.file, fmt::format("the way of node {} has {} times and {} values, or times that do not "
                                     "rise; expected an animation of glTF 2.0",
                                     node, way.at_s.size(), way.values.size() / kind.width));
  return way;
}

void sample_gltf_way(const GltfWay& way, double at_s, std::span<double> into) {
  const auto next = std::ranges::upper_bound(way.at_s, static_cast<float>(at_s)) - way.at_s.begin();
  const auto after = static_cast<std::size_t>(std::min<std::ptrdiff_t>(next, std::ssize(way.at_s) - 1));
  const std::size_t before = next == 0 ? 0 : static_cast<std::size_t>(next - 1);
  const double step = static_cast<double>(way.at_s[after]) - static_cast<double>(way.at_s[before]);
  const double share =
      step <= 0 ? 0 : std::clamp((at_s - static_cast<double>(way.at_s[before])) / step, 0.0, 1.0);
  const std::size_t keys = count_keys_per_time(way);
  // A cubic key is tangent, value, tangent.
  const auto find_value = [&](std::size_t time, std::size_t key, std::size_t i) {
    return static_cast<double>(way.values[(time * keys + key) * way.width + i]);
  };
  const std::size_t own = keys / 2;
  double dot = 0;
  for (std::size_t i = 0; i < way.width; ++i) dot += find_value(before, own, i) * find_value(after, own, i);
  // A rotation is told by a quaternion and by its negative alike.
  const double sign = way.is_turn && way.between == GltfBetween::linear && dot < 0 ? -1 : 1;
  const double square = share * share, cube = square * share;
  for (std::size_t i = 0; i < way.width; ++i) {
    const double from = find_value(before, own, i), to = sign * find_value(after, own, i);
    if (way.between == GltfBetween::step)
      into[i] = from;
    else if (way.between == GltfBetween::linear)
      into[i] = (1 - share) * from + share * to;
    else
      into[i] = (2 * cube - 3 * square + 1) * from +
                (cube - 2 * square + share) * step * find_value(before, 2, i) + (3 * square - 2 * cube) * to +
                (cube - square) * step * find_value(after, 0, i);
  }
}

glm::dquat sample_gltf_turn(const GltfWay& way, double at_s) {
  std::array<double, 4> turn{};
  sample_gltf_way(way, at_s, turn);
  const glm::dquat sampled(turn[3], turn[0], turn[1], turn[2]);
  const double length = glm::length(sampled);
  return length < 1e-9 ? glm::dquat(1, 0, 0, 0) : sampled / length;
}

std::array<float, 3> find_turn_deg(const glm::dquat& turn) {
  const glm::dmat3 axes = glm::mat3_cast(turn);
  return find_turn_deg(std::array{axes[0].x, axes[0].y, axes[0].z, axes[1].x, axes[1].y, axes[1].z, axes[2].x,
                                  axes[2].y, axes[2].z});
}

}  // namespace mien

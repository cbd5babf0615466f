// A head that glTF 2.0 animates: the weights of its targets by their names, and how the joint of the head
// turns. Targets that mien names are moves of ours ("lid.left.shut"; "lid.left.shut@50" is half of it);
// others are units of ARKit or VRM by name. The turn is in the world, from how the skin is bound.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <set>

#include "import/gltf_ways.hpp"
#include "import/reading.hpp"
#include "import/take_reading.hpp"

namespace mien {

namespace {

constexpr double kFilledRate = 60;        // rows a second where ways are not straight
constexpr float kSlightTurn_deg = 0.01F;  // less is the rounding of numbers
constexpr int kMostAncestors = 64;
constexpr std::size_t kMostTargets = 1000;  // of heads of others, whose targets are not all of a face

// A target as a channel of the take, and how much of it weight 1 is.
struct TargetName {
  std::string channel;  // empty: nobody's unit
  double share = 1;
};

bool is_way_of_ours(std::string_view name) {
  return name.find('.') != name.npos && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_.") == name.npos;
}

TargetName read_target_name(std::string_view name) {
  // What mien adds to mend the sum of others.
  for (const std::string_view mends : {"correct.", "frame."})
    if (name.starts_with(mends)) return {};
  TargetName target;
  if (const std::size_t at = name.find('@'); at != name.npos) {
    const std::string_view percent = name.substr(at + 1);
    double value = 0;
    const auto [end, error] = std::from_chars(percent.data(), percent.data() + percent.size(), value);
    if (error == std::errc() && end == percent.data() + percent.size() && value > 0 && value < 100 &&
        is_way_of_ours(name.substr(0, at))) {
      target.share = value / 100;
      name = name.substr(0, at);
    }
  }
  target.channel = is_way_of_ours(name) ? fmt::format("{}{}", kOwnUnit, name) : build_arkit_name(name);
  return target;
}

// Where a channel's numbers come from: weights of one node.
struct WeighedNode {
  std::optional<GltfWay> way;
  std::vector<double> rest;                             // without a way
  std::vector<std::pair<std::size_t, std::size_t>> of;  // target and channel
  std::vector<double> shares;                           // of the same
};

std::vector<double> read_rest_weights(const GltfJson& node, const GltfJson& mesh, std::size_t count) {
  std::vector<double> rest(count, 0);
  for (const GltfJson* holder : {&mesh, &node}) {
    const GltfJson told = holder->value("weights", GltfJson());
    for (std::size_t i = 0; told.is_array() && i < std::min(count, told.size()); ++i)
      if (told[i].is_number()) rest[i] = told[i].get<double>();
  }
  return rest;
}

// What several meshes of a head have is taken from the first of them.
std::vector<WeighedNode> read_weights(GltfFile& gltf, Take& take) {
  std::vector<WeighedNode> weighed;
  std::set<std::string> known;
  const GltfJson& nodes = find_gltf_list(gltf, "nodes");
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const GltfJson& node = find_gltf_item(gltf, "nodes", n);
    if (!node.contains("mesh")) continue;
    const GltfJson& mesh = find_gltf_item(gltf, "meshes", find_gltf_count(gltf, node, "mesh", {}));
    const std::vector<std::string> names = list_gltf_targets(mesh);
    WeighedNode own;
    std::set<std::string> here;
    for (std::size_t t = 0; t < names.size(); ++t) {
      const TargetName target = read_target_name(names[t]);
      if (target.channel.empty() || known.contains(target.channel)) continue;
      if (here.insert(target.channel).second)
        add_take_channel(take, {gltf.file, 0, {}, 0, 0}, target.channel, kMostTargets);
      const auto channel = std::ranges::find(take.channels, target.channel, &TakeChannel::name);
      own.of.emplace_back(t, channel - take.channels.begin());
      own.shares.push_back(target.share);
    }
    known.merge(here);
    if (own.of.empty()) continue;
    own.rest = read_rest_weights(node, mesh, names.size());
    own.way = read_gltf_way(gltf, n, "weights");
    if (own.way && own.way->width != names.size())
      fail_file(gltf.file, fmt::format("the way of node {} has {} weights a time where the mesh names {} "
                                       "targets; expected as many",
                                       n, own.way->width, names.size()));
    weighed.push_back(std::move(own));
  }
  return weighed;
}

// The joints from the root to the head.
struct HeadChain {
  std::vector<glm::dquat> still;
  std::vector<std::optional<GltfWay>> ways;
  glm::dquat bound{1, 0, 0, 0};  // how the head stands where the skin is bound to it
};

glm::dquat read_still_turn(const GltfJson& node) {
  const GltfJson told = node.value("rotation", GltfJson());
  if (!told.is_array() || told.size() != 4) return {1, 0, 0, 0};
  std::array<double, 4> turn{0, 0, 0, 1};
  for (std::size_t i = 0; i < 4; ++i)
    if (told[i].is_number()) turn[i] = told[i].get<double>();
  const glm::dquat quaternion(turn[3], turn[0], turn[1], turn[2]);
  return glm::length(quaternion) < 1e-9 ? glm::dquat(1, 0, 0, 0) : glm::normalize(quaternion);
}

std::optional<glm::dquat> read_bound_turn(GltfFile& gltf, std::size_t node) {
  for (const GltfJson& skin : find_gltf_list(gltf, "skins")) {
    const GltfJson joints = skin.is_object() ? skin.value("joints", GltfJson()) : GltfJson();
    if (!joints.is_array() || !skin.contains("inverseBindMatrices")) continue;
    const auto joint = std::find(joints.begin(), joints.end(), GltfJson(node));
    if (joint == joints.end()) continue;
    const std::vector<float> binds =
        read_gltf_floats(gltf, find_gltf_count(gltf, skin, "inverseBindMatrices", {}), "MAT4", 16);
    const auto first = 16 * static_cast<std::size_t>(joint - joints.begin());
    if (first + 16 > binds.size()) return std::nullopt;
    glm::dmat3 axes;
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3; ++r)
        axes[c][r] = static_cast<double>(binds[first + static_cast<std::size_t>(4 * c + r)]);
    for (int c = 0; c < 3; ++c) {
      if (glm::length(axes[c]) < 1e-9) return std::nullopt;
      axes[c] = glm::normalize(axes[c]);
    }
    return glm::conjugate(glm::quat_cast(axes));
  }
  return std::nullopt;
}

// "head", "Head", "mixamorig:Head", "J_Bip_C_Head", and no "Forehead".
bool is_head_name(std::string name) {
  constexpr std::string_view kHead = "head";
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
  if (!name.ends_with(kHead)) return false;
  return name.size() == kHead.size() ||
         std::isalpha(static_cast<unsigned char>(name[name.size() - kHead.size() - 1])) == 0;
}

// The first joint of such a name; meshes may be called so, too.
std::optional<std::size_t> find_head(const GltfFile& gltf) {
  const GltfJson& nodes = find_gltf_list(gltf, "nodes");
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const GltfJson name = nodes[n].is_object() ? nodes[n].value("name", GltfJson()) : GltfJson();
    if (name.is_string() && !nodes[n].contains("mesh") && is_head_name(name.get<std::string>())) return n;
  }
  return std::nullopt;
}

std::optional<std::size_t> find_parent(const GltfFile& gltf, std::size_t child) {
  const GltfJson& nodes = find_gltf_list(gltf, "nodes");
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const GltfJson children = nodes[n].is_object() ? nodes[n].value("children", GltfJson()) : GltfJson();
    if (children.is_array() && std::find(children.begin(), children.end(), GltfJson(child)) != children.end())
      return n;
  }
  return std::nullopt;
}

HeadChain read_head(GltfFile& gltf) {
  HeadChain chain;
  const std::optional<std::size_t> head = find_head(gltf);
  int depth = 0;
  for (std::optional<std::size_t> at = head; at && depth < kMostAncestors;
       at = find_parent(gltf, *at), ++depth) {
    chain.still.insert(chain.still.begin(), read_still_turn(find_gltf_item(gltf, "nodes", *at)));
    chain.ways.insert(chain.ways.begin(), read_gltf_way(gltf, *at, "rotation"));
  }
  if (!head) return chain;
  if (const auto bound = read_bound_turn(gltf, *head)) {
    chain.bound = *bound;
  } else {
    for (const glm::dquat& turn : chain.still) chain.bound = chain.bound * turn;
  }
  return chain;
}

glm::dquat sample_head(const HeadChain& chain, double at_s) {
  glm::dquat world(1, 0, 0, 0);
  for (std::size_t i = 0; i < chain.still.size(); ++i)
    world = world * (chain.ways[i] ? sample_gltf_turn(*chain.ways[i], at_s) : chain.still[i]);
  return world * glm::conjugate(chain.bound);
}

// 0, the times of all keys, and where ways are not straight more between them; or rows at a rate.
std::vector<double> list_times(const std::string& file, const std::vector<const GltfWay*>& ways, double fps) {
  std::vector<double> times{0};
  bool is_straight = true;
  for (const GltfWay* way : ways) {
    times.insert(times.end(), way->at_s.begin(), way->at_s.end());
    is_straight = is_straight && way->between == GltfBetween::linear;
  }
  const double end_s = *std::ranges::max_element(times);
  if (end_s > kMaxTakeTime_s)
    fail_file(file, fmt::format("lasts {:.7g} s; expected {:.7g} s at most", end_s, kMaxTakeTime_s));
  if (fps > 0) times = {0};
  const double rate = fps > 0 ? fps : kFilledRate;
  if (fps > 0 || !is_straight)
    for (std::size_t row = 0; static_cast<double>(row) / rate <= end_s + 1e-6; ++row)
      times.push_back(static_cast<double>(row) / rate);
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace

Take read_gltf_take(const std::filesystem::path& path, double fps) {
  const std::string file = path.string();
  GltfFile gltf = open_gltf(file, read_plain_file(path, file, "an animation of a head", kMostGltfBytes));
  Take take;
  take.file = file;
  take.mapping = "vrm";  // whose names are there beside all of ARKit's
  take.is_animation = true;
  const std::vector<WeighedNode> weighed = read_weights(gltf, take);
  const HeadChain head = read_head(gltf);
  std::vector<const GltfWay*> ways;
  for (const WeighedNode& node : weighed)
    if (node.way) ways.push_back(&*node.way);
  for (const auto& way : head.ways)
    if (way) ways.push_back(&*way);
  std::vector<double> row(take.channels.size());
  float most_deg = 0;
  for (const double at_s : list_times(file, ways, fps)) {
    if (!begin_take_row(take, {gltf.file, 0, {}, 0, 0}, at_s)) continue;
    take.at_s.push_back(at_s);
    std::ranges::fill(row, 0.0);
    for (const WeighedNode& node : weighed) {
      std::vector<double> weights = node.rest;
      if (node.way) sample_gltf_way(*node.way, at_s, weights);
      for (std::size_t i = 0; i < node.of.size(); ++i)
        row[node.of[i].second] += node.shares[i] * weights[node.of[i].first];
    }
    for (const double value : row) take.values.push_back(static_cast<float>(std::clamp(value, -1.0, 2.0)));
    take.turn_deg.push_back(find_turn_deg(sample_head(head, at_s)));
    for (const float angle : take.turn_deg.back()) most_deg = std::max(most_deg, std::abs(angle));
  }
  if (most_deg < kSlightTurn_deg) take.turn_deg.clear();
  return take;
}

}  // namespace mien

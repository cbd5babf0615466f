// Sources: VRM Consortium, VRMC_vrm 1.0, expressions; VRM 0.0, BlendShapeMaster.
#include "import/vrm_avatar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "import/gltf_file.hpp"
#include "import/reading.hpp"

namespace mien {

namespace {

constexpr std::size_t kMostExpressions = 1000, kMostBinds = 1000;  // of one expression
constexpr double kWhole0 = 100;                                    // VRM 0.x counts weights to 100

// VRM 0.x's words for what 1.0 names otherwise.
constexpr std::array<std::pair<const char*, const char*>, 16> kPresetsOf0{{{"joy", "happy"},
                                                                           {"sorrow", "sad"},
                                                                           {"fun", "relaxed"},
                                                                           {"a", "aa"},
                                                                           {"i", "ih"},
                                                                           {"u", "ou"},
                                                                           {"e", "ee"},
                                                                           {"o", "oh"},
                                                                           {"blink_l", "blinkLeft"},
                                                                           {"blink_r", "blinkRight"},
                                                                           {"lookup", "lookUp"},
                                                                           {"lookdown", "lookDown"},
                                                                           {"lookleft", "lookLeft"},
                                                                           {"lookright", "lookRight"},
                                                                           {"angry", "angry"},
                                                                           {"blink", "blink"}}};

std::string find_text(const GltfJson& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

[[noreturn]] void fail_avatar(const GltfFile& file, const std::string& message) {
  fail_file(file.file, message + "; expected an avatar of VRM");
}

// The name of a mesh's target; empty if it has none.
std::string find_target(const GltfFile& file, std::size_t mesh_index, std::size_t target) {
  const GltfJson* mesh = find_json_item(file.json, "meshes", mesh_index);
  if (mesh == nullptr) return "";
  const std::vector<std::string> names = list_gltf_targets(*mesh);
  return target < names.size() ? names[target] : "";
}

std::size_t require_index(const GltfFile& file, const GltfJson& bind, const char* key,
                          const std::string& name) {
  if (const auto index = find_json_index(bind, key)) return *index;
  fail_avatar(file, fmt::format("expression '{}' has a bind without '{}'", show_found(name), key));
}

double require_weight(const GltfFile& file, const GltfJson& bind, double whole, const std::string& name) {
  const auto found = bind.find("weight");
  const double weight = found != bind.end() && found->is_number() ? found->get<double>() / whole : -1;
  if (!(weight >= 0 && weight <= 1))
    fail_avatar(file, fmt::format("expression '{}' has a bind whose weight is not from 0 to {:g}",
                                  show_found(name), whole));
  return weight;
}

const GltfJson& list_binds(const GltfFile& file, const GltfJson& expression, const char* key,
                           const std::string& name) {
  static const GltfJson kNone = GltfJson::array();
  const auto found = expression.find(key);
  if (found == expression.end()) return kNone;
  const bool is_right = found->is_array() && found->size() <= kMostBinds &&
                        std::ranges::all_of(*found, [](const GltfJson& bind) { return bind.is_object(); });
  if (!is_right)
    fail_avatar(file, fmt::format("'{}' of expression '{}' is no list of {} binds at most", key,
                                  show_found(name), kMostBinds));
  return *found;
}

void add_expression(const GltfFile& file, VrmExpression expression, VrmAvatar& avatar) {
  if (avatar.expressions.size() >= kMostExpressions)
    fail_avatar(file, fmt::format("has more than {} expressions", kMostExpressions));
  avatar.expressions.push_back(std::move(expression));
}

void read_expressions_1(const GltfFile& file, const GltfJson& vrm, VrmAvatar& avatar) {
  const GltfJson* expressions = find_json_object(vrm, "expressions");
  for (const char* group : {"preset", "custom"}) {
    const GltfJson* named = expressions != nullptr ? find_json_object(*expressions, group) : nullptr;
    if (named == nullptr) continue;
    for (const auto& [name, told] : named->items()) {
      if (!told.is_object()) fail_avatar(file, fmt::format("expression '{}' is no object", show_found(name)));
      VrmExpression expression{
          name, std::string_view(group) == "custom", told.value("isBinary", GltfJson(false)) == true, {}, {}};
      for (const auto& [key, what] :
           {std::pair("overrideBlink", "blink"), {"overrideLookAt", "gaze"}, {"overrideMouth", "mouth"}})
        if (const std::string how = find_text(told, key); how == "block" || how == "blend")
          expression.overrides.push_back(fmt::format("{} {}", what, how));
      for (const GltfJson& bind : list_binds(file, told, "morphTargetBinds", name)) {
        const GltfJson* node = find_json_item(file.json, "nodes", require_index(file, bind, "node", name));
        const auto mesh = node != nullptr ? find_json_index(*node, "mesh") : std::nullopt;
        if (!mesh)
          fail_avatar(file,
                      fmt::format("expression '{}' has a bind to a node without a mesh", show_found(name)));
        expression.binds.push_back({find_target(file, *mesh, require_index(file, bind, "index", name)),
                                    require_weight(file, bind, 1, name)});
      }
      add_expression(file, std::move(expression), avatar);
    }
  }
}

void read_expressions_0(const GltfFile& file, const GltfJson& vrm, VrmAvatar& avatar) {
  const GltfJson* master = find_json_object(vrm, "blendShapeMaster");
  const std::size_t count =
      master != nullptr && master->contains("blendShapeGroups") && (*master)["blendShapeGroups"].is_array()
          ? (*master)["blendShapeGroups"].size()
          : 0;
  for (const bool is_custom : {false, true})
    for (std::size_t i = 0; i < count; ++i) {
      const GltfJson* group = find_json_item(*master, "blendShapeGroups", i);
      if (group == nullptr) fail_avatar(file, fmt::format("blend shape group {} is no object", i));
      const std::string preset = find_text(*group, "presetName");
      const bool has_preset = !preset.empty() && preset != "unknown";
      if (has_preset == is_custom) continue;
      VrmExpression expression{has_preset ? preset : find_text(*group, "name"),
                               is_custom,
                               group->value("isBinary", GltfJson(false)) == true,
                               {},
                               {}};
      if (has_preset)
        for (const auto& [old, now] : kPresetsOf0)
          if (preset == old) expression.name = now;
      if (expression.name.empty()) fail_avatar(file, fmt::format("blend shape group {} has no name", i));
      for (const GltfJson& bind : list_binds(file, *group, "binds", expression.name))
        expression.binds.push_back({find_target(file, require_index(file, bind, "mesh", expression.name),
                                                require_index(file, bind, "index", expression.name)),
                                    require_weight(file, bind, kWhole0, expression.name)});
      add_expression(file, std::move(expression), avatar);
    }
}

}  // namespace

VrmAvatar load_vrm_avatar(const std::filesystem::path& path) {
  const std::string name = path.string();
  const GltfFile file = open_gltf(name, read_plain_file(path, name, "an avatar of VRM", kMostGltfBytes));
  VrmAvatar avatar{file.file, {}};
  const GltfJson* extensions = find_json_object(file.json, "extensions");
  const GltfJson* vrm_1 = extensions != nullptr ? find_json_object(*extensions, "VRMC_vrm") : nullptr;
  const GltfJson* vrm_0 = extensions != nullptr ? find_json_object(*extensions, "VRM") : nullptr;
  if (vrm_1 != nullptr)
    read_expressions_1(file, *vrm_1, avatar);
  else if (vrm_0 != nullptr)
    read_expressions_0(file, *vrm_0, avatar);
  else
    fail_avatar(file, "has no VRMC_vrm");
  if (avatar.expressions.empty()) fail_avatar(file, "has no expressions");
  return avatar;
}

}  // namespace mien

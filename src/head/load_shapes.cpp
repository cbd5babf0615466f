// Reading templates/head/heads.yaml and features.yaml: our own data, so a mistake is a RunError with its
// line.
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "core/error.hpp"
#include "head/shapes.hpp"

namespace mien {

namespace {

MonotoneCurve load_curve(const YAML::Node& node) {
  std::vector<glm::dvec2> knots;
  for (const YAML::Node& knot : node) knots.emplace_back(knot[0].as<double>(), knot[1].as<double>());
  return build_monotone_curve(std::move(knots));
}

MonotoneCurve constant_curve(double value) { return build_monotone_curve({{-1, value}, {1, value}}); }

Warp load_warp(const YAML::Node& node) {
  const auto curve_or_one = [&](const char* key) {
    return node[key] ? load_curve(node[key]) : constant_curve(1);
  };
  Warp warp;
  warp.height = load_curve(node["y"]);
  warp.outer = curve_or_one("outer");
  warp.inner = curve_or_one("inner");
  warp.front = curve_or_one("front");
  warp.back = curve_or_one("back");
  if (node["eye"]) warp.eye = node["eye"].as<double>();
  if (const YAML::Node carry = node["carry"]) {
    warp.carry_e3 = carry["E3"].as<double>();
    warp.carry_e4 = carry["E4"].as<double>();
  }
  return warp;
}

std::map<std::string, Handles> load_handle_tables(const YAML::Node& node) {
  std::map<std::string, Handles> tables;
  for (const auto& table : node)
    for (const auto& handle : table.second) {
      const YAML::Node& v = handle.second;
      tables[table.first.as<std::string>()][handle.first.as<std::string>()] = {
          v[0].as<double>(), v[1].as<double>(), v[2].as<double>()};
    }
  return tables;
}

std::map<std::string, Mix> load_mixes(const YAML::Node& node) {
  std::map<std::string, Mix> mixes;
  for (const auto& mix : node) mixes[mix.first.as<std::string>()] = mix.second.as<Mix>();
  return mixes;
}

}  // namespace

HeadShapes load_head_shapes(const std::filesystem::path& folder) {
  std::filesystem::path file = folder / "heads.yaml";
  try {
    HeadShapes shapes;
    const YAML::Node root = YAML::LoadFile(file.string());
    shapes.ages = load_mixes(root["ages"]);
    shapes.skulls = load_mixes(root["skulls"]);
    for (const auto& warp : root["warps"])
      shapes.warps[warp.first.as<std::string>()] = load_warp(warp.second);
    shapes.fields = load_handle_tables(root["fields"]);
    file = folder / "features.yaml";
    if (std::filesystem::exists(file)) {
      const YAML::Node features = YAML::LoadFile(file.string())["features"];
      for (const auto& feature : features) {
        YAML::Node one;
        one[feature.first.as<std::string>()] = feature.second["handles"];
        shapes.features.merge(load_handle_tables(one));
      }
    }
    return shapes;
  } catch (const YAML::Exception& e) {
    throw RunError(fmt::format("{}:{}: {}", file.string(), e.mark.line + 1, e.msg));
  }
}

}  // namespace mien

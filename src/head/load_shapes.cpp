// Reading templates/head/heads.yaml, fields.csv and features.yaml: our own data, so a mistake is a RunError
// with its line.
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "core/error.hpp"
#include "core/table.hpp"
#include "core/yaml_file.hpp"
#include "head/shapes.hpp"

namespace mien {

namespace {

MonotoneCurve load_curve(const YAML::Node& node) {
  std::vector<glm::dvec2> knots;
  for (const YAML::Node& knot : node) knots.emplace_back(knot[0].as<double>(), knot[1].as<double>());
  return build_monotone_curve(std::move(knots));
}

Warp load_warp(const YAML::Node& node) {
  const auto curve_or_one = [&](const char* key) { return node[key] ? load_curve(node[key]) : kNoChange; };
  Warp warp;
  warp.height = load_curve(node["y"]);
  warp.outer = curve_or_one("outer");
  warp.inner = curve_or_one("inner");
  warp.front = curve_or_one("front");
  warp.back = curve_or_one("back");
  if (node["brow_thickness"]) warp.brow_thickness = node["brow_thickness"].as<double>();
  if (node["eye"]) warp.eye = node["eye"].as<double>();
  if (const YAML::Node carry = node["carry"]) {
    warp.carry_e3 = carry["E3"].as<double>();
    warp.carry_e4 = carry["E4"].as<double>();
  }
  return warp;
}

Handles load_handles(const YAML::Node& node) {
  Handles handles;
  for (const auto& handle : node) {
    const YAML::Node& v = handle.second;
    handles[handle.first.as<std::string>()] = {v[0].as<double>(), v[1].as<double>(), v[2].as<double>()};
  }
  return handles;
}

std::map<std::string, Handles> load_fields(const std::filesystem::path& file) {
  std::map<std::string, Handles> fields;
  read_table(file, 5, true, [&](const Fields& row) -> std::string {
    glm::dvec3 way{0};
    if (std::string mistake = parse_vector(row, 2, way); !mistake.empty()) return mistake;
    if (!fields[row[0]].emplace(row[1], way).second)
      return fmt::format("point '{}' stands twice in '{}'", row[1], row[0]);
    return {};
  });
  return fields;
}

Feature load_feature(const YAML::Node& node) {
  const auto number_or_none = [&](const char* key) { return node[key] ? node[key].as<double>() : 0; };
  Feature feature;
  feature.handles = load_handles(node["handles"]);
  feature.eye_size = number_or_none("eye_size");
  feature.eye_move_mm = {number_or_none("eye_out"), number_or_none("eye_up")};
  feature.eye_tilt_deg = number_or_none("eye_tilt");
  feature.ear_size = number_or_none("ear_size");
  feature.ear_out_deg = number_or_none("ear_out");
  feature.character = number_or_none("character");
  feature.ear_in_deg = number_or_none("ear_in");
  feature.brow_thickness = number_or_none("brow_thickness");
  return feature;
}

std::map<std::string, GuideChart> load_charts(const YAML::Node& node) {
  std::map<std::string, GuideChart> charts;
  for (const auto& entry : node) {
    GuideChart& chart = charts[entry.first.as<std::string>()];
    for (const auto& line : entry.second) {
      const std::string name = line.first.as<std::string>();
      (name == "height" ? chart.height_mm : chart.lines[name]) = line.second.as<double>();
    }
  }
  return charts;
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
    shapes.charts = load_charts(root["charts"]);
    for (const auto& warp : root["warps"])
      shapes.warps[warp.first.as<std::string>()] = load_warp(warp.second);
    shapes.fields = load_fields(folder / "fields.csv");
    file = folder / "features.yaml";
    if (std::filesystem::exists(file)) {
      for (const auto& feature : YAML::LoadFile(file.string())["features"])
        shapes.features[feature.first.as<std::string>()] = load_feature(feature.second);
    }
    return shapes;
  } catch (const YAML::Exception& e) {
    throw build_yaml_error(file, e);
  }
}

std::vector<FeatureInfo> load_features(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "features.yaml";
  std::vector<FeatureInfo> features;
  if (!std::filesystem::exists(file)) return features;
  try {
    const YAML::Node root = YAML::LoadFile(file.string());
    for (const auto& entry : root["features"]) {
      FeatureInfo feature;
      feature.name = entry.first.as<std::string>();
      feature.meaning = entry.second["meaning"].as<std::string>();
      if (const YAML::Node view = entry.second["view"]) feature.view = view.as<std::string>();
      if (feature.view != "front" && feature.view != "three_quarter" && feature.view != "side")
        throw RunError(fmt::format("{}:{}: unknown view '{}'; expected front, three_quarter or side",
                                   file.string(), entry.second["view"].Mark().line + 1, feature.view));
      if (const YAML::Node around = entry.second["around"])
        feature.around = around.as<std::vector<std::string>>();
      else
        for (const auto& handle : entry.second["handles"])
          feature.around.push_back(handle.first.as<std::string>());
      features.push_back(std::move(feature));
    }
  } catch (const YAML::Exception& e) {
    throw build_yaml_error(file, e);
  }
  return features;
}

}  // namespace mien

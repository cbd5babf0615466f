#include "face/face_data.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "core/error.hpp"
#include "core/yaml_file.hpp"

namespace mien {

namespace {

glm::dvec3 load_vector(const YAML::Node& node) {
  return {node[0].as<double>(), node[1].as<double>(), node[2].as<double>()};
}

Handles load_handles(const YAML::Node& node) {
  Handles handles;
  for (const auto& entry : node) handles[entry.first.as<std::string>()] = load_vector(entry.second);
  return handles;
}

// Mouth columns times the share of each ring, as handles "M2_5", where there is none yet.
void add_columns(const YAML::Node& rows, const YAML::Node& columns, Handles& handles) {
  for (const auto& row : rows)
    for (const auto& column : columns)
      handles.try_emplace(row.first.as<std::string>() + "_" + column.first.as<std::string>(),
                          row.second.as<double>() * load_vector(column.second));
}

MoveTable load_move(const std::string& name, const YAML::Node& node) {
  MoveTable table;
  const std::size_t dot = name.find('.');
  table.area = dot == name.npos ? "" : name.substr(0, dot);
  table.move = dot == name.npos ? name : name.substr(dot + 1);
  table.is_sided = node["sided"].as<bool>();
  for (int axis = 0; axis < 3; ++axis) table.units[axis] = node["unit"][axis].as<std::string>();
  table.anchors = node["anchors"].as<std::string>();
  table.plus = load_handles(node["plus"]);
  table.minus = load_handles(node["minus"]);
  if (node["columns_plus"]) add_columns(node["rows"], node["columns_plus"], table.plus);
  if (node["columns_minus"]) add_columns(node["rows"], node["columns_minus"], table.minus);
  return table;
}

// "brow.up-" -> brow, up, -1
Driver load_driver(const std::string& text) {
  const std::size_t dot = text.find('.');
  if (dot == text.npos || (text.back() != '+' && text.back() != '-'))
    throw RunError(fmt::format("'{}' is not a driver; expected area.move+ or area.move-", text));
  return {text.substr(0, dot), text.substr(dot + 1, text.size() - dot - 2), text.back() == '+' ? 1 : -1};
}

LidData load_lids(const YAML::Node& node) {
  LidData lids;
  lids.rows_upper = node["rows_upper"].as<std::map<std::string, double>>();
  lids.rows_lower = node["rows_lower"].as<std::map<std::string, double>>();
  for (std::size_t i = 0; i < 9; ++i) lids.column_taper[i] = node["column_taper"][i].as<double>();
  lids.meeting = node["meeting"].as<double>();
  lids.least_gap_deg = node["least_gap_deg"].as<double>();
  lids.wide_deg = node["wide_deg"].as<double>();
  lids.raised_deg = node["raised_deg"].as<double>();
  lids.raised_bulge = load_handles(node["raised_bulge"]);
  lids.follow_up = node["gaze_follow"]["up"].as<double>();
  lids.follow_down = node["gaze_follow"]["down"].as<double>();
  lids.follow_lower = node["gaze_follow"]["lower"].as<double>();
  lids.fold_least = node["fold"]["least"].as<double>();
  lids.fold_forward = node["fold"]["forward"].as<double>();
  lids.least_radius = node["least_radius"].as<std::map<std::string, double>>();
  return lids;
}

JawData load_jaw(const YAML::Node& node) {
  JawData jaw;
  jaw.axis = load_vector(node["axis"]);
  jaw.degrees = node["degrees"].as<double>();
  jaw.forward = load_vector(node["forward"]);
  for (std::size_t i = 0; i < 13; ++i) {
    jaw.columns[i] = node["columns"][i].as<double>();
    jaw.mb2[i] = node["mb2"][i].as<double>();
  }
  jaw.m6_factor = node["m6_factor"].as<double>();
  for (const auto& point : node["points"])
    jaw.points.emplace_back(point.first.as<std::string>(), point.second.as<double>());
  jaw.zero = node["zero"].as<PointPatterns>();
  jaw.corner_in = load_handles(node["corner_in"]);
  return jaw;
}

FaceData load_root(const YAML::Node& root) {
  FaceData data;
  data.anchors = root["anchors"].as<std::map<std::string, PointPatterns>>();
  for (const auto& move : root["moves"])
    data.moves.push_back(load_move(move.first.as<std::string>(), move.second));
  for (const auto& entry : root["correctives"]) {
    CorrectiveTable corrective{load_move(entry.first.as<std::string>(), entry.second), {}};
    for (const YAML::Node& driver : entry.second["drive"])
      corrective.drivers.push_back(load_driver(driver.as<std::string>()));
    data.correctives.push_back(std::move(corrective));
  }
  for (const auto& entry : root["past_limits"])
    data.past_limits.push_back({load_driver(entry.first.as<std::string>()), entry.second.as<double>()});
  data.lids = load_lids(root["lids"]);
  data.eye_up_deg = root["eyes"]["up_deg"].as<double>();
  data.eye_down_deg = root["eyes"]["down_deg"].as<double>();
  data.eye_side_deg = root["eyes"]["side_deg"].as<double>();
  data.jaw = load_jaw(root["jaw"]);
  data.lip_rows = root["lip_contact"]["rows"].as<std::map<std::string, double>>();
  data.seal_until_mm = root["lip_contact"]["seal_until_mm"].as<double>();
  data.philtrum_rows = root["lip_contact"]["under_nose"].as<std::map<std::string, double>>();
  const YAML::Node give_way = root["give_way"];
  data.give_way = {give_way["from"].as<double>(), give_way["least"].as<double>(),
                   give_way["forward"].as<double>(),
                   give_way["lines"].as<std::vector<std::vector<std::string>>>()};
  data.turn_pivot = load_vector(root["turn"]["pivot"]);
  data.turn_rows = root["turn"]["rows"].as<std::map<std::string, double>>();
  return data;
}

}  // namespace

FaceData load_face_data(const std::filesystem::path& file) { return read_yaml_file(file, load_root); }

}  // namespace mien

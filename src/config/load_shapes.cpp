// Reading templates/head/heads.yaml, fields.csv and features.yaml.
#include <fmt/format.h>

#include "config/data_table.hpp"
#include "config/shape_data.hpp"
#include "core/error.hpp"
#include "core/table.hpp"

namespace mien {

namespace {

// [[x, y], ...], x ascending.
void read_curve(const YamlValue& value, MonotoneCurve& into) {
  std::vector<glm::dvec2> knots;
  if (!load_datum(value, knots)) return;
  try {
    into = build_monotone_curve(std::move(knots));
  } catch (const RunError& error) {
    add_mistake(value, fmt::format("{}: {}", describe_subject(value), error.what()));
  }
}

Warp read_warp(const DataTable& table) {
  Warp warp;
  if (const YamlValue* height = table.require("y")) read_curve(*height, warp.height);
  for (const auto& [key, curve] : {std::pair{"outer", &warp.outer}, std::pair{"inner", &warp.inner},
                                   std::pair{"front", &warp.front}, std::pair{"back", &warp.back}})
    if (const YamlValue* value = table.find(key)) read_curve(*value, *curve);
  table.read_if("brow_thickness", warp.brow_thickness);
  table.read_if("eye", warp.eye);
  if (const YamlValue* value = table.find("carry")) {
    const DataTable carry(*value);
    carry.read("E3", warp.carry_e3);
    carry.read("E4", warp.carry_e4);
  }
  return warp;
}

GuideChart read_chart(const DataTable& table) {
  GuideChart chart;
  table.read("height", chart.height_mm);
  for (const Names* names : {&kGuides, &kEarGuides})
    for (const std::string& line : *names) table.read(line, chart.lines[line]);
  return chart;
}

// Shares of warps, by the names of `words`.
std::map<std::string, Mix> read_mixes(const DataTable& root, const std::string& key, const Names& words) {
  std::map<std::string, Mix> mixes;
  const DataTable table = root.at(key);
  for (const std::string& word : words) table.read(word, mixes[word]);
  return mixes;
}

HeadShapes load_heads(const std::filesystem::path& file, Findings& findings) {
  HeadShapes heads;
  const auto document = load_document(file, findings);
  if (!document) return heads;
  const DataTable root(find_root(*document, findings));
  heads.ages = read_mixes(root, "ages", kAges);
  heads.skulls = read_mixes(root, "skulls", kSkulls);
  const DataTable charts = root.at("charts");
  for (const std::string& age : kAges) heads.charts[age] = read_chart(charts.at(age));
  for (const YamlEntry& entry : root.list("warps"))
    heads.warps[entry.key] = read_warp(DataTable(entry.value));
  return heads;
}

std::map<std::string, Handles> load_fields(const std::filesystem::path& file, const PointNames& points) {
  std::map<std::string, Handles> fields;
  read_table(file, 5, true, [&](const Fields& row) -> std::string {
    glm::dvec3 way{0};
    if (std::string mistake = parse_vector(row, 2, way); !mistake.empty()) return mistake;
    if (!points.contains(row[1])) return fmt::format("unknown point '{}'", row[1]);
    if (!fields[row[0]].emplace(row[1], way).second)
      return fmt::format("point '{}' stands twice in '{}'", row[1], row[0]);
    return {};
  });
  return fields;
}

void read_feature(const YamlEntry& entry, const PointNames& points, ShapeData& data) {
  const DataTable table(entry.value);
  Feature& feature = data.heads.features[entry.key];
  FeatureInfo& info = data.features.emplace_back();
  info.name = entry.key;
  table.read("meaning", info.meaning);
  if (const YamlValue* view = table.find("view"))
    load_name(*view, "view", {"front", "three_quarter", "side"}, info.view);
  const YamlValue* around = table.find("around");
  if (around != nullptr) load_datum(*around, info.around);
  if (around == nullptr || table.find("handles") != nullptr)
    for (const YamlEntry& handle : table.list("handles")) {
      if (check_point(handle, points)) load_datum(handle.value, feature.handles[handle.key]);
      if (around == nullptr) info.around.push_back(handle.key);
    }
  table.read_if("eye_size", feature.eye_size);
  table.read_if("eye_out", feature.eye_move_mm.x);
  table.read_if("eye_up", feature.eye_move_mm.y);
  table.read_if("eye_tilt", feature.eye_tilt_deg);
  table.read_if("ear_size", feature.ear_size);
  table.read_if("ear_out", feature.ear_out_deg);
  table.read_if("ear_in", feature.ear_in_deg);
  table.read_if("brow_thickness", feature.brow_thickness);
  table.read_if("character", feature.character);
}

}  // namespace

ShapeData load_shape_data(const std::filesystem::path& folder, const PointNames& points, Findings& findings) {
  ShapeData data;
  data.heads = load_heads(folder / "heads.yaml", findings);
  data.heads.fields = load_fields(folder / "fields.csv", points);
  const auto document = load_document(folder / "features.yaml", findings);
  if (!document) return data;
  const DataTable root(find_root(*document, findings));
  for (const YamlEntry& entry : root.list("features")) read_feature(entry, points, data);
  return data;
}

}  // namespace mien

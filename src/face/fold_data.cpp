#include "face/fold_data.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/yaml_file.hpp"

namespace mien {

namespace {

[[noreturn]] void fail(const YAML::Node& node, const std::string& message) {
  throw YAML::Exception(node.Mark(), message);
}

YAML::Node require(const YAML::Node& node, const char* key) {
  if (!node.IsMap() || !node[key]) fail(node, fmt::format("'{}' is missing", key));
  return node[key];
}

double load_number(const YAML::Node& node, double low, double high) {
  double value = 0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !(value >= low && value <= high))
    fail(node, fmt::format("found {}; expected a number from {} to {}",
                           node.IsScalar() ? "'" + node.Scalar() + "'" : "a list", low, high));
  return value;
}

double load_number(const YAML::Node& parent, const char* key, double low, double high) {
  return load_number(require(parent, key), low, high);
}

void check_keys(const YAML::Node& node, const std::vector<std::string>& keys) {
  if (!node.IsMap()) fail(node, fmt::format("expected '{}:'", fmt::join(keys, ":', '")));
  for (const auto& entry : node)
    if (std::find(keys.begin(), keys.end(), entry.first.Scalar()) == keys.end())
      fail(entry.first,
           fmt::format("unknown key '{}'; expected {}", entry.first.Scalar(), fmt::join(keys, ", ")));
}

// "brow.up-" -> brow, up, -1
Driver load_driver(const YAML::Node& node) {
  const std::string text = node.IsScalar() ? node.Scalar() : "";
  const std::size_t dot = text.find('.');
  if (dot == text.npos || (text.back() != '+' && text.back() != '-'))
    fail(node, fmt::format("'{}' is not a driver; expected area.move+ or area.move-", text));
  Driver driver{text.substr(0, dot), text.substr(dot + 1, text.size() - dot - 2),
                text.back() == '+' ? 1 : -1};
  for (const MoveInfo& info : kMoves)
    if (info.area == driver.area && info.move == driver.move) return driver;
  fail(node, fmt::format("unknown move '{}.{}'", driver.area, driver.move));
}

// `[brow.up+]` or `[0.5, lips.upper+, brow.up-]`
FoldDrive load_drive(const YAML::Node& node) {
  if (!node.IsSequence()) fail(node, "expected a list such as [0.5, lips.upper+, brow.up-]");
  FoldDrive drive;
  for (const YAML::Node& factor : node)
    if (double share = 0; factor.IsScalar() && YAML::convert<double>::decode(factor, share))
      drive.share = load_number(factor, -4, 4);
    else
      drive.drivers.push_back(load_driver(factor));
  if (drive.drivers.empty()) fail(node, "a drive without a move; expected one such as brow.up+");
  return drive;
}

// `E5_2` or `[E5_2, E5_3, 0.4]`
FoldPoint load_point(const YAML::Node& node) {
  if (node.IsScalar()) return {node.Scalar(), node.Scalar(), 0};
  if (!node.IsSequence() || node.size() != 3) fail(node, "expected a point or [point, point, share]");
  return {node[0].as<std::string>(), node[1].as<std::string>(), load_number(node[2], -1, 2)};
}

FoldLine load_line(const YAML::Node& node) {
  check_keys(node, {"through", "depths"});
  FoldLine line;
  line.file_line = node.Mark().line + 1;
  for (const YAML::Node& point : require(node, "through")) line.through.push_back(load_point(point));
  if (line.through.size() < 2) fail(node, "a line through fewer than 2 points");
  for (const YAML::Node& depth : require(node, "depths")) line.depths.push_back(load_number(depth, 0, 1));
  if (line.depths.empty()) fail(node, "a line without depths");
  return line;
}

FoldSet load_set(const std::string& name, const YAML::Node& node) {
  check_keys(node, {"drive", "from", "to", "rest", "depth_mm", "width_mm", "rolls", "spread", "uneven",
                    "across_mm", "lines"});
  FoldSet set;
  set.name = name;
  for (const YAML::Node& drive : require(node, "drive")) set.drives.push_back(load_drive(drive));
  set.from = load_number(node, "from", 0, 1);
  set.to = load_number(node, "to", 0, 2);
  if (set.to < set.from + 0.1) fail(node["to"], "'to' is to be at least 0.1 above 'from', or folds pop");
  if (node["rest"]) set.rest = load_number(node["rest"], 0, 1);
  set.depth_mm = load_number(node, "depth_mm", 0, 4);
  set.width_mm = load_number(node, "width_mm", 0.5, 10);
  const YAML::Node rolls = require(node, "rolls");
  if (!rolls.IsSequence() || rolls.size() != 2) fail(rolls, "expected [left, right]");
  set.rolls = {load_number(rolls[0], -1, 2), load_number(rolls[1], -1, 2)};
  set.spread = load_number(node, "spread", 1, 6);
  if (node["uneven"]) set.uneven = load_number(node, "uneven", 0, 2);
  if (node["across_mm"]) set.across_mm = load_number(node["across_mm"], 0, 40);
  for (const YAML::Node& line : require(node, "lines")) set.lines.push_back(load_line(line));
  return set;
}

FoldUnevenness load_unevenness(const YAML::Node& node) {
  check_keys(node, {"seed", "along_mm", "aside_mm", "broken", "shared_mm"});
  FoldUnevenness uneven;
  uneven.seed = static_cast<std::uint32_t>(load_number(node, "seed", 0, 1e6));
  uneven.along_mm = load_number(node, "along_mm", 2, 50);
  uneven.aside_mm = load_number(node, "aside_mm", 0, 3);
  uneven.broken = load_number(node, "broken", 0, 1);
  uneven.shared_mm = load_number(node, "shared_mm", 1, 30);
  return uneven;
}

FoldData load_root(const YAML::Node& root) {
  check_keys(root, {"ages", "ages_at_rest", "characters", "uneven", "edge", "folds"});
  FoldData data;
  for (const auto& age : require(root, "ages")) data.ages[age.first.Scalar()] = load_number(age.second, 0, 2);
  if (root["ages_at_rest"])
    for (const auto& age : root["ages_at_rest"])
      data.ages_at_rest[age.first.Scalar()] = load_number(age.second, 0, 1);
  const YAML::Node characters = require(root, "characters");
  data.female = load_number(characters, "female", 0, 1);
  data.male = load_number(characters, "male", 0, 1);
  if (root["uneven"]) data.uneven = load_unevenness(root["uneven"]);
  data.edge = load_number(root, "edge", 0.3, 3);
  for (const auto& set : require(root, "folds"))
    data.sets.push_back(load_set(set.first.Scalar(), set.second));
  return data;
}

}  // namespace

FoldData load_fold_data(const std::filesystem::path& file) { return read_yaml_file(file, load_root); }

}  // namespace mien

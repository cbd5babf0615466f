// Reading templates/head/folds.yaml.
#include <fmt/format.h>

#include "config/data_table.hpp"
#include "config/fold_data.hpp"

namespace mien {

namespace {

// A number that must be there.
void read_number(const DataTable& table, const char* key, double low, double high, double& into) {
  if (const YamlValue* value = table.require(key)) load_number(*value, low, high, into);
}

// A number that may be there.
void read_number_if(const DataTable& table, const char* key, double low, double high, double& into) {
  if (const YamlValue* value = table.find(key)) load_number(*value, low, high, into);
}

// `[brow.up+]` or `[0.5, lips.upper+, brow.up-]`
FoldDrive read_drive(const YamlValue& value) {
  FoldDrive drive;
  for (const YamlValue& factor : load_list(value, "a list such as [0.5, lips.upper+, brow.up-]")) {
    const YamlNode& node = find_node(factor);
    if (node.kind == NodeKind::text && parse_number(node.text))
      load_number(factor, -4, 4, drive.share);
    else
      load_driver(factor, drive.drivers.emplace_back());
  }
  if (drive.drivers.empty()) add_mistake(value, "a drive without a move; expected one such as brow.up+");
  return drive;
}

// `E5_2` or `[E5_2, E5_3, 0.4]`
FoldPoint read_point(const YamlValue& value, const PointNames& points) {
  FoldPoint point;
  if (find_node(value).kind == NodeKind::text) {
    load_datum(value, point.from);
    check_point(value, point.from, points);
    point.to = point.from;
    return point;
  }
  const std::vector<YamlValue> items = load_row(value, 3);
  if (items.empty()) return point;
  if (load_datum(items[0], point.from)) check_point(items[0], point.from, points);
  if (load_datum(items[1], point.to)) check_point(items[1], point.to, points);
  load_number(items[2], -1, 2, point.share);
  return point;
}

FoldLine read_line(const YamlValue& value, const PointNames& points) {
  const DataTable table(value);
  FoldLine line;
  line.file_line = value.spot.line;
  if (const YamlValue* through = table.require("through"))
    for (const YamlValue& point : load_list(*through, "a list of points"))
      line.through.push_back(read_point(point, points));
  if (line.through.size() < 2) table.fail("a line through fewer than 2 points; expected 2 at least");
  if (const YamlValue* depths = table.require("depths"))
    for (const YamlValue& depth : load_list(*depths, "a list of numbers"))
      load_number(depth, 0, 1, line.depths.emplace_back());
  if (line.depths.empty()) table.fail("a line without depths; expected one at least");
  if (const YamlValue* ink = table.find("ink"))
    for (const YamlValue& width : load_list(*ink, "a list of numbers"))
      load_number(width, 0, 1, line.ink.emplace_back());
  return line;
}

std::vector<FoldDrive> read_drives(const YamlValue& value) {
  std::vector<FoldDrive> drives;
  for (const YamlValue& drive : load_list(value, "a list of drives")) drives.push_back(read_drive(drive));
  return drives;
}

FoldSet read_set(const YamlEntry& entry, const PointNames& points) {
  const DataTable table(entry.value);
  FoldSet set;
  set.name = entry.key;
  if (const YamlValue* drives = table.require("drive")) set.drives = read_drives(*drives);
  if (const YamlValue* drives = table.find("stretched")) set.stretched = read_drives(*drives);
  read_number(table, "from", 0, 1, set.from);
  read_number(table, "to", 0, 2, set.to);
  if (set.to < set.from + 0.1)
    table.fail(fmt::format("'to' is {:g}; expected {:g} at least, 0.1 above 'from', or folds pop", set.to,
                           set.from + 0.1));
  read_number_if(table, "rest", 0, 1, set.rest);
  read_number_if(table, "always", 0, 1, set.always);
  read_number(table, "depth_mm", 0, 4, set.depth_mm);
  read_number(table, "width_mm", 0.5, 10, set.width_mm);
  if (const YamlValue* rolls = table.require("rolls")) {
    const std::vector<YamlValue> items = load_row(*rolls, 2);
    for (std::size_t i = 0; i < items.size(); ++i) load_number(items[i], -1, 2, set.rolls[i]);
  }
  read_number(table, "spread", 1, 6, set.spread);
  read_number_if(table, "uneven", 0, 2, set.uneven);
  read_number_if(table, "edge", 0.1, 1, set.edge);
  read_number_if(table, "ink", 0, 2, set.ink);
  read_number_if(table, "across_mm", 0, 40, set.across_mm);
  if (const YamlValue* lines = table.require("lines"))
    for (const YamlValue& line : load_list(*lines, "a list of lines"))
      set.lines.push_back(read_line(line, points));
  return set;
}

void read_unevenness(const DataTable& table, FoldUnevenness& uneven) {
  double seed = 0;
  read_number(table, "seed", 0, 1e6, seed);
  uneven.seed = static_cast<std::uint32_t>(seed);
  read_number(table, "along_mm", 2, 50, uneven.along_mm);
  read_number(table, "aside_mm", 0, 3, uneven.aside_mm);
  read_number(table, "broken", 0, 1, uneven.broken);
  read_number(table, "shared_mm", 1, 30, uneven.shared_mm);
}

}  // namespace

FoldData load_fold_data(const std::filesystem::path& file, const PointNames& points, Findings& findings) {
  FoldData data;
  data.file = file.string();
  const auto document = load_document(file, findings);
  if (!document) return data;
  const DataTable root(find_root(*document, findings));
  for (const YamlEntry& age : root.list("ages"))
    if (check_name(age, "age", kAges)) load_number(age.value, 0, 2, data.ages[age.key]);
  if (root.find("ages_at_rest") != nullptr)
    for (const YamlEntry& age : root.list("ages_at_rest"))
      if (check_name(age, "age", kAges)) load_number(age.value, 0, 1, data.ages_at_rest[age.key]);
  const DataTable characters = root.at("characters");
  read_number(characters, "female", 0, 1, data.female);
  read_number(characters, "male", 0, 1, data.male);
  if (const YamlValue* uneven = root.find("uneven")) read_unevenness(DataTable(*uneven), data.uneven);
  read_number(root, "edge", 0.3, 3, data.edge);
  for (const YamlEntry& entry : root.list("folds")) data.sets.push_back(read_set(entry, points));
  return data;
}

}  // namespace mien

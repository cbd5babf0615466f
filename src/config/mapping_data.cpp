#include "config/mapping_data.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "config/data_table.hpp"
#include "config/expressions.hpp"
#include "config/ledger.hpp"
#include "core/error.hpp"

namespace mien {

namespace {

// Our areas cannot do more than they can: a unit of another program may ask for more at 1.
constexpr double kMostMapped = 2;

struct MappingNames {
  std::map<std::string, std::vector<std::size_t>, std::less<>> moves;  // "brow.left.up", "brows.up"
  Names move_names;
};

MappingNames list_mapping_names() {
  MappingNames names;
  const auto add = [&](const std::string& name, std::size_t move) {
    if (!names.moves.contains(name)) names.move_names.push_back(name);
    names.moves[name].push_back(move);
  };
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    add(name_move(i), i);
    if (kMoves[i].side != Side::none) add(name_move(i, true), i);
  }
  return names;
}

void read_moves(const YamlValue& value, const MappingNames& names, std::vector<MappedMove>& into) {
  for (const YamlEntry& entry : load_free_mapping(value, "moves such as {brows.up: 0.5}")) {
    double number = 0;
    if (!check_name(entry, "move", names.move_names) ||
        !load_number(entry.value, -kMostMapped, kMostMapped, number))
      continue;
    for (const std::size_t move : names.moves.find(entry.key)->second) into.push_back({move, number});
  }
}

// The units that a name of `like` means: one, or both sides of its stem.
std::vector<std::size_t> find_like(const Mapping& mapping, const std::string& name) {
  if (const auto unit = find_unit(mapping, name)) return {*unit};
  const auto left = find_unit(mapping, name + "Left"), right = find_unit(mapping, name + "Right");
  if (left && right) return {*left, *right};
  return {};
}

void append_like(const YamlValue& value, const Mapping& like, MappedUnit& unit) {
  std::map<std::size_t, double> moves;
  double lost_mm2 = 0;
  for (const YamlEntry& entry : load_free_mapping(value, "units such as {jawOpen: 0.5}")) {
    double weight = 0;
    const std::vector<std::size_t> units = find_like(like, entry.key);
    if (units.empty()) {
      Names names;
      for (const MappedUnit& known : like.units) names.push_back(known.name);
      check_name(entry, "unit", names);
    }
    if (!load_number(entry.value, 0, kMostMapped, weight)) continue;
    for (const std::size_t i : units) {
      const MappedUnit& known = like.units[i];
      for (const MappedMove& moved : known.moves) moves[moved.move] += weight * moved.value;
      unit.motion_mm2 += weight * weight * known.motion_mm2;
      lost_mm2 += weight * weight * known.motion_mm2 * std::min(known.residual, 1.0);
    }
  }
  for (const auto& [move, number] : moves) unit.moves.push_back({move, number});
  unit.residual = unit.motion_mm2 > 0 ? lost_mm2 / unit.motion_mm2 : unit.moves.empty() ? 1 : 0;
}

void append_pose(const Pose& pose, std::vector<MappedMove>& into) {
  for (std::size_t i = 0; i < kMoveCount; ++i)
    if (pose.values[i] != 0) into.push_back({i, pose.values[i]});
}

MappedUnit read_unit(const YamlEntry& entry, const MappingNames& names, const Mapping& like,
                     const ExpressionBook& libraries, std::optional<YamlValue>& corrects) {
  MappedUnit unit{entry.key};
  const DataTable table(entry.value);
  if (const YamlValue* units = table.find("like")) append_like(*units, like, unit);
  if (const YamlValue* moves = table.find("moves")) {
    unit.moves.clear();
    read_moves(*moves, names, unit.moves);
  }
  if (const YamlValue* express = table.find("express")) {
    std::string name;
    if (load_datum(*express, name)) {
      if (const auto index = find_expression(libraries, name))
        append_pose(libraries.expressions[*index].pose, unit.moves);
      else
        add_mistake(*express, describe_unknown_expression(libraries, name));
    }
    unit.residual = 0;
  }
  constexpr double kMostMotion_mm2 = 1000, kMostResidual = 10;
  if (const YamlValue* motion = table.find("motion"))
    load_number(*motion, 0, kMostMotion_mm2, unit.motion_mm2);
  if (const YamlValue* residual = table.find("residual"))
    load_number(*residual, 0, kMostResidual, unit.residual);
  if (const YamlValue* other = table.find("corrects")) corrects = *other;
  return unit;
}

Names list_unit_names(const Mapping& mapping) {
  Names names;
  for (const MappedUnit& unit : mapping.units) names.push_back(unit.name);
  return names;
}

// What a unit corrects, looked up when all units are there.
struct Corrected {
  std::size_t unit = 0;
  YamlValue value;
};

void read_corrected(const std::vector<Corrected>& told, Mapping& mapping) {
  for (const auto& [unit, value] : told) {
    std::string name;
    if (load_datum(value, name) && check_name(value, name, "unit", list_unit_names(mapping)))
      mapping.units[unit].corrects = find_unit(mapping, name);
  }
}

// The other mapping's units besides.
void append_all(const Mapping& like, Mapping& mapping) {
  const std::size_t before = mapping.units.size();
  for (MappedUnit unit : like.units) {
    if (unit.corrects) *unit.corrects += before;
    mapping.units.push_back(std::move(unit));
  }
}

void read_blends(const DataTable& root, const MappingNames& names, Mapping& mapping) {
  const YamlValue* blends = root.find("blends");
  if (blends == nullptr) return;
  for (const YamlValue& item : load_list(*blends, "a list of blends")) {
    const DataTable table(item);
    MappedBlend blend;
    std::vector<std::string> units;
    table.read("units", units);
    for (const std::string& unit : units)
      if (check_name(item, unit, "unit", list_unit_names(mapping)))
        blend.units.push_back(*find_unit(mapping, unit));
    if (const YamlValue* moves = table.require("moves")) read_moves(*moves, names, blend.moves);
    if (blend.units.size() == units.size()) mapping.blends.push_back(std::move(blend));
  }
}

void read_known(const DataTable& root, const ExpressionBook& libraries, MappingData& data) {
  const YamlValue* known = root.find("known");
  if (known == nullptr) return;
  for (const YamlEntry& entry : load_free_mapping(*known, "notations and expressions")) {
    std::string name;
    if (!load_datum(entry.value, name)) continue;
    if (const auto index = find_expression(libraries, name))
      data.known.push_back({entry.key, name, libraries.expressions[*index].pose});
    else
      add_mistake(entry.value, describe_unknown_expression(libraries, name));
  }
}

void read_mapping(const std::filesystem::path& file, const std::string& name, const MappingNames& names,
                  const ExpressionBook& libraries, Findings& findings, MappingData& data) {
  const auto document = load_document(file, findings);
  if (!document) return;
  const DataTable root(find_root(*document, findings));
  Mapping mapping;
  if (root.read("mapping", mapping.name) && mapping.name != name)
    root.fail(fmt::format("mapping '{}' stands in another file's name; expected '{}'", mapping.name, name));
  root.read("source", mapping.source);
  std::string like;
  root.read_if("like_of", like);
  const auto known = data.mappings.find(like);
  static const Mapping kNoMapping{};
  const Mapping& alike = known == data.mappings.end() ? kNoMapping : known->second;
  std::vector<Corrected> told;
  for (const YamlEntry& entry : root.list("units")) {
    std::optional<YamlValue> corrects;
    mapping.units.push_back(read_unit(entry, names, alike, libraries, corrects));
    if (corrects) told.push_back({mapping.units.size() - 1, *corrects});
  }
  read_corrected(told, mapping);
  bool is_all = false;
  root.read_if("all_of_like", is_all);
  if (is_all) append_all(alike, mapping);
  read_blends(root, names, mapping);
  read_known(root, libraries, data);
  data.mappings[name] = std::move(mapping);
}

// `brow.up: 12.6`: of both sides.
void read_ways(const std::filesystem::path& file, Findings& findings, MappingData& data) {
  const auto document = load_document(file, findings);
  if (!document) return;
  const DataTable root(find_root(*document, findings));
  const DataTable ways = root.at("ways_mm");
  for (std::size_t i = 0; i < kMoveCount; ++i)
    if (const YamlValue* way = ways.require(fmt::format("{}.{}", kMoves[i].area, kMoves[i].move)))
      load_number(*way, 0, 100, data.ways_mm[i]);
  const DataTable gaze = root.at("gaze_deg");
  constexpr std::array kWays{"side", "up", "down"};
  for (std::size_t i = 0; i < kWays.size(); ++i)
    if (const YamlValue* most = gaze.require(kWays[i])) load_number(*most, 1, 90, data.moves.gaze_deg[i]);
}

TakeReach build_take_reach() {
  TakeReach table;
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    table.ranges.push_back({kMoves[i].low, kMoves[i].high});
    if (kMoves[i].of == Area::eye) table.gaze.push_back({i, kMoves[i].move == "up"});
    for (const auto& [way, end] :
         {std::pair{kMoves[i].plus, kMoves[i].high}, {kMoves[i].minus, kMoves[i].low}})
      if (!way.name.empty()) table.ways[name_way(i, end)] = {i, end};
  }
  return table;
}

}  // namespace

const Mapping& find_mapping(const MappingData& data, std::string_view name) {
  const auto found = data.mappings.find(name);
  if (found == data.mappings.end())
    throw RunError(fmt::format("the data folder has no configs/mappings/{}.yaml", name));
  return found->second;
}

MappingDataPointer load_mapping_data(const std::filesystem::path& data_folder,
                                     const ExpressionBook& libraries, Findings& findings) {
  auto data = std::make_shared<MappingData>();
  data->moves = build_take_reach();
  const std::filesystem::path folder = data_folder / "configs/mappings";
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) return data;
  const MappingNames names = list_mapping_names();
  read_ways(folder / "moves.yaml", findings, *data);
  for (const char* name : {"arkit", "facs", "makehuman", "vrm"})  // others are like the first
    read_mapping(folder / (std::string(name) + ".yaml"), name, names, libraries, findings, *data);
  return data;
}

}  // namespace mien

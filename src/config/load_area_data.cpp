// Reading templates/head/areas.yaml.
#include <fmt/format.h>

#include <algorithm>

#include "config/area_data.hpp"
#include "config/data_table.hpp"

namespace mien {

namespace {

const Names kUnits{"eye_separation", "eye_nose", "mouth_nose", "mouth_width", "iris"};

struct AreaReader {
  const PointNames& points;
  Names anchors;  // the names of anchor sets
};

// A point, or a pattern of several, which is taken as it is.
void check_pattern(const YamlValue& value, const std::string& pattern, const PointNames& points) {
  const std::string bare = pattern.starts_with('!') ? pattern.substr(1) : pattern;
  if (bare.find('*') == bare.npos && bare.find("..") == bare.npos) check_point(value, bare, points);
}

void read_patterns(const YamlValue& value, const PointNames& points, PointPatterns& into) {
  for (const YamlValue& item : load_list(value, "a list of points"))
    if (std::string pattern; load_datum(item, pattern)) {
      check_pattern(item, pattern, points);
      into.push_back(pattern);
    }
}

// Mouth columns times the share of each ring, as handles "M2_5", where there is none yet.
void add_columns(const YamlMapping& columns, const std::map<std::string, double>& rows,
                 const PointNames& points, Handles& handles) {
  for (const YamlEntry& column : columns) {
    glm::dvec3 way{0};
    if (!load_datum(column.value, way)) continue;
    for (const auto& [row, share] : rows) {
      const std::string point = row + "_" + column.key;
      if (check_point(column.value, point, points)) handles.try_emplace(point, share * way);
    }
  }
}

MoveTable read_move(const AreaReader& reader, const YamlEntry& entry, const DataTable& table) {
  MoveTable move;
  const std::size_t dot = entry.key.find('.');
  move.area = dot == entry.key.npos ? "" : entry.key.substr(0, dot);
  move.move = dot == entry.key.npos ? entry.key : entry.key.substr(dot + 1);
  table.read("sided", move.is_sided);
  table.read_if("odd", move.is_odd);
  if (table.read("unit", move.units))
    for (const std::string& unit : move.units) check_name(*table.find("unit"), unit, "face unit", kUnits);
  if (table.read("anchors", move.anchors))
    check_name(*table.find("anchors"), move.anchors, "anchor set", reader.anchors);
  if (table.find("plus") != nullptr) move.plus = load_handles(table.list("plus"), reader.points);
  if (table.find("minus") != nullptr) move.minus = load_handles(table.list("minus"), reader.points);
  if (table.find("even") != nullptr) move.even = load_handles(table.list("even"), reader.points);
  std::map<std::string, double> rows;
  table.read_if("rows", rows);
  if (table.find("columns_plus") != nullptr)
    add_columns(table.list("columns_plus"), rows, reader.points, move.plus);
  if (table.find("columns_minus") != nullptr)
    add_columns(table.list("columns_minus"), rows, reader.points, move.minus);
  if (table.find("columns_even") != nullptr)
    add_columns(table.list("columns_even"), rows, reader.points, move.even);
  if (table.find("yields") != nullptr)
    for (const YamlEntry& other : table.list("yields")) {
      auto& [to, share] = move.yields.emplace_back();
      if (const auto driver = find_driver(other.key))
        to = *driver;
      else
        add_mistake(other.value, fmt::format("'{}' is no move and its sign; expected one such as brow.up+",
                                             show_word(other.key)));
      load_datum(other.value, share);
    }
  if (move.plus.empty() && move.minus.empty()) table.fail("no handle says where skin goes; expected one");
  return move;
}

void read_moves(const AreaReader& reader, const DataTable& root, AreaData& data) {
  for (const YamlEntry& entry : root.list("moves")) {
    check_move(entry);
    data.moves.push_back(read_move(reader, entry, DataTable(entry.value)));
  }
  for (const YamlEntry& entry : root.list("correctives")) {
    const DataTable table(entry.value);
    CorrectiveTable corrective{read_move(reader, entry, table), {}};
    if (const YamlValue* drive = table.require("drive"))
      for (const YamlValue& driver : load_list(*drive, "a list such as [lips.upper+, brow.up-]"))
        load_driver(driver, corrective.drivers.emplace_back());
    data.correctives.push_back(std::move(corrective));
  }
}

void read_rings(const DataTable& table, const char* key, const PointNames& points,
                std::map<std::string, double>& into) {
  for (const YamlEntry& entry : table.list(key))
    if (check_point(entry.value, entry.key + "_0", points)) load_datum(entry.value, into[entry.key]);
}

LidData read_lids(const DataTable& table, const PointNames& points) {
  LidData lids;
  read_rings(table, "rows_upper", points, lids.rows_upper);
  read_rings(table, "rows_lower", points, lids.rows_lower);
  for (const auto& [ring, share] : lids.rows_upper)
    if (!lids.rows_lower.contains(ring))
      table.fail(fmt::format("'rows_lower' has no '{}'; expected the rings of 'rows_upper'", ring));
  read_rings(table, "rows_shut", points, lids.rows_shut);
  table.read("column_taper", lids.column_taper);
  const DataTable slide = table.at("slide");
  slide.read("upper", lids.slide_upper);
  slide.read("lower", lids.slide_lower);
  table.read("meeting", lids.meeting);
  table.read("least_gap_deg", lids.least_gap_deg);
  table.read("wide_deg", lids.wide_deg);
  table.read("raised_deg", lids.raised_deg);
  table.read("raised_bulge", lids.raised_bulge);
  const DataTable follow = table.at("gaze_follow");
  follow.read("up", lids.follow_up);
  follow.read("down", lids.follow_down);
  follow.read("lower", lids.follow_lower);
  const DataTable fold = table.at("fold");
  fold.read("least", lids.fold_least);
  fold.read("forward", lids.fold_forward);
  read_rings(table, "least_radius", points, lids.least_radius);
  return lids;
}

using PointShares = std::vector<std::pair<std::string, double>>;

PointShares read_point_shares(const DataTable& table, const char* key, const PointNames& points) {
  PointShares shares;
  for (const YamlEntry& entry : table.list(key)) {
    check_pattern(entry.value, entry.key, points);
    load_datum(entry.value, shares.emplace_back(entry.key, 0).second);
  }
  return shares;
}

JawData read_jaw(const DataTable& table, const PointNames& points) {
  JawData jaw;
  table.read("axis", jaw.axis);
  table.read("degrees", jaw.degrees);
  table.read("straight", jaw.straight);
  table.read("forward", jaw.forward);
  table.read("aside", jaw.aside);
  table.read("protruded", jaw.protruded);
  table.read("rolled", jaw.rolled);
  table.read("columns", jaw.columns);
  table.read("mb2", jaw.mb2);
  table.read("m6_factor", jaw.m6_factor);
  jaw.points = read_point_shares(table, "points", points);
  if (const YamlValue* zero = table.require("zero")) read_patterns(*zero, points, jaw.zero);
  jaw.shut = read_point_shares(table, "shut", points);
  if (const YamlValue* unshut = table.require("unshut")) read_patterns(*unshut, points, jaw.unshut);
  jaw.corner_in = load_handles(table.list("corner_in"), points);
  return jaw;
}

GiveWayData read_give_way(const DataTable& table, const PointNames& points) {
  GiveWayData data;
  table.read("from", data.from);
  table.read("least", data.least);
  table.read("forward", data.forward);
  if (const YamlValue* lines = table.require("lines"))
    for (const YamlValue& line : load_list(*lines, "a list of lists of points"))
      read_patterns(line, points, data.lines.emplace_back());
  return data;
}

LimitPlace read_limit(const DataTable& table, const PointNames& points) {
  LimitPlace limit;
  if (table.read("at", limit.point) && limit.point != "pupil" && limit.point != kTonguePlace)
    check_point(*table.find("at"), limit.point, points);
  const YamlValue* axis = table.find("axis");
  if (axis == nullptr) return limit;
  std::string word;
  if (load_name(*axis, "axis", {"x", "y", "z"}, word)) limit.axis = word[0] - 'x';
  if (const YamlValue* unit = table.require("unit")) load_name(*unit, "face unit", kUnits, limit.unit);
  table.read_if("plus_mm", limit.plus_mm);
  table.read_if("minus_mm", limit.minus_mm);
  return limit;
}

void read_limits(const DataTable& table, const PointNames& points, AreaData& data) {
  for (const MoveInfo& move : kMoves) {
    const std::string name = fmt::format("{}.{}", move.area, move.move);
    if (data.limits.contains(name)) continue;  // of the other side
    data.limits[name] = read_limit(table.at(name), points);
  }
}

}  // namespace

bool check_move(const YamlEntry& entry) {
  Names names;
  for (const MoveInfo& move : kMoves)
    if (move.side != Side::right) names.push_back(fmt::format("{}.{}", move.area, move.move));
  return check_name(entry, "move", names);
}

std::optional<Driver> find_driver(std::string_view text) {
  if (!text.ends_with('+') && !text.ends_with('-')) return std::nullopt;
  for (const MoveInfo& move : kMoves)
    if (text.substr(0, text.size() - 1) == fmt::format("{}.{}", move.area, move.move))
      return Driver{std::string(move.area), std::string(move.move), text.back() == '+' ? 1 : -1};
  return std::nullopt;
}

bool load_driver(const YamlValue& value, Driver& into) {
  std::string text;
  if (!load_text(value, "a move and its sign, such as brow.up+", text)) return false;
  const auto driver = find_driver(text);
  if (driver)
    into = *driver;
  else
    add_unexpected(value, "a move and its sign, such as brow.up+");
  return driver.has_value();
}

AreaData load_area_data(const std::filesystem::path& file, const PointNames& points, Findings& findings) {
  AreaData data;
  const auto document = load_document(file, findings);
  if (!document) return data;
  const DataTable root(find_root(*document, findings));
  read_limits(root.at("limits"), points, data);
  AreaReader reader{points, {}};
  for (const YamlEntry& entry : root.list("anchors")) {
    reader.anchors.push_back(entry.key);
    read_patterns(entry.value, points, data.anchors[entry.key]);
  }
  if (!data.anchors.contains("always"))
    root.fail("'anchors' has no 'always'; expected the points that no move moves");
  if (!data.anchors.contains("corner"))
    root.fail("'anchors' has no 'corner'; expected what the jaw's corner_in is solved with");
  read_moves(reader, root, data);
  for (const YamlEntry& entry : root.list("past_limits")) {
    const auto move = find_driver(entry.key);
    PastLimit limit;
    if (!move)
      add_mistake(entry.value, fmt::format("'{}' is no move and its sign; expected one such as brow.up+",
                                           show_word(entry.key)));
    else if (limit.move = *move; load_datum(entry.value, limit.reach))
      data.past_limits.push_back(limit);
  }
  data.lids = read_lids(root.at("lids"), points);
  const DataTable eyes = root.at("eyes");
  eyes.read("up_deg", data.eye_up_deg);
  eyes.read("down_deg", data.eye_down_deg);
  eyes.read("side_deg", data.eye_side_deg);
  data.jaw = read_jaw(root.at("jaw"), points);
  const DataTable lips = root.at("lip_contact");
  read_rings(lips, "rows", points, data.lip_rows);
  lips.read("seal_until_mm", data.seal_until_mm);
  read_rings(lips, "under_nose", points, data.philtrum_rows);
  data.give_way = read_give_way(root.at("give_way"), points);
  const DataTable turn = root.at("turn");
  turn.read("pivot", data.turn_pivot);
  turn.read("rows", data.turn_rows);
  return data;
}

}  // namespace mien

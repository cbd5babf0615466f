#include "head/part_numbers.hpp"

#include <yaml-cpp/yaml.h>

#include <string>

#include "core/data.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/yaml_file.hpp"

namespace mien {

namespace {

// A mapping of the file and the way to it, for messages.
struct Table {
  YAML::Node node;
  std::string origin;  // "parts.yaml: eye"

  Table at(const char* key) const {
    const YAML::Node child = node[key];
    if (!child || !child.IsMap()) throw RunError(origin + "." + key + ": a table is missing here");
    return {child, origin + "." + key};
  }
  template <typename T>
  void read(const char* key, T& value) const {
    const YAML::Node child = node[key];
    if (!child) throw RunError(origin + "." + key + ": a value is missing here");
    try {
      value = child.as<T>();
    } catch (const YAML::Exception&) {
      throw RunError(origin + "." + key + ": not the numbers expected here");
    }
  }
};

KnobNumbers read_knob(const Table& table) {
  KnobNumbers knob;
  table.read("mix", knob.mix);
  table.read("sink", knob.sink_mm);
  table.read("half", knob.half_mm);
  return knob;
}

EyeNumbers read_eye(const Table& table) {
  EyeNumbers eye;
  table.read("ball", eye.ball_mm);
  table.read("outward", eye.outward_deg);
  table.read("limbus", eye.limbus_mm);
  table.read("iris_edge", eye.iris_edge_mm);
  table.read("iris_inner", eye.iris_inner_mm);
  table.read("pupil_floor", eye.pupil_floor_mm);
  table.read("cornea_rise", eye.cornea_rise_mm);
  table.read("cornea_edge", eye.cornea_edge_mm);
  table.read("fibres", eye.fibres);
  const Table tear = table.at("tear");
  tear.read("first", eye.tear.first);
  tear.read("last", eye.tear.last);
  tear.read("mix", eye.tear.mix);
  tear.read("above", eye.tear.above_mm);
  tear.read("radius", eye.tear.radius_mm);
  tear.read("rings", eye.tear.rings);
  eye.caruncle = read_knob(table.at("caruncle"));
  eye.plica = read_knob(table.at("plica"));
  return eye;
}

LashRowNumbers read_lash_row(const Table& table) {
  LashRowNumbers row;
  table.read("count", row.count);
  table.read("from", row.from);
  table.read("to", row.to);
  table.read("shortest", row.shortest_mm);
  table.read("longest", row.longest_mm);
  table.read("radius", row.radius_mm);
  table.read("fan", row.fan);
  table.read("out", row.out);
  table.read("up", row.up);
  return row;
}

BrowCoat read_coat(const Table& table) {
  BrowCoat coat;
  table.read("hairs", coat.hairs);
  table.read("radius", coat.radius_mm);
  table.read("lift", coat.lift_mm);
  if (coat.lift_mm.size() < 2) throw RunError(table.origin + ".lift: a hair has at least two rings");
  return coat;
}

BrowNumbers read_brow(const Table& table) {
  BrowNumbers brow;
  table.read("line", brow.line_mm);
  table.read("grown", brow.grown_mm);
  table.read("infant_blend", brow.infant_blend);
  table.read("under_blend", brow.under_blend);
  table.read("paint", brow.paint);
  table.read("infant_paint", brow.infant_paint);
  brow.over = read_coat(table.at("over"));
  brow.under = read_coat(table.at("under"));
  table.read("station", brow.station);
  const auto read_stations = [&](const char* key, std::vector<double>& values) {
    table.read(key, values);
    if (values.size() != brow.station.size())
      throw RunError(table.origin + "." + key + ": not as many numbers as 'station' has");
  };
  read_stations("above", brow.above_mm);
  read_stations("half", brow.half_mm);
  read_stations("density", brow.density);
  read_stations("length", brow.length_mm);
  read_stations("lower_angle", brow.lower_angle_deg);
  read_stations("upper_angle", brow.upper_angle_deg);
  return brow;
}

TeethRowNumbers read_teeth_row(const Table& table) {
  TeethRowNumbers row;
  table.read("gum", row.gum_mm);
  table.read("edge", row.edge_mm);
  table.read("lean", row.lean_mm);
  table.read("inset", row.inset_mm);
  table.read("width", row.width_mm);
  table.read("thick", row.thick_mm);
  table.read("table", row.table_mm);
  table.read("rise", row.rise_mm);
  table.read("point", row.point_mm);
  table.read("cusps", row.cusps);
  table.read("neck", row.neck_mm);
  table.read("turn", row.turn_deg);
  table.read("milk", row.milk);
  table.read("milk_years", row.milk_years);
  table.read("shed_years", row.shed_years);
  table.read("years", row.years);
  return row;
}

MouthNumbers read_mouth(const Table& table) {
  MouthNumbers mouth;
  table.read("corner", mouth.corner_mm);
  table.read("setback", mouth.setback_mm);
  table.read("clearance", mouth.clearance_mm);
  const Table arch = table.at("arch");
  arch.read("depth", mouth.arch.depth_mm);
  arch.read("square", mouth.arch.square);
  arch.read("half", mouth.arch.half_mm);
  mouth.upper = read_teeth_row(table.at("upper"));
  mouth.lower = read_teeth_row(table.at("lower"));
  table.read("growing", mouth.growing_years);
  table.read("milk_height", mouth.milk_height);
  table.read("milk_space", mouth.milk_space_mm);
  table.read("years", mouth.years);
  table.read("scan_years", mouth.scan_years);
  if (mouth.scan_years.empty())
    throw RunError(table.origin + ".scan_years: a pair of numbers is missing here");
  table.read("scallop", mouth.scallop_mm);
  table.read("ridge", mouth.ridge_mm);
  table.read("gum_thick", mouth.gum_thick_mm);
  const Table tongue = table.at("tongue");
  tongue.read("half", mouth.tongue.half_mm);
  tongue.read("tip", mouth.tongue.tip_mm);
  tongue.read("top", mouth.tongue.top_mm);
  tongue.read("rise", mouth.tongue.rise_mm);
  tongue.read("back", mouth.tongue.back_mm);
  tongue.read("room", mouth.tongue.room_mm);
  const Table bag = table.at("bag");
  bag.read("front", mouth.bag.front_mm);
  bag.read("back", mouth.bag.back_mm);
  return mouth;
}

}  // namespace

PartNumbers load_part_numbers(const std::filesystem::path& file) {
  const YAML::Node root = load_yaml_file(file);
  if (!root.IsMap()) throw RunError(file.string() + ": a table is missing here");
  const auto table = [&](const char* key) {
    const YAML::Node child = root[key];
    if (!child || !child.IsMap()) throw RunError(file.string() + ": " + key + ": a table is missing here");
    return Table{child, file.string() + ": " + key};
  };
  PartNumbers numbers;
  numbers.eye = read_eye(table("eye"));
  const Table lashes = table("lashes");
  lashes.read("root", numbers.lashes.root);
  lashes.read("clump", numbers.lashes.clump);
  lashes.read("margin", numbers.lashes.margin_mm);
  lashes.read("infant", numbers.lashes.infant);
  numbers.lashes.upper = read_lash_row(lashes.at("upper"));
  numbers.lashes.lower = read_lash_row(lashes.at("lower"));
  numbers.brow = read_brow(table("brow"));
  numbers.mouth = read_mouth(table("mouth"));
  return numbers;
}

PartNumbers load_part_numbers() {
  return load_part_numbers(find_data_folder() / "templates/head/parts.yaml");
}

}  // namespace mien

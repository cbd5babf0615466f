#include <fmt/format.h>

#include "config/data_table.hpp"
#include "config/part_numbers.hpp"

namespace mien {

namespace {

KnobNumbers read_knob(const DataTable& table) {
  KnobNumbers knob;
  table.read("mix", knob.mix);
  table.read("sink", knob.sink_mm);
  table.read("half", knob.half_mm);
  return knob;
}

EyeNumbers read_eye(const DataTable& table) {
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
  const DataTable tear = table.at("tear");
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

LashRowNumbers read_lash_row(const DataTable& table) {
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

BrowCoat read_coat(const DataTable& table) {
  BrowCoat coat;
  table.read("hairs", coat.hairs);
  table.read("radius", coat.radius_mm);
  table.read("lift", coat.lift_mm);
  if (coat.lift_mm.size() < 2) table.fail("a hair has fewer than two rings in 'lift'; expected two at least");
  return coat;
}

BrowNumbers read_brow(const DataTable& table) {
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
      table.fail(fmt::format("'{}' has {} numbers; expected {}, as many as 'station' has", key, values.size(),
                             brow.station.size()));
  };
  read_stations("above", brow.above_mm);
  read_stations("half", brow.half_mm);
  read_stations("density", brow.density);
  read_stations("length", brow.length_mm);
  read_stations("lower_angle", brow.lower_angle_deg);
  read_stations("upper_angle", brow.upper_angle_deg);
  return brow;
}

TeethRowNumbers read_teeth_row(const DataTable& table) {
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

MouthNumbers read_mouth(const DataTable& table) {
  MouthNumbers mouth;
  table.read("corner", mouth.corner_mm);
  table.read("setback", mouth.setback_mm);
  table.read("clearance", mouth.clearance_mm);
  const DataTable arch = table.at("arch");
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
  if (mouth.scan_years.empty()) table.fail("'scan_years' is empty; expected a pair of numbers at least");
  table.read("scallop", mouth.scallop_mm);
  table.read("ridge", mouth.ridge_mm);
  table.read("gum_thick", mouth.gum_thick_mm);
  const DataTable tongue = table.at("tongue");
  tongue.read("half", mouth.tongue.half_mm);
  tongue.read("tip", mouth.tongue.tip_mm);
  tongue.read("top", mouth.tongue.top_mm);
  tongue.read("rise", mouth.tongue.rise_mm);
  tongue.read("back", mouth.tongue.back_mm);
  tongue.read("room", mouth.tongue.room_mm);
  const DataTable bag = table.at("bag");
  bag.read("front", mouth.bag.front_mm);
  bag.read("back", mouth.bag.back_mm);
  return mouth;
}

}  // namespace

PartNumbers load_part_numbers(const std::filesystem::path& file, Findings& findings) {
  PartNumbers numbers;
  const auto document = load_document(file, findings);
  if (!document) return numbers;
  const DataTable root(find_root(*document, findings));
  numbers.eye = read_eye(root.at("eye"));
  const DataTable lashes = root.at("lashes");
  lashes.read("root", numbers.lashes.root);
  lashes.read("clump", numbers.lashes.clump);
  lashes.read("margin", numbers.lashes.margin_mm);
  lashes.read("infant", numbers.lashes.infant);
  numbers.lashes.upper = read_lash_row(lashes.at("upper"));
  numbers.lashes.lower = read_lash_row(lashes.at("lower"));
  numbers.brow = read_brow(root.at("brow"));
  numbers.mouth = read_mouth(root.at("mouth"));
  return numbers;
}

}  // namespace mien

// Reading templates/head/hair.yaml.
#include <fmt/format.h>

#include "config/data_table.hpp"
#include "config/hair_data.hpp"

namespace mien {

namespace {

// A point of the left half, checked.
void read_point(const YamlValue& value, const PointNames& points, std::string& into) {
  if (load_datum(value, into)) check_point(value, into, points);
}

// [[point, mm above it], [point, mm, the point whose height counts], ...]
std::vector<HairKnot> read_knots(const YamlValue& list, const PointNames& points) {
  std::vector<HairKnot> knots;
  for (const YamlValue& knot : load_list(list, "a list of points")) {
    const std::vector<YamlValue> items = load_list(knot, "a list such as [p_F4, 3]");
    if (items.size() != 2 && items.size() != 3) {
      add_mistake(knot, fmt::format("{} has {} values; expected 2 or 3, as in [p_F4, 3]",
                                    describe_subject(knot), items.size()));
      continue;
    }
    HairKnot& read = knots.emplace_back();
    read_point(items[0], points, read.point);
    load_datum(items[1], read.up_mm);
    if (items.size() > 2) read_point(items[2], points, read.level_of);
  }
  return knots;
}

HairSpread read_spread(const DataTable& table) {
  HairSpread spread;
  table.read("front", spread.front);
  table.read("side", spread.side);
  table.read("back", spread.back);
  if (spread.front.size() < 2 || spread.front.size() != spread.side.size() ||
      spread.side.size() != spread.back.size())
    table.fail(
        fmt::format("front, side and back have {}, {} and {} stations; expected the same, two at least",
                    spread.front.size(), spread.side.size(), spread.back.size()));
  return spread;
}

HairComb read_comb(const DataTable& table) {
  HairComb comb;
  if (const YamlValue* value = table.find("part")) {
    const DataTable part(*value);
    part.read("side", comb.side_mm);
    part.read("from", comb.from_deg);
    part.read("to", comb.to_deg);
    part.read_if("scalp", comb.scalp_mm);
  }
  table.read_if("away", comb.away);
  table.read_if("down", comb.down);
  table.read_if("back", comb.back);
  table.read_if("droop", comb.droop);
  table.read_if("swirl", comb.swirl_deg);
  table.read_if("jitter", comb.jitter_deg);
  comb.is_gathered = table.find("knot") != nullptr;
  table.read_if("knot", comb.knot_deg);
  return comb;
}

void read_wave(const YamlValue* value, double& amount_mm, double& length_mm) {
  if (value == nullptr) return;
  const DataTable wave(*value);
  wave.read("amount", amount_mm);
  wave.read("length", length_mm);
}

HairLocks read_locks(const DataTable& table) {
  HairLocks locks;
  table.read("count", locks.count);
  locks.length_mm = read_spread(table.at("length"));
  table.read("width", locks.width_mm);
  table.read_if("tips", locks.tips_mm);
  table.read_if("ragged", locks.ragged);
  table.read_if("root_band", locks.root_band);
  table.read_if("stand", locks.stand);
  table.read_if("rise", locks.rise_mm);
  table.read_if("rings", locks.rings);
  table.read_if("from_part", locks.from_part);
  table.read_if("deepest", locks.deepest);
  table.read_if("risen", locks.risen);
  table.read_if("widest", locks.widest);
  if (const YamlValue* value = table.find("fall_in")) {
    const DataTable fall(*value);
    fall.read("count", locks.gathers);
    fall.read("pull", locks.gathered);
  }
  read_wave(table.find("wave"), locks.wave_mm, locks.wave_length_mm);
  read_wave(table.find("curl"), locks.curl_mm, locks.curl_length_mm);
  return locks;
}

HairDown read_down(const DataTable& table) {
  HairDown down;
  table.read("count", down.count);
  table.read("length", down.length_mm);
  table.read_if("radius", down.radius_mm);
  table.read_if("band", down.band_mm);
  table.read_if("stand", down.stand);
  return down;
}

HairInk read_ink(const DataTable& table) {
  HairInk ink;
  table.read_if("lock", ink.lock_mm);
  table.read_if("tips", ink.tips_mm);
  table.read_if("count", ink.count);
  table.read_if("width", ink.width_mm);
  table.read_if("longer", ink.longer);
  table.read_if("mass", ink.mass);
  table.read_if("jitter", ink.jitter_deg);
  return ink;
}

HairCut read_cut(const DataTable& table, const PointNames& points) {
  HairCut cut;
  table.read("meaning", cut.meaning);
  table.read("whorl", cut.whorl_deg);
  table.read("centre", cut.centre_mm);
  if (const YamlValue* hairline = table.require("hairline")) {
    cut.hairline = read_knots(*hairline, points);
    if (cut.hairline.size() < 2) table.fail("'hairline' has fewer than two points; expected two at least");
  }
  if (const YamlValue* ends = table.find("ends")) cut.ends = read_knots(*ends, points);
  cut.thick_mm = read_spread(table.at("thick"));
  table.read_if("edge", cut.edge_mm);
  table.read_if("round", cut.round_mm);
  table.read_if("inset", cut.inset_mm);
  table.read_if("mass", cut.mass);
  table.read_if("sheet", cut.sheet_mm);
  table.read_if("tuck", cut.tuck);
  table.read_if("scalp", cut.scalp);
  table.read_if("soft", cut.soft_mm);
  table.read_if("infant", cut.infant);
  table.read_if("covers_ears", cut.covers_ears);
  table.read_if("mirrored", cut.is_mirrored);
  if (const YamlValue* comb = table.find("comb")) cut.comb = read_comb(DataTable(*comb));
  if (const YamlValue* locks = table.find("locks")) cut.locks = read_locks(DataTable(*locks));
  if (const YamlValue* down = table.find("down")) cut.down = read_down(DataTable(*down));
  table.read_if("bun", cut.bun_radius_mm);
  if (const YamlValue* value = table.find("tail")) {
    const DataTable tail(*value);
    tail.read("radius", cut.tail.radius_mm);
    tail.read("length", cut.tail.length_mm);
    tail.read("out", cut.tail.out_mm);
  }
  if (const YamlValue* ink = table.find("ink")) cut.ink = read_ink(DataTable(*ink));
  return cut;
}

BeardArea read_beard_area(const DataTable& table, const PointNames& points) {
  BeardArea area;
  for (const YamlEntry& entry : table.list("density")) {
    check_point(entry, points);
    load_datum(entry.value, area.density[entry.key]);
  }
  table.read("way", area.way);
  return area;
}

Beard read_beard(const DataTable& table, const BeardData& beards) {
  Beard beard;
  Names areas;
  for (const auto& [name, area] : beards.areas) areas.push_back(name);
  table.read("meaning", beard.meaning);
  for (const YamlEntry& entry : table.list("areas"))
    if (check_name(entry, "area of a beard", areas)) load_datum(entry.value, beard.shares[entry.key]);
  table.read("count", beard.count);
  table.read("length", beard.length_mm);
  table.read("radius", beard.radius_mm);
  table.read("stand", beard.stand);
  table.read("paint", beard.paint);
  return beard;
}

// The language's words are those of the file: what it knows is here, and what is here it knows.
template <typename Things>
void check_words(const DataTable& root, const char* key, const YamlMapping& entries, const Names& words,
                 const Things& things) {
  for (const YamlEntry& entry : entries) check_name(entry, key, words);
  for (const std::string& word : words)
    if (word != "none" && !things.contains(word))
      root.fail(fmt::format("'{}' has no '{}'; expected one", key, word));
}

}  // namespace

HairData load_hair_data(const std::filesystem::path& file, const PointNames& points, Findings& findings) {
  HairData data;
  const auto document = load_document(file, findings);
  if (!document) return data;
  const DataTable root(find_root(*document, findings));
  const YamlMapping cuts = root.list("cuts");
  for (const YamlEntry& entry : cuts) data.cuts[entry.key] = read_cut(DataTable(entry.value), points);
  check_words(root, "cuts", cuts, kHairs, data.cuts);
  for (const YamlEntry& entry : root.list("beard_areas"))
    data.beards.areas[entry.key] = read_beard_area(DataTable(entry.value), points);
  const YamlMapping beards = root.list("beards");
  for (const YamlEntry& entry : beards)
    data.beards.beards[entry.key] = read_beard(DataTable(entry.value), data.beards);
  check_words(root, "beards", beards, kBeards, data.beards.beards);
  return data;
}

}  // namespace mien

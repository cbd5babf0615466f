// Reading templates/head/hair.yaml: our own data, so a mistake is a RunError.
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "core/data.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "head/hair.hpp"

namespace mien {

namespace {

template <typename T>
T read(const YAML::Node& table, const char* key) {
  if (!table[key]) throw RunError(fmt::format("{}: a value is missing", key));
  return table[key].as<T>();
}

template <typename T>
void read_if(const YAML::Node& table, const char* key, T& into) {
  if (table[key]) into = table[key].as<T>();
}

std::vector<HairKnot> read_knots(const YAML::Node& list) {
  std::vector<HairKnot> knots;
  for (const auto& knot : list)
    knots.push_back(
        {knot[0].as<std::string>(), knot[1].as<double>(), knot.size() > 2 ? knot[2].as<std::string>() : ""});
  return knots;
}

HairSpread read_spread(const YAML::Node& node, const char* key) {
  const YAML::Node table = node[key];
  if (!table) throw RunError(fmt::format("{}: a value is missing", key));
  HairSpread spread;
  spread.front = read<std::vector<double>>(table, "front");
  spread.side = read<std::vector<double>>(table, "side");
  spread.back = read<std::vector<double>>(table, "back");
  if (spread.front.size() < 2 || spread.front.size() != spread.side.size() ||
      spread.side.size() != spread.back.size())
    throw RunError(fmt::format("{}: front, side and back have not as many stations", key));
  return spread;
}

HairComb read_comb(const YAML::Node& table) {
  HairComb comb;
  if (const YAML::Node part = table["part"]) {
    comb.side_mm = read<double>(part, "side");
    comb.from_deg = read<double>(part, "from");
    comb.to_deg = read<double>(part, "to");
    read_if(part, "scalp", comb.scalp_mm);
  }
  read_if(table, "away", comb.away);
  read_if(table, "down", comb.down);
  read_if(table, "back", comb.back);
  read_if(table, "droop", comb.droop);
  read_if(table, "swirl", comb.swirl_deg);
  read_if(table, "jitter", comb.jitter_deg);
  comb.is_gathered = bool(table["knot"]);
  read_if(table, "knot", comb.knot_deg);
  return comb;
}

HairLocks read_locks(const YAML::Node& table) {
  HairLocks locks;
  locks.count = read<int>(table, "count");
  locks.length_mm = read_spread(table, "length");
  locks.width_mm = read<double>(table, "width");
  read_if(table, "tips", locks.tips_mm);
  read_if(table, "ragged", locks.ragged);
  read_if(table, "root_band", locks.root_band);
  read_if(table, "stand", locks.stand);
  read_if(table, "rise", locks.rise_mm);
  read_if(table, "rings", locks.rings);
  if (const YAML::Node wave = table["wave"]) {
    locks.wave_mm = read<double>(wave, "amount");
    locks.wave_length_mm = read<double>(wave, "length");
  }
  if (const YAML::Node curl = table["curl"]) {
    locks.curl_mm = read<double>(curl, "amount");
    locks.curl_length_mm = read<double>(curl, "length");
  }
  return locks;
}

HairCut read_cut(const YAML::Node& node) {
  HairCut cut;
  cut.whorl_deg = read<double>(node, "whorl");
  cut.centre_mm = read<double>(node, "centre");
  cut.hairline = read_knots(node["hairline"]);
  cut.ends = read_knots(node["ends"]);
  if (cut.hairline.size() < 2) throw RunError("hairline: two points at least are missing");
  cut.thick_mm = read_spread(node, "thick");
  read_if(node, "edge", cut.edge_mm);
  read_if(node, "round", cut.round_mm);
  read_if(node, "inset", cut.inset_mm);
  read_if(node, "mass", cut.mass);
  read_if(node, "sheet", cut.sheet_mm);
  read_if(node, "tuck", cut.tuck);
  read_if(node, "scalp", cut.scalp);
  read_if(node, "soft", cut.soft_mm);
  read_if(node, "infant", cut.infant);
  read_if(node, "covers_ears", cut.covers_ears);
  read_if(node, "mirrored", cut.is_mirrored);
  if (node["comb"]) cut.comb = read_comb(node["comb"]);
  if (node["locks"]) cut.locks = read_locks(node["locks"]);
  if (const YAML::Node down = node["down"]) {
    cut.down.count = read<int>(down, "count");
    cut.down.length_mm = read<double>(down, "length");
    read_if(down, "radius", cut.down.radius_mm);
    read_if(down, "band", cut.down.band_mm);
    read_if(down, "stand", cut.down.stand);
  }
  read_if(node, "bun", cut.bun_radius_mm);
  if (const YAML::Node tail = node["tail"])
    cut.tail = {read<double>(tail, "radius"), read<double>(tail, "length"), read<double>(tail, "out")};
  return cut;
}

}  // namespace

std::map<std::string, HairCut> load_hair_cuts(const std::filesystem::path& file) {
  std::map<std::string, HairCut> cuts;
  std::string name = "cuts";
  try {
    const YAML::Node root = YAML::Load(read_file(file));
    for (const auto& cut : root["cuts"]) {
      name = cut.first.as<std::string>();
      cuts[name] = read_cut(cut.second);
    }
  } catch (const std::exception& problem) {
    throw RunError(fmt::format("{}: {}: {}", file.string(), name, problem.what()));
  }
  return cuts;
}

HairCut load_hair_cut(const std::string& name) {
  const auto cuts = load_hair_cuts(find_data_folder() / "templates/head/hair.yaml");
  const auto found = cuts.find(name);
  if (found == cuts.end()) throw RunError(fmt::format("templates/head/hair.yaml has no cut '{}'", name));
  return found->second;
}

}  // namespace mien

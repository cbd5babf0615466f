// Reading templates/head/hair.yaml: our own data, so a mistake is a RunError.
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "head/hair.hpp"

namespace mien {

namespace {

template <typename T>
T read(const YAML::Node& cut, const char* key) {
  if (!cut[key]) throw RunError(fmt::format("{}: a value is missing", key));
  return cut[key].as<T>();
}

HairCut read_cut(const YAML::Node& node) {
  HairCut cut;
  for (const auto& knot : node["hairline"])
    cut.hairline.push_back(
        {knot[0].as<std::string>(), knot[1].as<double>(), knot.size() > 2 ? knot[2].as<std::string>() : ""});
  cut.whorl_deg = read<double>(node, "whorl");
  cut.centre_mm = read<double>(node, "centre");
  cut.front_mm = read<std::vector<double>>(node, "front");
  cut.side_mm = read<std::vector<double>>(node, "side");
  cut.back_mm = read<std::vector<double>>(node, "back");
  if (cut.front_mm.size() != cut.side_mm.size() || cut.side_mm.size() != cut.back_mm.size())
    throw RunError("front, side and back have not as many stations");
  cut.edge_mm = read<double>(node, "edge");
  cut.round_mm = read<double>(node, "round");
  cut.sheet_mm = read<double>(node, "sheet");
  cut.tuck = read<double>(node, "tuck");
  cut.covers_ears = read<bool>(node, "covers_ears");
  cut.locks = read<int>(node, "locks");
  cut.lock_depth_mm = read<double>(node, "lock_depth");
  cut.split = read<int>(node, "split");
  cut.split_depth_mm = read<double>(node, "split_depth");
  cut.tufts = read<double>(node, "tufts");
  cut.tuft_depth_mm = read<double>(node, "tuft_depth");
  cut.swirl_deg = read<double>(node, "swirl");
  cut.wave_deg = read<double>(node, "wave");
  cut.tips_mm = read<double>(node, "tips");
  cut.infant = read<double>(node, "infant");
  cut.bun_radius_mm = read<double>(node, "bun");
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

}  // namespace mien

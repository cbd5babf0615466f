// `mien list KIND`: the words of the language, from the same tables that the reader uses.
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "config/load_spec.hpp"
#include "core/data.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "frames/figure.hpp"
#include "head/landmarks.hpp"
#include "pipeline.hpp"

namespace mien {

namespace {

using Rows = std::vector<std::pair<std::string, std::string>>;  // word, meaning

// The keys of one map of templates/head/heads.yaml, in its order: ages from young to old.
Rows list_heads(const std::filesystem::path& data, const char* map) {
  Rows rows;
  const YAML::Node heads = YAML::LoadFile((data / "templates/head/heads.yaml").string());
  for (const auto& entry : heads[map]) rows.emplace_back(entry.first.as<std::string>(), "");
  return rows;
}

Rows list_areas() {
  Rows rows;
  for (const MoveInfo& move : kMoves) {
    std::string key(move.area);
    if (move.side != Side::none) key += move.side == Side::left ? ".left" : ".right";
    rows.emplace_back(fmt::format("{}: {{{}: {}..{}}}", key, move.move, move.low, move.high), move.meaning);
  }
  return rows;
}

Rows list_expressions(const std::filesystem::path& data) {
  Rows rows;
  for (const Expression& expression : load_expression_libraries(data / "configs/expressions")) {
    std::string areas;
    for (std::size_t i = 0; i < kMoveCount; ++i) {
      const std::string area(kMoves[i].area);
      if (expression.pose.values[i] != 0 && areas.find(area) == areas.npos)
        areas += (areas.empty() ? "" : ", ") + area;
    }
    rows.emplace_back(expression.library + "/" + expression.name, areas);
  }
  return rows;
}

Rows list_landmarks(const std::filesystem::path& data) {
  const Figure figure = build_figure(HeadSpec{}, data);
  DeformBuffers buffers;
  Drawing drawing;
  deform_figure(figure, Pose{}, TurnKey{}, buffers, drawing);
  const auto landmarks = find_landmarks(figure.head, data / "templates/head/landmarks.yaml");
  Rows rows;
  for (const auto& [name, at] : measure_landmarks(figure.head, landmarks, figure.model, drawing))
    rows.emplace_back(name, fmt::format("{:7.1f} {:7.1f} {:7.1f} mm on the adult", at.x, at.y, at.z));
  return rows;
}

Rows list_features(const std::filesystem::path& data) {
  Rows rows;
  const auto file = data / "templates/head/features.yaml";
  if (!std::filesystem::exists(file)) return rows;
  const YAML::Node features = YAML::LoadFile(file.string())["features"];
  for (const auto& feature : features)
    rows.emplace_back(feature.first.as<std::string>(),
                      "-1..1  " + feature.second["meaning"].as<std::string>());
  return rows;
}

Rows list_rows(const std::string& kind, const std::filesystem::path& data) {
  if (kind == "ages") return list_heads(data, "ages");
  if (kind == "skulls") return list_heads(data, "skulls");
  if (kind == "features") return list_features(data);
  if (kind == "areas") return list_areas();
  if (kind == "expressions") return list_expressions(data);
  if (kind == "landmarks") return list_landmarks(data);
  if (kind == "qualities")
    return {{"draft", "about 1 s a frame of 480x600 on one core: to see the timing"},
            {"good", "about 3 s: the default"},
            {"best", "about 10 s: for the last run"}};
  const std::vector<std::string> kinds{"ages",        "skulls",    "features", "areas",
                                       "expressions", "landmarks", "qualities"};
  const std::string near = find_nearest(kind, kinds);
  throw InputError(
      near.empty() ? fmt::format("unknown kind '{}'; expected ages, skulls, features, areas, expressions, "
                                 "landmarks or qualities",
                                 kind)
                   : fmt::format("unknown kind '{}'; did you mean '{}'?", kind, near));
}

}  // namespace

void list_kind(const std::string& kind, const Options& options) {
  const Rows rows = list_rows(kind, find_data_folder());
  if (options.is_json) {
    for (const auto& [word, meaning] : rows)
      fmt::print("{}\n", nlohmann::ordered_json{{"name", word}, {"meaning", meaning}}.dump());
    return;
  }
  std::size_t width = 0;
  for (const auto& [word, meaning] : rows) width = std::max(width, word.size());
  for (const auto& [word, meaning] : rows)
    fmt::print("{}\n", meaning.empty() ? word : fmt::format("{:<{}}  {}", word, width, meaning));
}

}  // namespace mien

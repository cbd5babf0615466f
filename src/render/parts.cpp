#include "render/parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/text.hpp"

namespace mien {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::vector<std::size_t> share_out(std::size_t count, std::size_t size, std::size_t most_parts) {
  if (count == 0) return {};
  const std::size_t wanted = (count + std::max<std::size_t>(size, 1) - 1) / std::max<std::size_t>(size, 1);
  const std::size_t parts = std::clamp<std::size_t>(wanted, 1, std::max<std::size_t>(most_parts, 1));
  std::vector<std::size_t> shares(parts, count / parts);
  for (std::size_t i = 0; i < count % parts; ++i) ++shares[i];
  return shares;
}

std::string build_part_plan(const PartPlan& plan) {
  ordered_json object{{"mien", MIEN_VERSION}, {"plan", plan.identity}, {"size", plan.size}};
  ordered_json& parts = object["parts"] = ordered_json::array();
  for (const std::vector<PartDrawing>& part : plan.parts) {
    ordered_json drawings = ordered_json::array();
    for (const PartDrawing& drawing : part) drawings.push_back({drawing.clip, drawing.frame, drawing.key});
    parts.push_back(std::move(drawings));
  }
  return object.dump() + "\n";
}

PartPlan read_part_plan(const fs::path& path) {
  const std::string text = read_file(path);
  try {
    const ordered_json object = ordered_json::parse(text);
    PartPlan plan{object.at("plan"), object.at("size"), {}};
    for (const ordered_json& part : object.at("parts")) {
      std::vector<PartDrawing>& drawings = plan.parts.emplace_back();
      for (const ordered_json& drawing : part)
        drawings.push_back({drawing.at(0), drawing.at(1), drawing.at(2)});
    }
    return plan;
  } catch (const nlohmann::json::exception&) {
    throw RunError(fmt::format("{} is no plan of mien's", path.string()));
  }
}

std::string build_drawing_cost(const std::string& kind, double seconds) {
  return ordered_json{{"pictures", kind}, {"seconds", std::stod(format_number(seconds, 3))}}.dump() + "\n";
}

double read_drawing_cost_s(const fs::path& path, const std::string& kind) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return 0;
  const ordered_json object = ordered_json::parse(read_file(path), nullptr, false);
  if (!object.is_object() || !object.contains("seconds") || object.value("pictures", "") != kind) return 0;
  return object["seconds"].is_number() ? std::max(object["seconds"].get<double>(), 0.0) : 0;
}

}  // namespace mien

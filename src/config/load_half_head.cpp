#include <fmt/format.h>

#include <set>

#include "config/half_head.hpp"
#include "core/table.hpp"

namespace mien {

namespace {

std::string parse_point(const Fields& fields, SkinPoint& point) {
  point.name = fields[0];
  const auto weight = parse_field(fields[4]);
  if (!weight) return fmt::format("'{}' is not a number", fields[4]);
  point.weight = *weight;
  point.is_hard = fields[5] == "1";
  if (fields[1].empty() && fields[2].empty() && fields[3].empty()) return {};
  glm::dvec3 skin{0};
  if (std::string mistake = parse_vector(fields, 1, skin); !mistake.empty()) return mistake;
  if (skin.x < 0) return fmt::format("'{}' lies on the other half (x < 0)", point.name);
  point.skin = skin;
  return {};
}

}  // namespace

HalfHead load_half_head(const std::filesystem::path& folder) {
  HalfHead half;
  std::set<std::string> names;
  read_table(folder / "half_points.csv", 6, true, [&](const Fields& fields) {
    SkinPoint point;
    std::string mistake = parse_point(fields, point);
    if (mistake.empty() && !names.insert(point.name).second)
      mistake = fmt::format("point '{}' stands twice", point.name);
    half.points.push_back(std::move(point));
    return mistake;
  });
  std::set<std::pair<std::string, std::string>> edges;
  read_table(folder / "half_quads.csv", 4, false, [&](const Fields& fields) -> std::string {
    for (int i = 0; i < 4; ++i) {
      if (!names.contains(fields[i])) return fmt::format("unknown point '{}'", fields[i]);
      if (!edges.insert({fields[i], fields[(i + 1) % 4]}).second)
        return fmt::format("edge {} {} is used twice", fields[i], fields[(i + 1) % 4]);
    }
    half.quads.push_back({fields[0], fields[1], fields[2], fields[3]});
    return {};
  });
  return half;
}

}  // namespace mien

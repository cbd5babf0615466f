#include "config/point_names.hpp"

#include "config/data_table.hpp"

namespace mien {

namespace {

Names list_names(const PointNames& points) { return {points.begin(), points.end()}; }

}  // namespace

PointNames list_point_names(const HalfHead& half) {
  PointNames names;
  for (const SkinPoint& point : half.points) names.insert(point.name);
  return names;
}

bool check_point(const YamlEntry& entry, const PointNames& points) {
  return points.contains(entry.key) || check_name(entry, "point", list_names(points));
}

bool check_point(const YamlValue& value, const std::string& name, const PointNames& points) {
  return points.contains(name) || check_name(value, name, "point", list_names(points));
}

Handles load_handles(const YamlMapping& entries, const PointNames& points) {
  Handles handles;
  for (const YamlEntry& entry : entries)
    if (check_point(entry, points)) load_datum(entry.value, handles[entry.key]);
  return handles;
}

}  // namespace mien

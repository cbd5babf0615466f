// Points of the head's left half as the head's data name them.
#pragma once

#include <map>
#include <set>
#include <string>

#include <glm/glm.hpp>

#include "config/half_head.hpp"
#include "config/yaml_reader.hpp"

namespace mien {

// Named points of the left half and their displacements.
using Handles = std::map<std::string, glm::dvec3>;

// All of them.
using PointNames = std::set<std::string, std::less<>>;

PointNames list_point_names(const HalfHead& half);

// Adds a mistake at the key, or at the value, unless it names a point: "unknown point 'E1_44'; did you mean
// 'E1_4'?".
bool check_point(const YamlEntry& entry, const PointNames& points);
bool check_point(const YamlValue& value, const std::string& name, const PointNames& points);

// {point: [x, y, z], ...}, mm.
Handles load_handles(const YamlMapping& entries, const PointNames& points);

}  // namespace mien

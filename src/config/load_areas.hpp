// The nine areas as an author sets them: `brows: {up: 0.5}`, `brow.left: {up: 0.7}`.
#pragma once

#include "config/areas.hpp"
#include "config/yaml_reader.hpp"

namespace mien {

// "brows", "brow.left", ..., "chin".
Names list_area_keys();

// `areas: {...}`: a mapping of area keys.
AreaValues load_areas(const YamlValue& value);

// The area keys among the entries; others are passed over. A sided key overrides a plural one.
AreaValues load_areas(const YamlMapping& entries);

}  // namespace mien

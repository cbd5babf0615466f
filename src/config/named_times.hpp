// Times by name: a key or cue has a `name`, and another one, of whatever actor, says `{after: NAME}`.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "config/yaml_reader.hpp"

namespace mien {

// Seconds by what an actor's own clip calls them: of its own names "hello", of others' "ann.hello".
using NamedTimes = std::map<std::string, double>;

// The clip of one actor, or of the only one, whose name is empty.
struct NamedClip {
  std::string actor;
  YamlMapping entries;
};

// For each clip the names it may use. Tells names that are unknown or stand twice, and times that wait for
// each other in a circle; wrong times themselves are told by whoever reads the key.
std::vector<NamedTimes> load_named_times(const std::vector<NamedClip>& clips, int fps);

}  // namespace mien

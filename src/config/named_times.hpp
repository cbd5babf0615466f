// Times by name: a key or cue has a `name`, and another one, of whatever actor, says `{after: NAME}`.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "config/yaml_reader.hpp"

namespace mien {

struct ClipClock;

// What an actor's own clip may wait for.
struct NamedTimes {
  // Seconds by what the clip calls them: of its own names "hello", of others' "ann.hello". Empty: its time is
  // wrong, which is told where it stands.
  std::map<std::string, std::optional<double>> times_s;
  std::set<std::string> formulas;  // of those that are empty: that stand at a formula
  Names names;                     // of all clips, in full; for messages
};

// The clip of one actor, or of the only one, whose name is empty.
struct NamedClip {
  std::string actor;
  YamlMapping entries;
};

// For each clip the names it may use. Tells names that stand twice and times that wait for each other in a
// circle; what else is wrong with a time is told by whoever reads the key, with load_time.
std::vector<NamedTimes> load_named_times(const std::vector<NamedClip>& clips, int fps);

// {after: ann.hello, delay: 0.3s}, seconds of the clip. Empty, with a mistake told, if the name is unknown or
// the mapping is wrong; empty without one if the name's own time is wrong.
std::optional<double> load_named_time(const YamlValue& value, const ClipClock& clock);

}  // namespace mien

// The list of keys that every track of a clip is.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "config/load_clip.hpp"

namespace mien {

// The keys of one track, each a mapping with `at`, in rising time. `load_own` reads what else a key holds,
// over the key before it; the first one's stands over `first`. Empty if there is no such track.
template <typename Key, typename LoadOwn>
std::vector<Key> load_track(const YamlMapping& clip, std::string_view name, std::string_view example,
                            const ClipReader& reader, const LoadOwn& load_own, const Key& first = {}) {
  std::vector<Key> keys;
  const YamlValue* track = find_value(clip, name);
  if (track == nullptr) return keys;
  std::optional<double> before_s;
  for (const YamlValue& value : load_list(*track, "a list of keys such as [" + std::string(example) + "]")) {
    if (!count_part(value, reader)) break;
    Key key = keys.empty() ? first : keys.back();
    const YamlMapping entries = load_section(value);
    load_key_time(entries, value, reader.clock, before_s, key.at_s);
    if constexpr (requires { key.place; }) key.place = find_place(value.document->source, value.spot);
    Between between = Between::ease;
    load_way(entries, reader, key.ease, between);
    if constexpr (requires { key.between; }) key.between = between;
    load_own(entries, key);
    keys.push_back(std::move(key));
  }
  return keys;
}

}  // namespace mien

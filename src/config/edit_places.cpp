#include "config/edit_places.hpp"

#include <algorithm>

#include "config/edit_time.hpp"
#include "core/error.hpp"

namespace mien {

namespace {

YamlPath build_track_path(const std::string& actor, const std::string& track) {
  if (actor.empty()) return {"clip", track};
  return {"actors", actor, "clip", track};
}

}  // namespace

std::vector<TimedPlace> list_timed_places(const EditText& text, const std::string& actor,
                                          const std::string& track, int fps) {
  std::vector<TimedPlace> places;
  if (text.is_empty) return places;
  const YamlPath path = build_track_path(actor, track);
  try {
    const Trail trail = find_trail(text, path);
    if (trail.nodes.size() <= path.size()) return places;
    const std::uint32_t list = trail.nodes.back();
    if (text.document.nodes[list].kind != NodeKind::list) return places;
    const auto times_s = list_item_times(text, list, actor, fps);
    for (std::size_t i = 0; i < times_s.size(); ++i)
      if (times_s[i]) {
        const YamlNode& item = text.document.nodes[find_entry_value(text, list, i)];
        places.push_back({*times_s[i], find_place(text.document.source, item.spot)});
      }
  } catch (const InputError&) {  // an alias is in the way
    places.clear();
  }
  return places;
}

Place find_timed_place(const std::vector<TimedPlace>& places, double at_s) {
  const auto found = std::ranges::find(places, at_s, &TimedPlace::at_s);
  return found == places.end() ? Place{} : found->place;
}

}  // namespace mien

#include <fmt/format.h>
#include <algorithm>

#include "config/constants.hpp"
#include "config/load_clip.hpp"

namespace mien {

namespace {

constexpr std::size_t kMaxChanges = 1000;  // of how drawings are held: each frame looks them through

// `twos`, or a number of frames.
void load_frames(const YamlValue& value, int& into) {
  if (is_word(value)) {
    std::string name;
    if (load_name(value, name)) into = 1 + static_cast<int>(std::ranges::find(kDraws, name) - kDraws.begin());
  } else {
    load_whole(value, into);
  }
}

void load_changes(const YamlValue& value, const ClipClock& clock, ClipSpec& clip) {
  std::optional<double> before_s;
  for (const YamlValue& item : load_list(value, "a list of changes such as [{at: 0s, on: twos}]")) {
    if (clip.draw_changes.size() >= kMaxChanges)
      return add_mistake(item, fmt::format("more than {} changes of drawing; expected fewer", kMaxChanges));
    const YamlMapping entries = load_section(item);
    const YamlValue* at = find_required(entries, "at", item, "a time such as 1.5s");
    const YamlValue* on = find_required(entries, "on", item, "ones, twos, threes or a number of frames");
    DrawChange change;
    if (at == nullptr || on == nullptr || !load_time(*at, clock, change.at_s)) continue;
    if (before_s && change.at_s <= *before_s)
      add_mistake(*at,
                  fmt::format("{} is {}, not after the {} of the change before it; expected rising times",
                              describe_subject(*at), format_quantity(change.at_s, clock.measure),
                              format_quantity(*before_s, clock.measure)));
    before_s = change.at_s;
    load_frames(*on, change.draw);
    clip.draw_changes.push_back(change);
  }
}

}  // namespace

void load_draw(const YamlMapping& entries, const ClipClock& clock, ClipSpec& clip) {
  const YamlValue* value = find_value(entries, "draw");
  if (value == nullptr) return;
  if (find_node(*value).kind == NodeKind::list)
    load_changes(*value, clock, clip);
  else
    load_frames(*value, clip.draw);
}

LeadSpec load_lead(const YamlMapping& entries, const ClipClock& clock) {
  const YamlValue* value = find_value(entries, "lead");
  if (value == nullptr) return kNaturalLead;
  if (find_node(*value).kind != NodeKind::mapping) {
    std::string name;
    const bool is_named = load_name(*value, name);
    return is_named && name == kLeadWords.front().name ? LeadSpec{} : kNaturalLead;
  }
  LeadSpec lead;
  const YamlMapping parts = load_section(*value);
  Measure measure = clock.measure;
  measure.note.clear();
  for (const YamlEntry& entry : parts)
    load_quantity(
        entry.value, measure, find_form(entry.value, FormKind::duration).low,
        find_form(entry.value, FormKind::duration).high,
        lead.after_s[static_cast<std::size_t>(std::ranges::find(kLeadKeys, entry.key) - kLeadKeys.begin())]);
  return lead;
}

}  // namespace mien

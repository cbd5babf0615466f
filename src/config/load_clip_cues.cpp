// How long an expression takes to come and to go: face-facts of timing, after Recio et al. (2013), Schmidt et
// al. (2006) and Tarantili et al. (2005).
#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "config/load_areas.hpp"
#include "config/load_clip.hpp"
#include "core/ticks.hpp"

namespace mien {

namespace {

// A script begins and ends with a pose of its own; this only hides the seam. Longer, and its first move is
// lost.
constexpr double kScriptAttack_s = 0.15, kScriptRelease_s = 0.25;

constexpr std::size_t kMaxCues = 5000;  // of a clip: half a minute of reading and sorting

using Moves = std::bitset<kChannelCount>;

Moves find_area_moves(std::size_t move) {
  Moves moves;
  for (std::size_t i = 0; i < kChannelCount; ++i)
    moves[i] = kChannels[i].area == kChannels[move].area && kChannels[i].of == kChannels[move].of &&
               kChannels[i].side == kChannels[move].side;
  return moves;
}

void own_moved(const Pose& pose, Moves& owns) {
  for (std::size_t i = 0; i < kChannelCount; ++i)
    if (pose.values[i] != 0) owns |= find_area_moves(i);
}

// The areas that a pose moves, or may move.
void own_moved(const PoseKey& key, Moves& owns) {
  own_moved(key.pose, owns);
  if (!key.live) return;
  for (const LivePose::Share& share : key.live->shares) own_moved(share.pose, owns);
  for (const LivePose::Value& value : key.live->values) owns |= find_area_moves(value.move);
}

// `areas: [corners, lids]`.
void load_owned(const YamlValue& value, Moves& owns) {
  for (const YamlValue& item : load_list(value, "areas such as [corners, lids]")) {
    std::string name;
    if (!load_name(item, name)) continue;
    for (const std::size_t move : list_moves_of(*std::ranges::find(kAreaKeys, name, &AreaKey::key)))
      owns.set(move);
  }
}

// `express` and what goes with it; how long it takes to come is the expression's own.
void load_expression(const YamlMapping& entries, const YamlValue& item, const ClipReader& reader,
                     CueSpec& cue, double& attack_s) {
  YamlMapping posed = entries;
  const YamlValue* areas = find_value(entries, "areas");
  const bool is_list = areas != nullptr && find_node(*areas).kind == NodeKind::list;
  if (is_list) std::erase_if(posed, [](const YamlEntry& entry) { return entry.key == "areas"; });
  cue.what.at_s = cue.from_s;
  const Express shown = load_pose(posed, reader, cue.what);
  attack_s = shown.attack_s;
  const YamlValue* express = find_value(entries, "express");
  if (is_list) {
    load_owned(*areas, cue.owns);
    if (express == nullptr)
      add_mistake(
          item, fmt::format("{} has 'areas' and nothing to show on them; expected 'express' or 'play' beside "
                            "it",
                            describe_subject(item)));
    return;
  }
  if (areas != nullptr && find_node(*areas).kind == NodeKind::mapping) {
    const YamlMapping named = load_free_mapping(*areas, "");
    for (const AreaKey& key : kAreaKeys)
      if (find_value(named, key.key) != nullptr)
        for (const std::size_t move : list_moves_of(key)) cue.owns.set(move);
    for (const std::string_view doctrine : {kMusclesKey, kCandideKey, kParkeKey})
      if (find_value(named, doctrine) != nullptr) own_moved(cue.what, cue.owns);
  }
  if (express != nullptr) own_moved(cue.what, cue.owns);
  // Back to rest: of all that the others of its library move, and of what is beyond Tezuka's areas.
  if (cue.owns.none() && !shown.library.empty()) {
    for (const Expression& other : reader.book->expressions)
      if (other.library == shown.library) own_moved(other.pose, cue.owns);
    for (std::size_t i = 0; i < kChannelCount; ++i)
      if (kChannels[i].is_beyond) cue.owns.set(i);
  }
  if (cue.owns.none()) cue.owns.set();
}

// `play` and what goes with it.
void load_play(const YamlMapping& entries, const YamlValue& play, const ClipReader& reader, CueSpec& cue,
               int& times) {
  cue.script = play_script(play, find_value(entries, "with"), reader);
  cue.what.label = find_node(play).text;
  cue.has_lead = false;
  if (const YamlValue* repeat = find_value(entries, "repeat")) {
    load_whole(*repeat, times);
    cue.is_repeated = times > 1;
  }
  for (const char* key : {"strength", "exaggerate", "express"})
    if (const YamlValue* value = find_value(entries, key))
      add_mistake(*value, fmt::format("'{}' and 'play' stand in one cue; expected one of them", key));
  if (const YamlValue* areas = find_value(entries, "areas")) return load_owned(*areas, cue.owns);
  if (!cue.script) return;
  for (const PoseKey& key : cue.script->keys) own_moved(key, cue.owns);
  for (const CueSpec& inner : cue.script->cues) cue.owns |= inner.owns;
}

// A cue, and what is known of its end.
struct Draft {
  CueSpec cue;
  double release_s = 0;
  bool is_open = false;  // until the next one on its areas
};

double add_s(double a_s, double b_s) { return compute_seconds(compute_ticks(a_s) + compute_ticks(b_s)); }

void load_times(const YamlMapping& entries, const ClipReader& reader, double attack_s, int times,
                Draft& draft) {
  CueSpec& cue = draft.cue;
  const bool is_script = cue.script != nullptr;
  const double script_s = is_script ? cue.script->length_s : 0;
  if (is_script) attack_s = std::min(kScriptAttack_s, script_s / 4);
  draft.release_s = is_script ? kScriptRelease_s : kReleasePerAttack * attack_s;
  if (load_duration(entries, "attack", reader.clock, attack_s) && !is_script)
    draft.release_s = kReleasePerAttack * attack_s;
  load_duration(entries, "release", reader.clock, draft.release_s);
  cue.full_s = add_s(cue.from_s, attack_s);
  double hold_s = 0;
  if (is_script)
    cue.ebb_s =
        std::max(cue.full_s, compute_seconds(compute_ticks(cue.from_s) + times * compute_ticks(script_s)));
  else if (load_duration(entries, "hold", reader.clock, hold_s))
    cue.ebb_s = add_s(cue.full_s, hold_s);
  else
    draft.is_open = true;
  if (const YamlValue* hold = find_value(entries, "hold"); hold != nullptr && is_script)
    add_mistake(*hold, "'hold' and 'play' stand in one cue; expected 'repeat' or 'to'");
  double to_s = 0;
  if (const YamlValue* to = find_value(entries, "to"); to != nullptr && load_time(*to, reader.clock, to_s)) {
    if (to_s <= cue.from_s)
      add_mistake(*to, fmt::format("{} is {}, not after 'from', {}; expected a later time",
                                   describe_subject(*to), format_quantity(to_s, reader.clock.measure),
                                   format_quantity(cue.from_s, reader.clock.measure)));
    cue.ebb_s = std::min(cue.ebb_s, to_s);
    draft.is_open = false;
  }
}

// Cues without an end of their own go when the next one on one of their areas comes.
void end_cues(std::vector<Draft>& drafts) {
  for (std::size_t i = 0; i < drafts.size(); ++i) {
    CueSpec& cue = drafts[i].cue;
    const auto next = std::find_if(
        drafts.begin() + static_cast<std::ptrdiff_t>(i) + 1, drafts.end(), [&](const Draft& other) {
          return other.cue.from_s > cue.from_s && (other.cue.owns & cue.owns).any();
        });
    if (drafts[i].is_open && next != drafts.end()) cue.ebb_s = std::max(cue.full_s, next->cue.from_s);
    cue.end_s = std::isfinite(cue.ebb_s) ? add_s(cue.ebb_s, drafts[i].release_s) : kForever_s;
  }
}

}  // namespace

bool load_duration(const YamlMapping& entries, std::string_view key, const ClipClock& clock, double& into) {
  const YamlValue* value = find_value(entries, key);
  return value != nullptr && load_duration(*value, clock, into);
}

void load_rule(const YamlMapping& entries, Rule& into) {
  std::string name;
  if (const YamlValue* value = find_value(entries, "rule"))
    if (load_name(*value, name)) into = static_cast<Rule>(std::ranges::find(kRules, name) - kRules.begin());
}

void load_cues(const YamlMapping& clip, const ClipReader& reader, std::vector<CueSpec>& into) {
  const YamlValue* list = find_value(clip, "cues");
  if (list == nullptr) return;
  const std::vector<YamlValue> items =
      load_list(*list, "a list of cues such as [{from: 1s, express: smile}]");
  if (items.size() > kMaxCues) {
    add_mistake(*list, fmt::format("{} has {} cues; expected {} at most", describe_subject(*list),
                                   items.size(), kMaxCues));
    return;
  }
  std::vector<Draft> drafts;
  for (const YamlValue& item : items) {
    if (!count_part(item, reader)) break;
    const YamlMapping entries = load_section(item);
    Draft draft;
    CueSpec& cue = draft.cue;
    const YamlValue* from = find_required(entries, "from", item, "a time such as 1.5s");
    if (from != nullptr) load_time(*from, reader.clock, cue.from_s);
    cue.start_s = cue.from_s;
    cue.what.place = find_place(item.document->source, item.spot);
    load_rule(entries, cue.rule);
    double attack_s = kDefaultAttack_s;
    int times = 1;
    const YamlValue* play = find_value(entries, "play");
    if (play != nullptr)
      load_play(entries, *play, reader, cue, times);
    else if (find_value(entries, "express") == nullptr && find_value(entries, "areas") == nullptr &&
             find_node(item).kind == NodeKind::mapping)
      add_mistake(item, fmt::format("{} has nothing to show; expected 'express', 'areas' or 'play'",
                                    describe_subject(item)));
    else
      load_expression(entries, item, reader, cue, attack_s);
    for (const char* key : {"with", "repeat"})
      if (const YamlValue* value = find_value(entries, key); value != nullptr && play == nullptr)
        add_mistake(*value, fmt::format("'{}' stands without a script; expected 'play' beside it", key));
    load_times(entries, reader, attack_s, times, draft);
    if (play == nullptr || cue.script) drafts.push_back(std::move(draft));
  }
  std::ranges::stable_sort(drafts,
                           [](const Draft& a, const Draft& b) { return a.cue.from_s < b.cue.from_s; });
  end_cues(drafts);
  for (Draft& draft : drafts) into.push_back(std::move(draft.cue));
}

}  // namespace mien

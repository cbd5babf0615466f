#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "config/constants.hpp"
#include "config/load_clip.hpp"
#include "config/load_spec.hpp"
#include "config/load_track.hpp"
#include "config/sections.hpp"
#include "core/conventions.hpp"

namespace mien {

namespace {

constexpr std::size_t kMaxActors = 12;  // each is half a million numbers a frame
constexpr double kEyes_mm = 80;         // in front of a head's origin: between the grown-up's and the child's

void add_mistake_at_key(const YamlEntry& entry, std::string message) {
  add_mistake(*entry.value.findings, entry.value.document->source, entry.spot, std::move(message));
}

bool is_actor_name(const std::string& name) {
  return !name.empty() && name.size() <= kMaxActorName && name[0] >= 'a' && name[0] <= 'z' &&
         std::ranges::all_of(
             name, [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
}

void load_place(const YamlValue& value, PlaceSpec& place) {
  const YamlMapping entries = load_section(value);
  if (const YamlValue* at = find_value(entries, "at")) load_lengths(*at, place.at_mm);
  if (const YamlValue* turn = find_value(entries, "turn")) load_angle(*turn, place.turn_deg);
}

// Keys instead of one place.
std::vector<PlaceKey> load_place_keys(const YamlMapping& entries, const ClipClock& clock, Between between) {
  ClipReader reader;
  reader.clock = clock;
  reader.between = between;
  std::vector<PlaceKey> keys = load_track<PlaceKey>(entries, "place", "{at: 1s, to: [100mm, 0, 0]}", reader,
                                                    [&](const YamlMapping& own, PlaceKey& key) {
                                                      if (const YamlValue* to = find_value(own, "to"))
                                                        load_lengths(*to, key.to_mm);
                                                      if (const YamlValue* turn = find_value(own, "turn"))
                                                        load_angle(*turn, key.turn_deg);
                                                    });
  return keys;
}

// When the actor is there.
void load_presence(const YamlMapping& entries, const ClipClock& clock, ClipSpec& clip) {
  const YamlValue* from = find_value(entries, "from");
  const YamlValue* to = find_value(entries, "to");
  if (from != nullptr) load_time(*from, clock, clip.enters_s);
  if (to != nullptr && load_time(*to, clock, clip.leaves_s) && clip.leaves_s <= clip.enters_s)
    add_mistake(*to, fmt::format("the actor leaves at {:.4g}s and enters at {:.4g}s; expected a later 'to'",
                                 clip.leaves_s, clip.enters_s));
}

// `head: {age: child}` or `head: ann.yaml`.
HeadSpec load_actor_head(const YamlValue& value, const HeadSource& source) {
  if (find_node(value).kind != NodeKind::text) return load_head(value, source);
  HeadSpec head;
  load_head_file(value, source, head);
  return head;
}

// What of a clip is each actor's own.
Names list_own_keys() {
  Names keys = list_keys(find_sections().clip);
  std::erase_if(keys, [](const std::string& key) {
    return std::ranges::find(kSharedClipKeys, key) != kSharedClipKeys.end() ||
           std::ranges::find(kCommonClipKeys, key) != kCommonClipKeys.end();
  });
  return keys;
}

// Keys that stand in the wrong one of the two clips; the rest is left.
YamlMapping find_clip_entries(const YamlValue* value, const Names& others, const std::string& message) {
  YamlMapping entries;
  if (value == nullptr || find_node(*value).kind != NodeKind::mapping) return entries;
  entries = load_free_mapping(*value, "");
  for (const YamlEntry& entry : entries)
    if (std::ranges::find(others, entry.key) != others.end())
      add_mistake_at_key(entry, fmt::format(fmt::runtime(message), entry.key));
  return entries;
}

// What stands in the file for one who plays, before it is understood.
struct Part {
  std::string name;  // empty: the file's own clip
  YamlMapping entries;
  YamlMapping clip;
};

std::vector<Part> load_parts(const YamlValue& actors) {
  std::vector<Part> parts;
  for (const YamlEntry& actor :
       load_free_mapping(actors, "actors such as {ann: {head: {age: child}, clip: {...}}}")) {
    if (!is_actor_name(actor.key))
      add_mistake_at_key(actor,
                         fmt::format("'{}' is no actor's name; expected a word of small letters, digits "
                                     "and '_' that begins with a letter, {} at most",
                                     show_word(actor.key), kMaxActorName));
    if (parts.size() == kMaxActors) {
      add_mistake_at_key(actor, fmt::format("more than {} actors; expected fewer", kMaxActors));
      break;
    }
    YamlValue own = actor.value;
    own.constants = build_actor_constants(own);
    Part part{actor.key, load_section(own), {}};
    part.clip =
        find_clip_entries(find_value(part.entries, "clip"), kSharedClipKeys,
                          "'{}' concerns all actors; it belongs in the 'clip' at the top of the file");
    parts.push_back(std::move(part));
  }
  if (find_node(actors).kind == NodeKind::mapping && parts.empty())
    add_mistake(actors, "'actors' names nobody; expected one at least");
  return parts;
}

ActorSpec load_actor(const Part& part, const StageSource& source, const NamedTimes& times,
                     const ClipSpec& shared, const Inputs& inputs, const Names& others, ClipCounts& counts) {
  ActorSpec actor;
  actor.name = part.name;
  if (const YamlValue* head = find_value(part.entries, "head"))
    actor.head = load_actor_head(*head, source.head);
  const ClipClock clock = build_clip_clock(shared.fps, &times);
  const YamlValue* place = find_value(part.entries, "place");
  const bool is_track = place != nullptr && find_node(*place).kind == NodeKind::list;
  std::vector<PlaceKey> steps;
  if (is_track) {
    Between between = Between::ease;
    load_between(part.clip, between);
    steps = load_place_keys(part.entries, clock, between);
    if (!steps.empty()) actor.place = {steps.front().to_mm, steps.front().turn_deg};
  } else if (place != nullptr) {
    load_place(*place, actor.place);
  }
  actor.clip = load_clip(find_value(part.entries, "clip"), *source.book,
                         {&shared, false, &times, others, &counts, &inputs, nullptr});
  load_head_track(part.clip, source.head, actor.head, times, actor.clip);
  if (steps.empty() &&
      std::ranges::find(actor.clip.laws, LawTrack::place, &TrackLaw::track) != actor.clip.laws.end())
    steps.push_back({0, {}, actor.place.at_mm, actor.place.turn_deg});
  if (!steps.empty()) actor.clip.length_s = std::max(actor.clip.length_s, steps.back().at_s);
  actor.clip.place = std::move(steps);
  load_presence(part.entries, clock, actor.clip);
  actor.clip.camera = shared.camera;  // for looks into it: as seen by one who is turned
  for (CameraKey& key : actor.clip.camera) {
    key.angle_deg -= actor.place.turn_deg;
    if (key.live[0]) key.live[0] = shift_formula(*key.live[0], -actor.place.turn_deg);
  }
  for (TrackLaw law : shared.laws)
    if (law.track == LawTrack::camera) {
      if (law.number == 0) law.shift = actor.place.turn_deg;
      actor.clip.laws.push_back(std::move(law));
    }
  std::ranges::stable_sort(actor.clip.laws, {}, &TrackLaw::from_s);
  return actor;
}

// From a place of the stage to how one sees it who stands at `place`.
glm::dvec3 compute_seen(const PlaceSpec& place, const glm::dvec3& at_mm) {
  const double turn = place.turn_deg * kRadiansPerDegree;
  const glm::dvec3 p = at_mm - place.at_mm;
  return {p.x * std::cos(turn) - p.z * std::sin(turn), p.y, p.x * std::sin(turn) + p.z * std::cos(turn)};
}

// Points to look at are told for the stage; another one's eyes are found where he stands.
void place_looks(std::vector<ActorSpec>& actors) {
  for (ActorSpec& actor : actors)
    for (GazeKey& key : actor.clip.gaze.keys) {
      if (key.look != LookAt::point) continue;
      const auto other = std::ranges::find(actors, key.actor, &ActorSpec::name);
      if (other != actors.end()) {
        const double turn = other->place.turn_deg * kRadiansPerDegree;
        key.point_mm = other->place.at_mm + kEyes_mm * glm::dvec3(std::sin(turn), 0, std::cos(turn));
      }
      key.point_mm = compute_seen(actor.place, key.point_mm);
    }
}

// All last as long: `length:`, else until the last key of all.
void share_length(bool has_length, Spec& spec) {
  for (const ActorSpec& actor : spec.actors)
    if (!has_length) spec.clip.length_s = std::max(spec.clip.length_s, actor.clip.length_s);
  for (ActorSpec& actor : spec.actors) actor.clip.length_s = spec.clip.length_s;
}

// All who play, frame by frame: `mien check` keeps a kilobyte of each.
void check_frames(const Spec& spec, const YamlValue& actors) {
  constexpr std::size_t kMost = 400'000;
  const auto frames = static_cast<std::size_t>(count_frames(spec.clip));
  if (spec.actors.size() * frames > kMost)
    add_mistake(actors,
                fmt::format("{} actors play {} frames each, {} in all; expected {} at most: fewer of them "
                            "or a shorter clip",
                            spec.actors.size(), frames, spec.actors.size() * frames, kMost));
}

// Of all who play, and the file's own, whose camera is everybody's.
std::vector<const ClipSpec*> list_clips(const Spec& spec) {
  std::vector<const ClipSpec*> clips{&spec.clip};
  for (const ActorSpec& actor : spec.actors) clips.push_back(&actor.clip);
  return clips;
}

}  // namespace

void load_stage(const YamlMapping& file, const StageSource& source, Spec& spec) {
  const YamlValue* actors = find_value(file, "actors");
  const YamlValue* clip = find_value(file, "clip");
  if (actors != nullptr)
    for (const YamlEntry& entry : file)
      if (entry.key == "head")
        add_mistake_at_key(entry, "'head' stands beside 'actors'; expected each actor's head in 'actors'");
  std::vector<Part> parts{{"",
                           {},
                           find_clip_entries(clip, actors != nullptr ? list_own_keys() : Names{},
                                             "'{}' stands beside 'actors'; expected it in each "
                                             "actor's own 'clip'")}};
  if (actors != nullptr)
    for (Part& part : load_parts(*actors)) parts.push_back(std::move(part));

  int fps = ClipSpec{}.fps;
  load_fps(parts.front().clip, fps);
  std::vector<NamedClip> clips;
  for (const Part& part : parts) clips.push_back({part.name, part.clip});
  const std::vector<NamedTimes> times = load_named_times(clips, fps);

  if (const YamlValue* head = find_value(file, "head")) spec.head = load_head(*head, source.head);
  ClipCounts counts;
  Inputs inputs;
  spec.clip = load_clip(clip, *source.book,
                        {nullptr, actors != nullptr, &times.front(), {}, &counts, nullptr, &inputs});
  if (actors == nullptr)
    load_head_track(parts.front().clip, source.head, spec.head, times.front(), spec.clip);
  Names names;
  for (std::size_t i = 1; i < parts.size(); ++i) names.push_back(parts[i].name);
  load_camera_sights(parts.front().clip, {list_places(*source.head.words), names}, spec.clip);
  load_light_tracks(parts.front().clip, times.front(), spec.clip);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    Names others = names;
    std::erase(others, parts[i].name);
    spec.actors.push_back(load_actor(parts[i], source, times[i], spec.clip, inputs, others, counts));
  }
  place_looks(spec.actors);
  share_length(find_value(parts.front().clip, "length") != nullptr, spec);
  const YamlValue* place = actors != nullptr ? actors : clip;
  if (place != nullptr) check_work(list_clips(spec), *place);
  if (actors != nullptr) check_frames(spec, *actors);
}

}  // namespace mien

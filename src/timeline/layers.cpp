#include "timeline/layers.hpp"

#include <algorithm>

#include "timeline/track_laws.hpp"

namespace mien {

namespace {

KeyLaw build_law(const PoseKey& key) {
  if (!key.live) return {};
  return [live = key.live](double time_s, std::span<double> into) {
    std::ranges::copy(evaluate_pose(*live, time_s).pose.values, into.begin());
  };
}

KeyLaw build_law(const std::array<FormulaPointer, 3>& live, const std::vector<double>& values) {
  if (std::ranges::none_of(live, [](const FormulaPointer& formula) { return formula != nullptr; })) return {};
  return [live, values](double time_s, std::span<double> into) {
    for (std::size_t i = 0; i < live.size(); ++i)
      into[i] = live[i] ? evaluate_held(*live[i], time_s) : values[i];
  };
}

// Of a key that says how long an area takes to come off it.
std::vector<Ticks> build_release(const Release& release_s) {
  std::vector<Ticks> release;
  if (release_s == kNoRelease) return release;
  for (std::size_t i = 0; i < kChannelCount; ++i) {
    const double part_s = release_s[static_cast<std::size_t>(find_lead_part(i))];
    release.push_back(part_s < 0 ? -1 : compute_ticks(part_s));
  }
  return release;
}

TrackKey build_track_key(const PoseKey& key) {
  TrackKey built{
      key.at_s, key.ease, key.between, {key.pose.values.begin(), key.pose.values.end()}, build_law(key)};
  built.release = build_release(key.release);
  return built;
}

TrackKey build_track_key(const TurnKey& key) {
  std::vector<double> values{key.turn_deg, key.nod_deg, key.tilt_deg};
  return {key.at_s, key.ease, key.between, values, build_law(key.live, values)};
}

TrackKey build_track_key(const CameraKey& key) {
  std::vector<double> values{key.angle_deg, key.height_deg, key.distance};
  return {key.at_s, key.ease, key.between, values, build_law(key.live, values)};
}

TrackKey build_track_key(const PlaceKey& key) {
  return {key.at_s, key.ease, key.between, {key.to_mm.x, key.to_mm.y, key.to_mm.z, key.turn_deg}};
}

// A track without keys rests.
template <typename Key>
std::vector<TrackKey> build_track_keys(const std::vector<Key>& keys) {
  std::vector<TrackKey> built;
  for (const Key& key : keys) built.push_back(build_track_key(key));
  if (built.empty()) built.push_back(build_track_key(Key{}));
  return built;
}

// How far the areas of a pose's track may go past their limits, by the first to set out, the last, the first
// that is released and the last: what any of them needs, all have (sample_keys).
constexpr std::size_t kReaches = 4;

KeyTrack build_reach(const KeyTrack& pose, std::vector<PoseKey> keys, double& most_reach) {
  std::ranges::stable_sort(keys, {}, &PoseKey::at_s);
  std::vector<TrackKey> reach = pose.keys;
  for (std::size_t i = 0; i < reach.size(); ++i) {
    const double most = keys.empty() ? 1 : keys[i].reach;
    reach[i].values.assign(kReaches, most);
    reach[i].law = {};
    most_reach = std::max(most_reach, most);
    Ticks least = -1, longest = -1;
    for (const Ticks each : reach[i].release) {
      if (each >= 0 && (least < 0 || each < least)) least = each;
      longest = std::max(longest, each);
    }
    if (longest >= 0) reach[i].release = {-1, -1, least, longest};
  }
  KeyTrack track = build_track(std::move(reach), kReaches);
  track.leads = pose.leads;
  for (Lead& lead : track.leads) lead.after = {0, lead.widest, 0, lead.widest};
  return track;
}

bool has_doctrine(const PoseKey& key) {
  if (mien::has_doctrine(key.pose)) return true;
  return key.live &&
         (std::ranges::any_of(key.live->shares,
                              [](const LivePose::Share& share) { return mien::has_doctrine(share.pose); }) ||
          std::ranges::any_of(key.live->values,
                              [](const LivePose::Value& value) { return !is_area_move(value.move); }));
}

// Whether a muscle or a unit is ever moved.
bool has_doctrine(const ClipSpec& clip, const CueStack& cues) {
  return std::ranges::any_of(clip.keys, [](const PoseKey& key) { return has_doctrine(key); }) ||
         std::ranges::any_of(cues.cues, [](const Cue& cue) {
           if (cue.script) return !(cue.script->moves & ~kAreaMoves).none();
           if (cue.spec.table)
             return std::ranges::any_of(cue.spec.table->moves,
                                        [](std::size_t i) { return !is_area_move(i); });
           return has_doctrine(cue.spec.what);
         });
}

}  // namespace

Layers build_layers(const ClipSpec& clip) {
  LayerStore store;
  return build_layers(clip, store);
}

std::shared_ptr<const Layers> share_script(const std::shared_ptr<const ClipSpec>& script, LayerStore& store) {
  if (!script) return {};
  if (const auto known = store.scripts.find(script.get()); known != store.scripts.end()) return known->second;
  auto layers = std::make_shared<const Layers>(build_layers(*script, store));
  return store.scripts[script.get()] = std::move(layers);
}

std::shared_ptr<const KeyTrack> share_table(const std::shared_ptr<const TimeTable>& table,
                                            LayerStore& store) {
  if (!table) return {};
  std::shared_ptr<const KeyTrack>& track = store.tables[table.get()];
  if (!track) track = std::make_shared<const KeyTrack>(build_table(*table));
  return track;
}

Layers build_layers(const ClipSpec& clip, LayerStore& store) {
  Layers layers;
  if (!clip.place.empty()) layers.place = build_track(build_track_keys(clip.place), 4);
  layers.pose = build_track(build_track_keys(clip.keys), kChannelCount, build_lead(clip.lead));
  for (std::size_t i = 1; i < layers.pose.keys.size(); ++i) {
    const auto pose_of = [&](std::size_t key) {
      Pose pose;
      std::ranges::copy(layers.pose.keys[key].values, pose.values.begin());
      return pose;
    };
    layers.pose.keys[i].lead = take_lead(clip.lead, pose_of(i - 1), pose_of(i), layers.pose.leads);
  }
  layers.reach = build_reach(layers.pose, clip.keys, layers.most_reach);

  Lead head;
  head.after.assign(3, compute_ticks(clip.lead.after_s[static_cast<std::size_t>(LeadPart::head)]));
  head.widest = layers.pose.leads.front().widest;
  layers.turn = build_track(build_track_keys(clip.turn), 3, head);
  layers.camera = build_track(build_track_keys(clip.camera), 3);

  layers.cues = build_cue_stack(clip, store);
  layers.laws = clip.laws;
  layers.length = compute_ticks(clip.length_s);
  if (has_doctrine(clip, layers.cues)) layers.moves.set();
  return layers;
}

KeyTrack build_table(const TimeTable& table) {
  std::vector<TrackKey> keys;
  const std::size_t width = table.moves.size();
  for (std::size_t row = 0; row < table.at_s.size(); ++row) {
    const auto begin = table.values.begin() + static_cast<std::ptrdiff_t>(row * width);
    keys.push_back({table.at_s[row],
                    Easing::linear,
                    table.between,
                    {begin, begin + static_cast<std::ptrdiff_t>(width)}});
  }
  return build_track(std::move(keys), width);
}

FaceState sample_layers(const Layers& layers, Ticks time) {
  return sample_layers(layers, time, layers.moves);
}

FaceState sample_layers(const Layers& layers, Ticks time, const Moves& only) {
  FaceState face = sample_keys(layers, time, only);
  apply_cues(layers.cues, time, only, face);
  if (is_whole(only)) apply_laws(layers.laws, LawTrack::turn, time, face.turn_deg);
  return face;
}

FaceState sample_keys(const Layers& layers, Ticks time, const Moves& only) {
  FaceState face;
  sample_track(layers.pose, time, only, face.values);
  std::array<double, kReaches> reach{1, 1, 1, 1};
  if (layers.most_reach > 1) sample_track(layers.reach, time, reach);
  face.reach.fill(std::clamp(std::ranges::max(reach), 1.0, layers.most_reach));
  if (is_whole(only)) sample_track(layers.turn, time, face.turn_deg);
  return face;
}

}  // namespace mien

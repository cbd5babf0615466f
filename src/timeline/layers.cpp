#include "timeline/layers.hpp"

#include <algorithm>

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

TrackKey build_track_key(const PoseKey& key) {
  return {key.at_s, key.ease, key.between, {key.pose.values.begin(), key.pose.values.end()}, build_law(key)};
}

TrackKey build_track_key(const TurnKey& key) {
  std::vector<double> values{key.turn_deg, key.nod_deg, key.tilt_deg};
  return {key.at_s, key.ease, key.between, values, build_law(key.live, values)};
}

TrackKey build_track_key(const CameraKey& key) {
  std::vector<double> values{key.angle_deg, key.height_deg, key.distance};
  return {key.at_s, key.ease, key.between, values, build_law(key.live, values)};
}

// A track without keys rests.
template <typename Key>
std::vector<TrackKey> build_track_keys(const std::vector<Key>& keys) {
  std::vector<TrackKey> built;
  for (const Key& key : keys) built.push_back(build_track_key(key));
  if (built.empty()) built.push_back(build_track_key(Key{}));
  return built;
}

double find_after_s(const LeadSpec& lead, LeadPart part) {
  return lead.after_s[static_cast<std::size_t>(part)];
}

}  // namespace

Layers build_layers(const ClipSpec& clip) {
  Layers layers;
  const double widest_s = std::ranges::max(clip.lead.after_s);
  std::vector<double> after_s;
  for (std::size_t i = 0; i < kMoveCount; ++i) after_s.push_back(find_after_s(clip.lead, find_lead_part(i)));
  after_s.push_back(widest_s);  // what sets out last of all: the whole way is everybody's
  layers.pose = build_track(build_track_keys(clip.keys), kMoveCount, after_s);

  const double head_s = find_after_s(clip.lead, LeadPart::head);
  layers.turn = build_track(build_track_keys(clip.turn), 3, std::array{head_s, head_s, head_s, widest_s});
  layers.camera = build_track(build_track_keys(clip.camera), 3);

  std::vector<TrackKey> reach = build_track_keys(clip.keys);
  for (std::size_t i = 0; i < reach.size(); ++i) {
    const double most = clip.keys.empty() ? 1 : clip.keys[i].reach;
    reach[i].values = {most, most};
    reach[i].law = {};
    layers.most_reach = std::max(layers.most_reach, most);
  }
  layers.reach = build_track(std::move(reach), 2, std::array{0.0, widest_s});
  layers.cues = build_cue_stack(clip);
  layers.length = find_ticks(clip.length_s);
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
  return sample_layers(layers, time, Moves().set());
}

FaceState sample_layers(const Layers& layers, Ticks time, const Moves& only) {
  FaceState face = sample_keys(layers, time, only);
  apply_cues(layers.cues, time, only, face);
  return face;
}

FaceState sample_keys(const Layers& layers, Ticks time, const Moves& only) {
  FaceState face;
  sample_track(layers.pose, time, only, face.values);
  std::array<double, 2> reach{1, 1};
  if (layers.most_reach > 1) sample_track(layers.reach, time, reach);
  face.reach.fill(std::clamp(std::max(reach[0], reach[1]), 1.0, layers.most_reach));
  if (only.all()) sample_track(layers.turn, time, face.turn_deg);
  return face;
}

}  // namespace mien

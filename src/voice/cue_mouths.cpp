#include "voice/cue_mouths.hpp"

namespace mien {

namespace {

VisemeIndices find_cue_visemes(const SpeechData& data, MouthNames names, std::string name, int& stress) {
  if (names == MouthNames::ipa) return find_ipa_visemes(data, name);
  if (names == MouthNames::arpabet && !name.empty() && name.back() >= '0' && name.back() <= '2') {
    stress = name.back() - '0';
    name.pop_back();
  }
  const auto& known = names == MouthNames::rhubarb         ? data.rhubarb
                      : names == MouthNames::preston_blair ? data.preston_blair
                                                           : data.arpabet;
  const auto found = known.find(name);
  return found != known.end() ? found->second : VisemeIndices{};
}

bool is_pause(const SpeechData& data, const VisemeIndices& visemes, const MouthCue& cue) {
  constexpr double kLong_s = 0.25;
  return visemes.size() == 1 && data.visemes[visemes[0]].name == "rest" && cue.to_s - cue.from_s >= kLong_s;
}

}  // namespace

std::vector<CueMouths> list_cue_mouths(const MouthTrack& track, const SpeechData& data) {
  std::vector<CueMouths> mouths;
  if (track.names == MouthNames::words) return mouths;
  for (const MouthCue& cue : track.cues) {
    CueMouths each{cue, {}};
    each.visemes = find_cue_visemes(data, track.names, cue.name, each.stress);
    if (!is_pause(data, each.visemes, cue)) mouths.push_back(std::move(each));
  }
  return mouths;
}

std::vector<MouthSegment> list_track_segments(const MouthTrack& track, const SpeechData& data) {
  std::vector<MouthSegment> segments;
  for (const CueMouths& each : list_cue_mouths(track, data))
    append_segments(each.visemes, each.cue.from_s, each.cue.to_s, each.stress, segments);
  return segments;
}

}  // namespace mien

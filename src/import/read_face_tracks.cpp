// OpenFaceFX's tracks: keys of time and value for each channel, straight between them.
//   {"format": "openfacefx.track", "version": 1, "fps": 60, "duration": 2.1,
//    "channels": [{"name": "jawOpen", "keys": [[0, 0], [0.12, 0.5]]}]}
// Source: OpenFaceFX, "Track format". The rows are those of its fps. Channels of visemes are no units of a
// face.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "import/json_stream.hpp"
#include "import/reading.hpp"
#include "import/take_reading.hpp"

namespace mien {

namespace {

constexpr double kTrackRate = 60, kMostTrackRate = 240;

enum TrackRole { kTrackOther, kTrackWhole, kTrackChannels, kTrackChannel, kTrackKeys, kTrackKey };

struct FaceTrack {
  std::string name;
  JsonSpot spot;
  std::vector<std::array<double, 2>> keys;
};

struct TrackReader {
  std::string file;
  double fps = 0;
  std::vector<FaceTrack> tracks = {};
  std::vector<double> key = {};
};

int open_track(TrackReader& reader, const JsonUse::Steps& steps, bool is_list, JsonSpot spot) {
  if (steps.empty()) {
    if (is_list) fail_json(reader.file, spot, "a list; expected an object with 'channels'");
    return kTrackWhole;
  }
  const JsonStep& around = steps.back();
  if (around.role == kTrackWhole && around.key == "channels" && is_list) return kTrackChannels;
  if (around.role == kTrackChannels) {
    if (is_list) fail_json(reader.file, spot, "a list; expected {\"name\": .., \"keys\": [..]}");
    if (reader.tracks.size() >= kMaxTakeChannels)
      fail_json(reader.file, spot, fmt::format("more than {} channels; expected fewer", kMaxTakeChannels));
    reader.tracks.push_back({{}, spot, {}});
    return kTrackChannel;
  }
  if (around.role == kTrackChannel && around.key == "keys" && is_list) return kTrackKeys;
  if (around.role == kTrackKeys) {
    if (!is_list) fail_json(reader.file, spot, "an object; expected a key such as [0.12, 0.5]");
    reader.key.clear();
    return kTrackKey;
  }
  return kTrackOther;
}

void close_track(TrackReader& reader, const JsonUse::Steps& steps, JsonSpot spot) {
  if (steps.back().role != kTrackKey) return;
  auto& keys = reader.tracks.back().keys;
  if (reader.key.size() != 2)
    fail_json(reader.file, spot,
              fmt::format("a key of {} numbers; expected a time and a value", reader.key.size()));
  const double at_s = reader.key[0];
  if (at_s < 0 || at_s > kMaxTakeTime_s || (!keys.empty() && at_s < keys.back()[0]))
    fail_json(reader.file, spot, fmt::format("a key at {:.7g} s; expected rising times from 0 on", at_s));
  if (std::abs(reader.key[1]) > 10)
    fail_json(reader.file, spot, fmt::format("a value of {:.7g}; expected one from 0 to 1", reader.key[1]));
  if (keys.size() >= kMaxTakeValues / kMaxTakeChannels)
    fail_json(reader.file, spot, "too many keys; expected a shorter take");
  keys.push_back({at_s, reader.key[1]});
}

void take_track_number(TrackReader& reader, const JsonUse::Steps& steps, double value, JsonSpot spot) {
  if (steps.empty()) fail_json(reader.file, spot, "a number alone; expected an object with 'channels'");
  const JsonStep& around = steps.back();
  if (around.role == kTrackKey && reader.key.size() < 3) reader.key.push_back(value);
  if (around.role == kTrackKeys) fail_json(reader.file, spot, "a number; expected a key such as [0.12, 0.5]");
  if (around.role != kTrackWhole || around.key != "fps" || reader.fps > 0) return;
  if (value <= 0 || value > kMostTrackRate)
    fail_json(reader.file, spot, fmt::format("'fps' is {:.7g}; expected 1 to {}", value, kMostTrackRate));
  reader.fps = value;
}

double sample_track(const FaceTrack& track, double at_s) {
  const auto next = std::ranges::upper_bound(track.keys, at_s, {}, [](const auto& key) { return key[0]; });
  if (next == track.keys.begin()) return track.keys.front()[1];
  const auto before = next - 1;
  if (next == track.keys.end()) return (*before)[1];
  const double share = (at_s - (*before)[0]) / ((*next)[0] - (*before)[0]);
  return (*before)[1] + share * ((*next)[1] - (*before)[1]);
}

Take build_track_take(const TrackReader& reader) {
  Take take;
  take.file = reader.file;
  take.mapping = "arkit";
  double end_s = 0;
  for (const FaceTrack& track : reader.tracks) {
    if (track.name.empty()) fail_json(reader.file, track.spot, "a channel without a name; expected one");
    if (track.keys.empty()) continue;
    add_take_channel(take, {reader.file, track.spot.line, {}, 0, track.spot.column},
                     build_arkit_name(track.name));
    end_s = std::max(end_s, track.keys.back()[0]);
  }
  const double fps = reader.fps > 0 ? reader.fps : kTrackRate;
  const auto rows = static_cast<std::size_t>(std::ceil(end_s * fps - 1e-9)) + 1;
  for (std::size_t row = 0; row < rows && !take.channels.empty(); ++row) {
    const double at_s = static_cast<double>(row) / fps;
    if (!begin_take_row(take, {reader.file, 0, {}, 0, 0}, at_s)) continue;
    take.at_s.push_back(at_s);
    for (const FaceTrack& track : reader.tracks)
      if (!track.keys.empty()) take.values.push_back(static_cast<float>(sample_track(track, at_s)));
  }
  return take;
}

}  // namespace

Take read_face_tracks(const std::filesystem::path& file, double fps) {
  TrackReader reader{file.string(), fps};
  JsonUse use;
  use.open = [&](const auto& steps, bool is_list, JsonSpot spot) {
    return open_track(reader, steps, is_list, spot);
  };
  use.close = [&](const auto& steps, JsonSpot spot) { close_track(reader, steps, spot); };
  use.number = [&](const auto& steps, double value, JsonSpot spot) {
    take_track_number(reader, steps, value, spot);
  };
  use.text = [&](const auto& steps, const std::string& value, JsonSpot spot) {
    if (steps.empty()) fail_json(reader.file, spot, "a text alone; expected an object with 'channels'");
    if (steps.back().role == kTrackChannel && steps.back().key == "name") reader.tracks.back().name = value;
    if (steps.back().role == kTrackKey) fail_json(reader.file, spot, "a text; expected a time and a value");
  };
  read_json_stream(file, "tracks of OpenFaceFX", use);
  return build_track_take(reader);
}

}  // namespace mien

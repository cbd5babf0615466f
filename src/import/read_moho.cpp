// Switch data of Moho: a line "MohoSwitch1", then a frame and the name of the mouth from then on in each.
// Frames count from 1, and 0 is where Moho keeps what is before the first. Sources: Rhubarb Lip Sync README,
// "--datFrameRate" and "--datUsePrestonBlair"; Synfig wiki, "Lipsync" (the line "FPS 24"). Papagayo repeats
// a rest within a frame: of two mouths in a frame the later one counts.
#include <fmt/format.h>
#include <cmath>

#include "import/mouth_reading.hpp"
#include "import/reading.hpp"

namespace mien {

namespace {

struct SwitchKey {
  long long frame = 0;  // from 0
  MouthWord name;
  std::size_t at = 0;
};

double parse_switch_rate(const MouthText& text, MouthWord word) {
  const auto rate = parse_coordinate(word.word);
  if (!rate || *rate < 1 || *rate > kMaxMouthRate)
    fail_at(text, word.at,
            fmt::format("'{}' is no number of frames a second; expected one from 1 to {}",
                        show_words(word.word), kMaxMouthRate));
  return *rate;
}

void append_key(const MouthText& text, std::vector<SwitchKey>& keys, const SwitchKey& key) {
  if (!keys.empty() && key.frame < keys.back().frame)
    fail_at(text, key.at, "this frame is before the one of the line before; expected rising frames");
  if (!keys.empty() && key.frame == keys.back().frame)
    keys.back() = key;
  else
    keys.push_back(key);
  if (keys.size() > kMaxMouthCues)
    fail_at(text, key.at, fmt::format("more than {} cues; expected fewer", kMaxMouthCues));
}

}  // namespace

MouthTrack read_moho(const MouthText& text, double fps) {
  std::size_t next = 0;
  MouthWord line;
  read_full_line(text, next, line);
  line = trim_word(line);
  if (line.word != "MohoSwitch1")
    fail_at(text, line.at, fmt::format("'{}'; expected MohoSwitch1", show_words(line.word)));
  const std::size_t head = line.at;
  std::vector<SwitchKey> keys;
  std::vector<MouthWord> words, names;
  while (read_full_line(text, next, line)) {
    split_line(line, words);
    if (words.size() != 2)
      fail_at(text, words.front().at,
              fmt::format("a line of {} word{}; expected a frame and a mouth, such as 12 MBP", words.size(),
                          words.size() == 1 ? "" : "s"));
    if (words[0].word == "FPS" && keys.empty()) {
      fps = parse_switch_rate(text, words[1]);
      continue;
    }
    const long long frame = std::max(parse_frame(text, words[0], 0), 1LL) - 1;
    names.push_back(words[1]);
    append_key(text, keys, {frame, words[1], words[0].at});
  }
  if (keys.empty()) fail_at_end(text, "the file ends here; expected lines such as 12 MBP");
  if (!(fps > 0) || !std::isfinite(fps))
    fail_at(text, head, "the file does not say how many frames a second it counts; expected them as fps");
  MouthTrack track;
  track.names = find_mouth_names(text, names, {MouthNames::preston_blair, MouthNames::rhubarb});
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const SwitchKey& key = keys[i];
    const bool is_last = i + 1 == keys.size();
    const long long to = is_last ? key.frame + 1 : keys[i + 1].frame;
    const double from_s = compute_frame_time(text, key.at, key.frame, fps);
    track.end_s = compute_frame_time(text, is_last ? key.at : keys[i + 1].at, to, fps);
    append_cue(text, track.cues, key.at, from_s, track.end_s, std::string(key.name.word));
  }
  return track;
}

}  // namespace mien

#include "voice/line.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "render/process.hpp"
#include "render/video_kind.hpp"
#include "voice/cue_mouths.hpp"
#include "voice/recording.hpp"
#include "voice/speaker.hpp"
#include "voice/text.hpp"

namespace mien {

namespace {

[[noreturn]] void throw_mistake(const Place& place, std::string message) {
  throw InputError(std::vector<Diagnostic>{{place, std::move(message), {}, false}});
}

void check_recording(const FileReference& sound) {
  require_programs({{"ffprobe", "ffmpeg"}, {"ffmpeg", "ffmpeg"}});
  if (!is_sound(sound.path))
    throw_mistake(sound.place,
                  fmt::format("'{}' has no sound that ffmpeg can read; expected a file such as voice.wav",
                              sound.path.filename().string()));
}

SpokenText speak(const SaySpec& line, const std::string& text) {
  if (!has_speaker())
    throw_mistake(line.text_place,
                  "there is no mien-speak to say it; it is built where libespeak-ng-dev is installed: ./run "
                  "setup, then "
                  "./run build");
  try {
    return speak_text(text, line.voice, line.pace);
  } catch (const RunError& error) {
    const std::string_view what = error.what();
    if (!what.starts_with("unknown voice")) throw;
    throw_mistake(line.voice_place, fmt::format("{}; expected one of: mien-speak --voices", what));
  }
}

// Until the next word or pause.
double find_word_end(const SpokenText& spoken, std::size_t word) {
  double end_s = word + 1 < spoken.words.size() ? spoken.words[word + 1].at_s : spoken.length_s;
  for (const SpeechSound& sound : spoken.sounds)
    if (sound.ipa.empty() && sound.from_s > spoken.words[word].at_s) end_s = std::min(end_s, sound.from_s);
  return end_s;
}

bool overlaps(const TextSpan& span, int from, int to) { return span.from < to && from < span.to; }

std::vector<LineWord> list_words(const SaidText& said, const SpokenText& spoken) {
  std::vector<LineWord> words;
  for (std::size_t i = 0; i < spoken.words.size(); ++i) {
    const SpokenPlace& place = spoken.words[i];
    LineWord word{place.at_s, find_word_end(spoken, i),
                  take_letters(said.plain, {place.from, place.from + place.length})};
    for (const TextSpan& span : said.stressed)
      word.is_stressed |= overlaps(span, place.from, place.from + place.length);
    words.push_back(std::move(word));
  }
  for (const TextSpan& question : said.questions)
    for (std::size_t i = words.size(); i-- > 0;)
      if (spoken.words[i].from < question.to) {
        words[i].asks = true;
        break;
      }
  return words;
}

// All times by `place`, from the line's own time to the clip's.
template <typename Place>
SpokenLine place_spoken(const SpeechData& data, const SaidText& said, const SpokenText& spoken,
                        const Place& place_s) {
  SpokenLine line;
  for (const SpeechSound& sound : spoken.sounds) {
    const double from_s = place_s(sound.from_s), to_s = place_s(sound.to_s);
    append_segments(find_ipa_visemes(data, sound.ipa), from_s, to_s, sound.stress, line.segments);
    if (!sound.ipa.empty()) line.phonemes.push_back({from_s, to_s, sound.ipa});
  }
  line.words = list_words(said, spoken);
  for (LineWord& word : line.words) {
    word.from_s = place_s(word.from_s);
    word.to_s = place_s(word.to_s);
  }
  return line;
}

SpokenLine understand_text(const SaySpec& line, const SpeechData& data) {
  const SaidText said = read_said_text(line.text);
  const SpokenText spoken = speak(line, said.plain);
  SpokenLine result;
  if (!line.sound) {
    result = place_spoken(data, said, spoken, [&](double time_s) { return line.at_s + time_s; });
    result.sounds = {{line.at_s, {}, spoken.wav}};
    return result;
  }
  check_recording(*line.sound);
  const std::vector<VoicedSpan> heard = find_voiced(line.sound->path),
                                said_spans = find_voiced(spoken.sounds);
  if (heard.empty())
    throw_mistake(line.sound->place, fmt::format("'{}' is silent; expected somebody who says the text",
                                                 line.sound->path.filename().string()));
  result = place_spoken(data, said, spoken,
                        [&](double time_s) { return line.at_s + warp_time_s(time_s, said_spans, heard); });
  result.sounds = {{line.at_s, line.sound->path}};
  return result;
}

// A word whose time alone is known is spoken, and its sounds spread over that time.
void append_word(const SaySpec& line, const SpeechData& data, const MouthCue& cue, SpokenLine& into) {
  const SpokenText spoken = speak(line, cue.name);
  const std::vector<VoicedSpan> said = find_voiced(spoken.sounds);
  if (said.empty()) return;
  const VoicedSpan all{said.front().from_s, said.back().to_s};
  const auto place_s = [&](double time_s) {
    return line.at_s + warp_time_s(time_s, {all}, {{cue.from_s, cue.to_s}});
  };
  for (const SpeechSound& sound : spoken.sounds) {
    if (sound.ipa.empty()) continue;
    const double from_s = place_s(sound.from_s), to_s = place_s(sound.to_s);
    append_segments(find_ipa_visemes(data, sound.ipa), from_s, to_s, sound.stress, into.segments);
    into.phonemes.push_back({from_s, to_s, sound.ipa});
  }
}

SpokenLine understand_mouths(const SaySpec& line, const SpeechData& data, int fps) {
  if (line.sound) check_recording(*line.sound);
  const MouthTrack track = load_mouth_track(line.mouths->path, fps);
  SpokenLine result;
  if (track.names == MouthNames::words)
    for (const MouthCue& cue : track.cues) append_word(line, data, cue, result);
  for (const auto& [cue, visemes, stress] : list_cue_mouths(track, data)) {
    const double from_s = line.at_s + cue.from_s, to_s = line.at_s + cue.to_s;
    append_segments(visemes, from_s, to_s, stress, result.segments);
    result.phonemes.push_back({from_s, to_s, cue.name});
  }
  for (const MouthCue& word : track.names == MouthNames::words ? track.cues : track.words)
    result.words.push_back({line.at_s + word.from_s, line.at_s + word.to_s, word.name});
  if (line.sound) result.sounds = {{line.at_s, line.sound->path}};
  return result;
}

}  // namespace

SpokenLine understand_line(const SaySpec& line, const SpeechData& data, int fps) {
  SpokenLine result = line.mouths ? understand_mouths(line, data, fps) : understand_text(line, data);
  result.from_s = result.segments.empty() ? line.at_s : result.segments.front().from_s;
  result.to_s = result.segments.empty() ? line.at_s : result.segments.back().to_s;
  return result;
}

}  // namespace mien

// Papagayo's .pgo, "lipsync version 1": sound, frames a second, how many frames, then voices of phrases of
// words of phonemes, each with its frames, from 0; ends are the last frame that still belongs. A phoneme
// lasts until the next one of its word, or until the word's end; between words the mouth rests. There is no
// documentation but the program; LipsyncDoc of Papagayo-NG shows what it writes.
#include <fmt/format.h>
#include <algorithm>

#include "import/mouth_reading.hpp"

namespace mien {

namespace {

constexpr long long kMostVoices = 100;
constexpr std::string_view kRestName = "rest";  // in every set of phonemes; only one of ours has it
constexpr auto kMostParts = static_cast<long long>(kMaxMouthCues);

struct PapagayoReader {
  const MouthText& text;
  std::size_t next = 0;
  MouthWord line;
  std::vector<MouthWord> words;
  double fps = 0;
  double shown_s = 0;  // up to where earlier words have the mouth
  MouthTrack track;
  std::vector<MouthWord> names;
};

// A line that may be empty: a path, a name, what is said.
void read_free_line(PapagayoReader& file, const std::string& expected) {
  if (!read_text_line(file.text, file.next, file.line))
    fail_at_end(file.text, fmt::format("the file ends here; expected {}", expected));
}

void read_part_line(PapagayoReader& file, const std::string& expected) {
  if (!read_full_line(file.text, file.next, file.line))
    fail_at_end(file.text, fmt::format("the file ends here; expected {}", expected));
  split_line(file.line, file.words);
}

long long read_count_line(PapagayoReader& file, const std::string& what, long long most) {
  read_part_line(file, "the number of " + what);
  return parse_count(file.text, trim_word(file.line), what, 0, most);
}

// The first and the last frame of a word; its phonemes are between them.
struct FrameSpan {
  long long first = 0, last = 0;
};

FrameSpan parse_span(const PapagayoReader& file, MouthWord first, MouthWord last) {
  const FrameSpan span{parse_frame(file.text, first, 0), parse_frame(file.text, last, 0)};
  if (span.last < span.first)
    fail_at(file.text, last.at,
            fmt::format("this ends with frame {} and begins with {}; expected an end after its beginning",
                        span.last, span.first));
  compute_frame_time(file.text, last.at, span.last + 1, file.fps);
  return span;
}

// A phoneme, which its successor or its word's end ends.
struct FramePhoneme {
  long long frame = 0;
  MouthWord name;
  std::size_t at = 0;
};

FramePhoneme read_phoneme(PapagayoReader& file, const FrameSpan& span, long long before) {
  read_part_line(file, "a phoneme, such as 12 MBP");
  if (file.words.size() != 2)
    fail_at(file.text, file.words.front().at,
            "this is no phoneme; expected a frame and a name, such as 12 MBP");
  const FramePhoneme phoneme{parse_frame(file.text, file.words[0], 0), file.words[1], file.words[0].at};
  if (phoneme.frame < span.first || phoneme.frame > span.last)
    fail_at(file.text, phoneme.at,
            fmt::format("this phoneme has the frame {}; expected one of its word's, {} to {}", phoneme.frame,
                        span.first, span.last));
  if (phoneme.frame < before)
    fail_at(file.text, phoneme.at,
            "this phoneme is before the one of the line before; expected rising frames");
  return phoneme;
}

// Where two words share a frame the earlier one has it, and of two phonemes in a frame the later one.
void append_frames(PapagayoReader& file, std::vector<MouthCue>& cues, std::size_t at, long long from,
                   long long to, MouthWord name) {
  const double from_s = std::max(file.shown_s, compute_frame_time(file.text, at, from, file.fps));
  const double to_s = compute_frame_time(file.text, at, to, file.fps);
  if (to_s > from_s) append_cue(file.text, cues, at, from_s, to_s, std::string(name.word));
}

void read_word(PapagayoReader& file) {
  read_part_line(file, "a word, such as hello 10 20 4");
  if (file.words.size() != 4)
    fail_at(file.text, file.words.front().at,
            "this is no word; expected it, its first and last frame, and how many phonemes it has, such as "
            "hello 10 20 4");
  const std::vector<MouthWord> words = file.words;
  const FrameSpan span = parse_span(file, words[1], words[2]);
  const long long count = parse_count(file.text, words[3], "phonemes", 0, kMostParts);
  if (compute_frame_time(file.text, words[1].at, span.last + 1, file.fps) < file.shown_s)
    fail_at(file.text, words[1].at, "this word is before the one before it; expected rising frames");
  const std::string_view said = strip_punctuation(words[0].word);
  if (!said.empty())
    append_frames(file, file.track.words, words[0].at, span.first, span.last + 1, {said, words[0].at});
  FramePhoneme before{span.first, {}, 0};
  for (long long i = 0; i < count; ++i) {
    const FramePhoneme phoneme = read_phoneme(file, span, before.frame);
    if (i > 0) append_frames(file, file.track.cues, before.at, before.frame, phoneme.frame, before.name);
    if (phoneme.name.word != kRestName) file.names.push_back(phoneme.name);
    before = phoneme;
  }
  if (count > 0) append_frames(file, file.track.cues, before.at, before.frame, span.last + 1, before.name);
  file.shown_s = compute_frame_time(file.text, words[2].at, span.last + 1, file.fps);
}

void read_phrase(PapagayoReader& file) {
  read_free_line(file, "what a phrase says");
  read_part_line(file, "the phrase's first frame");
  const MouthWord first = trim_word(file.line);
  read_part_line(file, "the phrase's last frame");
  parse_span(file, first, trim_word(file.line));
  const long long words = read_count_line(file, "words", kMostParts);
  for (long long i = 0; i < words; ++i) read_word(file);
}

void read_voice(PapagayoReader& file) {
  const bool has_mouth = !file.track.cues.empty();
  read_free_line(file, "the name of a voice");
  const MouthWord name = trim_word(file.line);
  read_free_line(file, "what the voice says");
  const long long phrases = read_count_line(file, "phrases", kMostParts);
  if (has_mouth && phrases > 0)
    fail_at(file.text, name.at,
            fmt::format("a second voice, '{}'; expected one, and a file for each", show_words(name.word)));
  for (long long i = 0; i < phrases; ++i) read_phrase(file);
}

}  // namespace

MouthTrack read_papagayo(const MouthText& text) {
  PapagayoReader file{text, 0, {}, {}, 0, 0, {}, {}};
  read_part_line(file, "lipsync version 1");
  const MouthWord head = trim_word(file.line);
  if (head.word != "lipsync version 1")
    fail_at(text, head.at, fmt::format("'{}'; expected lipsync version 1", show_words(head.word)));
  read_free_line(file, "the path of the sound");
  read_part_line(file, "the number of frames a second");
  const MouthWord rate = trim_word(file.line);
  file.fps = static_cast<double>(
      parse_count(text, rate, "frames a second", 1, static_cast<long long>(kMaxMouthRate)));
  read_part_line(file, "the number of frames");
  const MouthWord duration = trim_word(file.line);
  const double end_s = compute_frame_time(text, duration.at, parse_frame(text, duration, 0), file.fps);
  const long long voices = read_count_line(file, "voices", kMostVoices);
  for (long long i = 0; i < voices; ++i) read_voice(file);
  if (read_full_line(text, file.next, file.line))
    fail_at(text, trim_word(file.line).at,
            "something stands behind the last voice; expected the end of the file");
  MouthTrack& track = file.track;
  track.names = find_mouth_names(text, file.names,
                                 {MouthNames::preston_blair, MouthNames::rhubarb, MouthNames::arpabet});
  if (track.names != MouthNames::preston_blair)
    std::erase_if(track.cues, [](const MouthCue& cue) { return cue.name == kRestName; });
  track.end_s = std::max(end_s, file.shown_s);
  return std::move(track);
}

}  // namespace mien

// What the readers of mouth tracks share: a text and places in it, words, times, names and cues.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "import/mouth_track.hpp"

namespace mien {

// A file's text: UTF-8 without a byte order mark, lines end with '\n', no other control characters but tabs.
struct MouthText {
  std::string file;  // as messages name it
  std::string text;
  std::vector<std::size_t> line_starts;  // offset of each line in `text`
};

// Frames a second; faster ones are no picture's.
inline constexpr double kMaxMouthRate = 1000;

// A piece of a text, and the offset at which it begins.
struct MouthWord {
  std::string_view word;
  std::size_t at = 0;
};

// Makes one of a file's bytes; throws InputError if they are no text.
MouthText build_mouth_text(std::string file, std::string bytes);

// Throws InputError with the line and column (in characters) of an offset.
[[noreturn]] void fail_at(const MouthText& text, std::size_t at, const std::string& message);
// The same at the end of the last line that has words.
[[noreturn]] void fail_at_end(const MouthText& text, const std::string& message);

// The line, from 1, of an offset.
int find_line_number(const MouthText& text, std::size_t at);

// A file's words as a message shows them: short.
std::string show_words(std::string_view words);

// The line that begins at `next`, without its end; `next` moves on. False after the last one.
bool read_text_line(const MouthText& text, std::size_t& next, MouthWord& line);
// The same for the next one that is not blank.
bool read_full_line(const MouthText& text, std::size_t& next, MouthWord& line);

// Without blanks around it.
MouthWord trim_word(MouthWord word);

// The words of a line, into `words` (a buffer that is used again).
void split_line(MouthWord line, std::vector<MouthWord>& words);

// A number of seconds, of frames, or of something else from `least` to `most`.
double parse_seconds(const MouthText& text, MouthWord word);
long long parse_frame(const MouthText& text, MouthWord word, long long least);
long long parse_count(const MouthText& text, MouthWord word, const std::string& what, long long least,
                      long long most);

// Frames as seconds; `at` is told if they are too many.
double compute_frame_time(const MouthText& text, std::size_t at, long long frames, double fps);

// Throws unless `seconds`, which stands at `at`, is a time.
void check_seconds(const MouthText& text, std::size_t at, double seconds);

// Where something from `from_s` to `to_s` begins that stands at `at` and comes after `before_s`; throws if
// times do not rise.
double find_start(const MouthText& text, std::size_t at, double before_s, double from_s, double to_s);

// Adds a cue that stands at `at`; throws if its times do not rise, or if there are too many.
void append_cue(const MouthText& text, std::vector<MouthCue>& cues, std::size_t at, double from_s,
                double to_s, std::string name);

// Whether it is one of the names; of IPA and of words, whether it may be one.
bool is_mouth_name(MouthNames names, std::string_view name);
// Throws unless it is.
void check_mouth_name(const MouthText& text, MouthNames names, MouthWord name);
// Which of several kinds the names of a file are of: the first to which all belong. If there is none, throws
// at the first name that does not belong to the kind that has most.
MouthNames find_mouth_names(const MouthText& text, const std::vector<MouthWord>& names,
                            std::initializer_list<MouthNames> kinds);
// Whether a phoneme's name means that nothing is said.
bool is_silence(std::string_view name);

// A word without punctuation around it; empty if nothing else is there.
std::string_view strip_punctuation(std::string_view word);

// One reader a format.
MouthTrack read_rhubarb_tsv(const MouthText& text);
MouthTrack read_rhubarb_xml(const MouthText& text);
MouthTrack read_rhubarb_json(const MouthText& text);
MouthTrack read_moho(const MouthText& text, double fps);
MouthTrack read_papagayo(const MouthText& text);
MouthTrack read_textgrid(const MouthText& text);
MouthTrack read_webvtt(const MouthText& text);
MouthTrack read_phoneme_csv(const MouthText& text);

}  // namespace mien

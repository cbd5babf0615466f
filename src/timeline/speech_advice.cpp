#include "timeline/speech_advice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/text.hpp"

namespace mien {

namespace {

constexpr std::size_t kMostWords = 5;  // that a warning names
constexpr double kMostUnseen = 0.4;    // of a line's sounds that may go by between drawings

// All of a line that is heard.
struct SaidSpan {
  double from_s = 0, to_s = 0;
  Place place;
};

bool is_same(const Place& a, const Place& b) {
  return a.line == b.line && a.column == b.column && a.file == b.file;
}

std::vector<SaidSpan> list_said(const ClipSpec& clip) {
  std::vector<SaidSpan> said;
  for (const SpokenWord& sound : clip.phonemes) {
    if (said.empty() || !is_same(said.back().place, sound.place))
      said.push_back({sound.from_s, sound.to_s, sound.place});
    said.back().to_s = std::max(said.back().to_s, sound.to_s);
  }
  return said;
}

Diagnostic warn(const Place& place, std::string message) { return {place, std::move(message), {}, true}; }

// Those of a line that no drawing shows, by what each is called; `count` becomes how many the line has.
std::vector<std::string> list_unseen(const std::vector<SpokenWord>& spoken, const Place& line,
                                     const std::vector<double>& times_s, bool has_times, std::size_t& count) {
  std::vector<std::string> unseen;
  count = 0;
  for (const SpokenWord& word : spoken) {
    if (!is_same(word.place, line)) continue;
    ++count;
    const auto shown = std::ranges::lower_bound(times_s, word.from_s);
    if (shown != times_s.end() && *shown < word.to_s) continue;
    unseen.push_back(has_times ? fmt::format("{} at {}s", word.text, format_number(word.from_s, 2))
                               : word.text);
  }
  return unseen;
}

std::string join_some(std::vector<std::string> names) {
  const bool has_more = names.size() > kMostWords;
  if (has_more) names.resize(kMostWords);
  return fmt::format("{}{}", fmt::join(names, ", "), has_more ? " ..." : "");
}

}  // namespace

std::vector<Diagnostic> advise_speech(const ClipSpec& clip, const std::vector<double>& drawn_s) {
  std::vector<Diagnostic> advice;
  const std::vector<SaidSpan> said = list_said(clip);
  for (std::size_t i = 1; i < said.size(); ++i)
    if (said[i].from_s < said[i - 1].to_s)
      advice.push_back(warn(
          said[i].place, fmt::format("this line begins at {}s, and the one before it is said until {}s; one "
                                     "mouth says one of them",
                                     format_number(said[i].from_s, 2), format_number(said[i - 1].to_s, 2))));
  std::vector<double> times_s = drawn_s;
  std::ranges::sort(times_s);
  for (const SaidSpan& line : said) {
    std::size_t count = 0;
    const std::vector<std::string> words = list_unseen(clip.words, line.place, times_s, false, count);
    if (!words.empty())
      advice.push_back(
          warn(line.place, fmt::format("no drawing shows {} of its words: {}; 'draw: ones' shows the most",
                                       words.size(), join_some(words))));
    // Some sounds are shorter than a frame, and nobody misses them.
    const std::vector<std::string> sounds = list_unseen(clip.phonemes, line.place, times_s, true, count);
    if (static_cast<double>(sounds.size()) > kMostUnseen * static_cast<double>(count))
      advice.push_back(
          warn(line.place, fmt::format("mouths too short to be seen: no drawing shows {} of its {} sounds: "
                                       "{}; a slower 'pace' or 'draw: ones' shows more",
                                       sounds.size(), count, join_some(sounds))));
  }
  return advice;
}

}  // namespace mien

#include "timeline/speech_advice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/text.hpp"

namespace mien {

namespace {

constexpr std::size_t kMostWords = 5;  // that a warning names

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
    std::vector<std::string> unseen;
    for (const SpokenWord& word : clip.words) {
      if (!is_same(word.place, line.place)) continue;
      const auto shown = std::ranges::lower_bound(times_s, word.from_s);
      if (shown == times_s.end() || *shown >= word.to_s) unseen.push_back(word.text);
    }
    if (unseen.empty()) continue;
    const std::size_t count = unseen.size();
    if (count > kMostWords) unseen.resize(kMostWords);
    advice.push_back(
        warn(line.place, fmt::format("no drawing shows {} of its words: {}{}; 'draw: ones' shows the most",
                                     count, fmt::join(unseen, ", "), count > kMostWords ? " ..." : "")));
  }
  return advice;
}

}  // namespace mien

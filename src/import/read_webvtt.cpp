// WebVTT: blocks between blank lines; a cue has a line with its times and lines of text, in which tags such
// as <00:00:01.200> say when a word begins. Source: W3C, "WebVTT: The Web Video Text Tracks Format". Words
// between two such times, or in a cue without any, share the time evenly.
#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <optional>

#include "import/mouth_reading.hpp"
#include "import/reading.hpp"

namespace mien {

namespace {

// [hours:]minutes:seconds.thousandths
std::optional<double> parse_caption_time(std::string_view word) {
  double seconds = 0;
  int parts = 0;
  while (true) {
    const std::size_t colon = word.find(':');
    const std::string_view part = word.substr(0, colon);
    const bool is_last = colon == std::string_view::npos;
    const bool is_right = !part.empty() && std::ranges::all_of(part, [&](char c) {
      return std::isdigit(static_cast<unsigned char>(c)) || (is_last && c == '.');
    });
    const auto number = is_right ? parse_coordinate(part) : std::nullopt;
    const bool is_hours = parts == 0 && std::ranges::count(word, ':') == 2;
    if (!number || ++parts > 3 || (!is_hours && *number >= 60)) return std::nullopt;
    seconds = seconds * 60 + *number;
    if (is_last) break;
    word.remove_prefix(colon + 1);
  }
  return parts < 2 ? std::nullopt : std::optional(seconds);
}

double read_caption_time(const MouthText& text, MouthWord word) {
  const auto seconds = parse_caption_time(word.word);
  if (!seconds)
    fail_at(text, word.at,
            fmt::format("'{}' is no time; expected one such as 00:01.500 or 01:02:03.500",
                        show_words(word.word)));
  check_seconds(text, word.at, *seconds);
  return *seconds;
}

struct Caption {
  double from_s = 0, to_s = 0;
  std::size_t at = 0;
  std::vector<MouthWord> lines;
};

// A line such as "00:01.000 --> 00:02.500 align:start".
void read_caption_times(const MouthText& text, MouthWord line, Caption& caption) {
  const std::size_t arrow = line.word.find("-->");
  const MouthWord from = trim_word({line.word.substr(0, arrow), line.at});
  std::vector<MouthWord> behind;
  split_line({line.word.substr(arrow + 3), line.at + arrow + 3}, behind);
  caption.at = from.at;
  caption.from_s = read_caption_time(text, from);
  if (behind.empty()) fail_at(text, line.at + arrow, "a cue without an end; expected a time behind -->");
  caption.to_s = read_caption_time(text, behind.front());
  if (caption.to_s <= caption.from_s)
    fail_at(text, behind.front().at,
            fmt::format("this cue lasts from {:.7g} s to {:.7g} s; expected an end after its beginning",
                        caption.from_s, caption.to_s));
}

// "&amp;" and its like as the letters that they mean.
std::string replace_entities(std::string_view text) {
  static constexpr std::pair<std::string_view, std::string_view> kEntities[] = {
      {"&amp;", "&"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&nbsp;", "\u00A0"}, {"&lrm;", ""}, {"&rlm;", ""}};
  std::string plain;
  while (!text.empty()) {
    const auto entity =
        std::ranges::find_if(kEntities, [&](const auto& pair) { return text.starts_with(pair.first); });
    if (entity != std::end(kEntities)) {
      plain += entity->second;
      text.remove_prefix(entity->first.size());
    } else {
      plain += text.front();
      text.remove_prefix(1);
    }
  }
  return plain;
}

struct CaptionWord {
  std::string name;
  std::size_t at = 0;
};

// The words of a cue between two times of it.
struct CaptionRun {
  double from_s = 0;
  std::vector<CaptionWord> words;
};

void append_plain_words(CaptionRun& run, MouthWord piece) {
  std::vector<MouthWord> words;
  split_line(piece, words);
  for (const MouthWord& word : words) {
    const std::string plain = replace_entities(word.word);
    const std::string_view name = strip_punctuation(plain);
    if (!name.empty()) run.words.push_back({std::string(name), word.at});
  }
}

void read_caption_tag(const MouthText& text, const Caption& caption, MouthWord tag,
                      std::vector<CaptionRun>& runs) {
  if (tag.word.empty() || !std::isdigit(static_cast<unsigned char>(tag.word.front()))) return;  // <c>, </i>
  const double at_s = read_caption_time(text, tag);
  if (at_s < runs.back().from_s || at_s > caption.to_s)
    fail_at(text, tag.at,
            fmt::format("the time {:.7g} s; expected one from {:.7g} s, where the words before it begin, to "
                        "{:.7g} s, where the cue ends",
                        at_s, runs.back().from_s, caption.to_s));
  runs.push_back({at_s, {}});
}

std::vector<CaptionRun> list_runs(const MouthText& text, const Caption& caption) {
  std::vector<CaptionRun> runs{{caption.from_s, {}}};
  for (MouthWord line : caption.lines) {
    while (!line.word.empty()) {
      const std::size_t open = std::min(line.word.find('<'), line.word.size());
      append_plain_words(runs.back(), {line.word.substr(0, open), line.at});
      if (open == line.word.size()) break;
      const std::size_t close = line.word.find('>', open);
      if (close == std::string_view::npos)
        fail_at(text, line.at + open, "nothing closes this tag; expected '>', or &lt; for the sign itself");
      read_caption_tag(text, caption, {line.word.substr(open + 1, close - open - 1), line.at + open + 1},
                       runs);
      line = {line.word.substr(close + 1), line.at + close + 1};
    }
  }
  return runs;
}

void append_caption(const MouthText& text, const Caption& caption, MouthTrack& track) {
  find_start(text, caption.at, track.end_s, caption.from_s, caption.to_s);
  const std::vector<CaptionRun> runs = list_runs(text, caption);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const CaptionRun& run = runs[r];
    const double from_s = std::max(run.from_s, track.end_s);
    const double to_s = r + 1 < runs.size() ? runs[r + 1].from_s : caption.to_s;
    if (to_s <= from_s && !run.words.empty())
      fail_at(text, run.words.front().at, "no time is left for this word; expected rising times");
    const auto count = static_cast<double>(run.words.size());
    for (std::size_t w = 0; w < run.words.size(); ++w) {
      const auto place = static_cast<double>(w);
      append_cue(text, track.cues, run.words[w].at, from_s + (to_s - from_s) * place / count,
                 from_s + (to_s - from_s) * (place + 1) / count, run.words[w].name);
    }
  }
  track.end_s = caption.to_s;
}

bool has_arrow(MouthWord line) { return line.word.find("-->") != std::string_view::npos; }

// Whether a block's first line says that it is no cue.
bool is_other_block(std::string_view line) {
  return std::ranges::any_of(
      std::initializer_list<std::string_view>{"NOTE", "STYLE", "REGION"}, [&](std::string_view name) {
        return line.starts_with(name) &&
               (line.size() == name.size() || line[name.size()] == ' ' || line[name.size()] == '\t');
      });
}

// The lines up to the next empty one, or up to the times of another cue; a line of blanks belongs to its cue.
std::vector<MouthWord> read_block(const MouthText& text, std::size_t& next) {
  std::vector<MouthWord> block;
  MouthWord line;
  bool has_times = false;
  for (std::size_t begin = next; read_text_line(text, next, line) && !line.word.empty(); begin = next) {
    if (has_times && has_arrow(line)) {
      next = begin;
      break;
    }
    has_times |= has_arrow(line);
    block.push_back(line);
  }
  return block;
}

// A line without its tags.
std::string find_plain_line(std::string_view line) {
  std::string plain;
  bool is_tag = false;
  for (const char c : line) {
    is_tag |= c == '<';
    if (!is_tag) plain += c;
    if (c == '>') is_tag = false;
  }
  return std::string(trim_word({plain, 0}).word);
}

// Captions of live speech roll up: YouTube's show each line once more above the next one, and alone for a
// hundredth of a second between them. What was said is said once.
void drop_rolled_up(Caption& caption, std::string& shown) {
  constexpr double kGlimpse_s = 0.05;  // less than a word takes
  std::erase_if(caption.lines, [](MouthWord line) { return find_plain_line(line.word).empty(); });
  if (caption.lines.empty()) return;
  const std::string last = find_plain_line(caption.lines.back().word);
  const bool has_times = std::ranges::any_of(caption.lines, [](MouthWord line) {
    for (std::size_t at = 1; at < line.word.size(); ++at)
      if (line.word[at - 1] == '<' && std::isdigit(static_cast<unsigned char>(line.word[at]))) return true;
    return false;
  });
  const bool is_again = find_plain_line(caption.lines.front().word) == shown;
  if (is_again && (has_times || caption.to_s - caption.from_s < kGlimpse_s))
    caption.lines.erase(caption.lines.begin());
  shown = last;
}

void read_caption(const MouthText& text, const std::vector<MouthWord>& block, std::string& shown,
                  MouthTrack& track) {
  const std::size_t times =
      has_arrow(block.front()) || block.size() == 1 ? 0 : 1;  // a cue's name stands above
  if (!has_arrow(block[times]))
    fail_at(text, block.front().at,
            fmt::format("'{}' is no cue; expected a line such as 00:01.000 --> 00:02.500",
                        show_words(block.front().word)));
  Caption caption;
  read_caption_times(text, block[times], caption);
  caption.lines.assign(block.begin() + static_cast<std::ptrdiff_t>(times) + 1, block.end());
  drop_rolled_up(caption, shown);
  append_caption(text, caption, track);
}

}  // namespace

MouthTrack read_webvtt(const MouthText& text) {
  std::size_t next = std::min(text.text.find_first_not_of(" \t\n"), text.text.size());
  const std::vector<MouthWord> head = read_block(text, next);
  const std::string_view first = head.front().word;
  if (!first.starts_with("WEBVTT") || (first.size() > 6 && first[6] != ' ' && first[6] != '\t'))
    fail_at(text, head.front().at, fmt::format("'{}'; expected WEBVTT", show_words(first)));
  if (const auto cue = std::ranges::find_if(head, has_arrow); cue != head.end())
    fail_at(text, cue->at, "a cue follows the head at once; expected an empty line above it");
  MouthTrack track;
  track.names = MouthNames::words;
  std::string shown;  // the last line of the cue before
  while (next < text.text.size()) {
    const std::vector<MouthWord> block = read_block(text, next);
    const bool is_blank =
        std::ranges::all_of(block, [](MouthWord line) { return trim_word(line).word.empty(); });
    if (!is_blank && !is_other_block(block.front().word)) read_caption(text, block, shown, track);
  }
  return track;
}

}  // namespace mien

// Praat's TextGrid, long or short: both are the same row of texts in quotes, numbers that stand free and
// flags, with words between them that mean nothing, and '!' begins a comment. Source: Praat's manual,
// "TextGrid file formats". The Montreal Forced Aligner writes tiers "words" and "phones", or "NAME - words"
// and "NAME - phones" where several people speak (its manual, "Output format").
#include <fmt/format.h>
#include <algorithm>
#include <cctype>

#include "core/error.hpp"
#include "import/mouth_reading.hpp"

namespace mien {

namespace {

constexpr long long kMostTiers = 100;

struct GridToken {
  enum class Kind { number, text, flag, end } kind = Kind::end;
  MouthWord word;    // as it stands there
  std::string text;  // without quotes
};

struct GridReader {
  const MouthText& text;
  std::size_t at = 0;
};

GridToken read_grid_text(GridReader& grid) {
  const std::string& text = grid.text.text;
  GridToken token{GridToken::Kind::text, {{}, grid.at}, {}};
  std::size_t at = grid.at + 1;
  for (; at < text.size(); ++at) {
    if (text[at] == '"' && (at + 1 >= text.size() || text[at + 1] != '"')) break;
    if (text[at] == '"') ++at;  // one that belongs to the text is written twice
    token.text += text[at];
  }
  if (at >= text.size()) fail_at(grid.text, grid.at, "nothing closes this quote; expected one more");
  token.word.word = std::string_view(text).substr(grid.at, at + 1 - grid.at);
  grid.at = at + 1;
  return token;
}

GridToken read_grid_token(GridReader& grid) {
  const std::string& text = grid.text.text;
  while (true) {
    grid.at = std::min(text.find_first_not_of(" \t\n", grid.at), text.size());
    if (grid.at >= text.size()) return {GridToken::Kind::end, {{}, grid.at}, {}};
    const char c = text[grid.at];
    if (c == '"') return read_grid_text(grid);
    if (c == '!') {
      grid.at = std::min(text.find('\n', grid.at), text.size());
      continue;
    }
    const std::size_t end = std::min(text.find_first_of(" \t\n", grid.at), text.size());
    const MouthWord word{std::string_view(text).substr(grid.at, end - grid.at), grid.at};
    grid.at = end;
    const bool is_number = std::isdigit(static_cast<unsigned char>(c)) || c == '-' || c == '+';
    if (is_number) return {GridToken::Kind::number, word, {}};
    if (c == '<') return {GridToken::Kind::flag, word, {}};
  }
}

GridToken expect_grid(GridReader& grid, GridToken::Kind kind, const std::string& what) {
  GridToken token = read_grid_token(grid);
  if (token.kind == GridToken::Kind::end)
    fail_at_end(grid.text, fmt::format("the file ends here; expected {}", what));
  if (token.kind != kind)
    fail_at(grid.text, token.word.at, fmt::format("{}; expected {}", show_words(token.word.word), what));
  return token;
}

double read_grid_time(GridReader& grid, const std::string& what) {
  return parse_seconds(grid.text, expect_grid(grid, GridToken::Kind::number, what).word);
}

// What a tier is for; all others are passed.
enum class TierRole { none, phones, words };

TierRole find_tier_role(std::string name) {
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const std::size_t dash = name.rfind(" - ");
  if (dash != std::string::npos) name = name.substr(dash + 3);
  if (name == "phones" || name == "phone" || name == "phonemes") return TierRole::phones;
  return name == "words" || name == "word" ? TierRole::words : TierRole::none;
}

struct Tier {
  bool is_there = false;
  std::vector<MouthCue> cues;
  std::vector<MouthWord> names;
};

void append_interval(const MouthText& text, Tier& tier, TierRole role, const GridToken& name, double from_s,
                     double to_s) {
  if (name.text.find('\n') != std::string::npos)
    fail_at(text, name.word.at, "this text goes on in the next line; expected a quote at its end");
  std::string_view bare = trim_word({name.text, 0}).word;
  if (is_silence(bare)) return;
  if (role == TierRole::words) bare = strip_punctuation(bare);
  if (bare.empty()) return;
  append_cue(text, tier.cues, name.word.at, from_s, to_s, std::string(bare));
  // Within the file, without its quotes; a doubled quote is of no phoneme.
  tier.names.push_back(trim_word({name.word.word.substr(1, name.word.word.size() - 2), name.word.at + 1}));
}

void read_intervals(GridReader& grid, Tier& tier, bool is_points, TierRole role) {
  read_grid_time(grid, "the tier's beginning");
  read_grid_time(grid, "the tier's end");
  const GridToken size = expect_grid(grid, GridToken::Kind::number, "the number of intervals");
  const long long count =
      parse_count(grid.text, size.word, "intervals", 0, static_cast<long long>(kMaxMouthCues));
  double end_s = 0;
  for (long long i = 0; i < count; ++i) {
    const std::string which = fmt::format(" of interval {} of {}", i + 1, count);
    const GridToken from = expect_grid(grid, GridToken::Kind::number, "the beginning" + which);
    const double from_s = parse_seconds(grid.text, from.word);
    const double to_s = is_points ? from_s : read_grid_time(grid, "the end" + which);
    const GridToken name = expect_grid(grid, GridToken::Kind::text, "the text" + which);
    if (role == TierRole::none) continue;
    append_interval(grid.text, tier, role, name, find_start(grid.text, from.word.at, end_s, from_s, to_s),
                    to_s);
    end_s = to_s;
  }
}

void read_tier(GridReader& grid, Tier& phones, Tier& words, std::string& passed) {
  const GridToken kind = expect_grid(grid, GridToken::Kind::text, "\"IntervalTier\"");
  if (kind.text != "IntervalTier" && kind.text != "TextTier")
    fail_at(grid.text, kind.word.at,
            fmt::format("'{}' is no tier; expected IntervalTier or TextTier", show_words(kind.text)));
  const GridToken name = expect_grid(grid, GridToken::Kind::text, "the name of a tier");
  const bool is_points = kind.text == "TextTier";
  const TierRole role = is_points ? TierRole::none : find_tier_role(name.text);
  Tier other;
  Tier& tier = role == TierRole::phones ? phones : role == TierRole::words ? words : other;
  if (tier.is_there)
    fail_at(grid.text, name.word.at,
            fmt::format("a second tier of {}, '{}'; expected one speaker a file",
                        role == TierRole::phones ? "phones" : "words", show_words(name.text)));
  tier.is_there = true;
  if (role == TierRole::none)
    passed += fmt::format("{}'{}'", passed.empty() ? "" : ", ", show_words(name.text));
  read_intervals(grid, tier, is_points, role);
}

void read_grid_head(GridReader& grid) {
  const GridToken type = expect_grid(grid, GridToken::Kind::text, "\"ooTextFile\"");
  if (!type.text.starts_with("ooTextFile"))
    fail_at(grid.text, type.word.at,
            fmt::format("'{}' is no kind of file; expected ooTextFile", show_words(type.text)));
  const GridToken object = expect_grid(grid, GridToken::Kind::text, "\"TextGrid\"");
  if (object.text != "TextGrid")
    fail_at(grid.text, object.word.at,
            fmt::format("an object of class '{}'; expected TextGrid", show_words(object.text)));
}

}  // namespace

MouthTrack read_textgrid(const MouthText& text) {
  GridReader grid{text, 0};
  read_grid_head(grid);
  MouthTrack track;
  read_grid_time(grid, "the grid's beginning");
  track.end_s = read_grid_time(grid, "the grid's end");
  const GridToken flag = expect_grid(grid, GridToken::Kind::flag, "<exists>");
  if (flag.word.word != "<exists>")
    fail_at(text, flag.word.at, fmt::format("{}; expected <exists>", show_words(flag.word.word)));
  const GridToken size = expect_grid(grid, GridToken::Kind::number, "the number of tiers");
  const long long count = parse_count(text, size.word, "tiers", 0, kMostTiers);
  Tier phones, words;
  std::string passed;
  for (long long i = 0; i < count; ++i) read_tier(grid, phones, words, passed);
  if (const GridToken more = read_grid_token(grid); more.kind != GridToken::Kind::end)
    fail_at(text, more.word.at,
            fmt::format("{} behind the last tier; expected the end of the file", show_words(more.word.word)));
  if (!phones.is_there && !words.is_there)
    fail_at(text, size.word.at,
            fmt::format("no tier is called phones or words, but {}; expected one of them",
                        passed.empty() ? "there is none" : passed));
  if (phones.is_there) {
    track.names = find_mouth_names(text, phones.names, {MouthNames::arpabet, MouthNames::ipa});
    track.cues = std::move(phones.cues);
    track.words = std::move(words.cues);
  } else {
    track.names = MouthNames::words;
    track.cues = std::move(words.cues);
  }
  for (const std::vector<MouthCue>* cues : {&track.cues, &track.words})
    if (!cues->empty()) track.end_s = std::max(track.end_s, cues->back().to_s);
  return track;
}

}  // namespace mien

// A table of phonemes in IPA, with a line of names: from,to,phoneme (or start,end,phoneme), or time,phoneme,
// where each stays until the next line's time. A line without a phoneme, or with a silence, is a pause.
#include <fmt/format.h>
#include <algorithm>

#include "import/mouth_reading.hpp"

namespace mien {

namespace {

char find_cell_separator(std::string_view line) {
  for (const char c : {';', '\t'})
    if (line.find(c) != std::string_view::npos) return c;
  return ',';
}

// The cells of a line, without blanks and quotes around them.
void split_phoneme_cells(MouthWord line, char separator, std::vector<MouthWord>& cells) {
  cells.clear();
  for (std::size_t begin = 0; begin <= line.word.size();) {
    const std::size_t end = std::min(line.word.find(separator, begin), line.word.size());
    MouthWord cell = trim_word({line.word.substr(begin, end - begin), line.at + begin});
    if (cell.word.size() >= 2 && cell.word.front() == '"' && cell.word.back() == '"')
      cell = trim_word({cell.word.substr(1, cell.word.size() - 2), cell.at + 1});
    cells.push_back(cell);
    begin = end + 1;
  }
}

// Whether each line has its end; throws if the names are others.
bool has_ends(const MouthText& text, const std::vector<MouthWord>& names) {
  const auto is_named = [&](std::initializer_list<std::string_view> expected) {
    return std::ranges::equal(names, expected, {}, &MouthWord::word);
  };
  if (is_named({"from", "to", "phoneme"}) || is_named({"start", "end", "phoneme"})) return true;
  if (is_named({"time", "phoneme"})) return false;
  fail_at(text, names.front().at,
          "the first line has other names; expected from,to,phoneme or start,end,phoneme or time,phoneme");
}

struct PhonemeRow {
  double from_s = 0;
  MouthWord name;
  std::size_t at = 0;
};

void append_row(const MouthText& text, MouthTrack& track, const PhonemeRow& row, double to_s) {
  if (is_silence(row.name.word)) {
    find_start(text, row.at, track.end_s, row.from_s, to_s);
  } else {
    check_mouth_name(text, MouthNames::ipa, row.name);
    append_cue(text, track.cues, row.at, row.from_s, to_s, std::string(row.name.word));
  }
  track.end_s = to_s;
}

}  // namespace

MouthTrack read_phoneme_csv(const MouthText& text) {
  std::size_t next = 0;
  MouthWord line;
  read_full_line(text, next, line);
  const char separator = find_cell_separator(line.word);
  std::vector<MouthWord> cells;
  split_phoneme_cells(line, separator, cells);
  const bool is_with_ends = has_ends(text, cells);
  const std::size_t count = cells.size();
  MouthTrack track;
  track.names = MouthNames::ipa;
  PhonemeRow before;
  bool is_first = true;
  while (read_full_line(text, next, line)) {
    split_phoneme_cells(line, separator, cells);
    if (cells.size() != count)
      fail_at(text, cells.front().at,
              fmt::format("this line has {} cell{}; expected {} as in the first line", cells.size(),
                          cells.size() == 1 ? "" : "s", count));
    const PhonemeRow row{parse_seconds(text, cells[0]), cells.back(), cells[0].at};
    if (is_with_ends) {
      append_row(text, track, row, parse_seconds(text, cells[1]));
      continue;
    }
    if (!is_first && row.from_s <= before.from_s)
      fail_at(text, row.at, "this time is not after the one of the line before; expected rising times");
    if (!is_first) append_row(text, track, before, row.from_s);
    before = row;
    is_first = false;
  }
  if (!is_with_ends && !is_silence(before.name.word))
    fail_at_end(
        text, fmt::format("nothing says when the last phoneme '{}' ends; expected one more line, with a time "
                          "and no phoneme",
                          show_words(before.name.word)));
  return track;
}

}  // namespace mien

// Rhubarb Lip Sync's table: each line has a time and the shape from then on, the last line the end of the
// recording and a closed mouth. Source: DanielSWolf/rhubarb-lip-sync README, "Tab-separated values".
#include <fmt/format.h>

#include "import/mouth_reading.hpp"

namespace mien {

MouthTrack read_rhubarb_tsv(const MouthText& text) {
  MouthTrack track;
  std::vector<MouthWord> words;
  MouthWord line, shape;
  double from_s = 0;
  for (std::size_t next = 0; read_full_line(text, next, line);) {
    split_line(line, words);
    if (words.size() != 2)
      fail_at(text, words.front().at,
              fmt::format("a line of {} word{}; expected seconds, a tab and a shape", words.size(),
                          words.size() == 1 ? "" : "s"));
    const double at_s = parse_seconds(text, words[0]);
    if (!shape.word.empty() && at_s <= from_s)
      fail_at(
          text, words[0].at,
          fmt::format("this time is not after {:.7g} s, of the line before; expected rising times", from_s));
    check_mouth_name(text, MouthNames::rhubarb, words[1]);
    if (!shape.word.empty()) append_cue(text, track.cues, shape.at, from_s, at_s, std::string(shape.word));
    from_s = at_s;
    shape = words[1];
  }
  if (shape.word != "X" && shape.word != "A")
    fail_at_end(text,
                fmt::format("the last line has the open mouth '{}'; expected the time of the end, and X "
                            "or A",
                            shape.word));
  track.end_s = from_s;
  return track;
}

}  // namespace mien

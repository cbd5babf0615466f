#include "voice/cues_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "config/findings.hpp"
#include "core/text.hpp"
#include "voice/cue_mouths.hpp"

namespace mien {

namespace {

// "{lips: {upper: 0.2}, corners: {out: 0.3}}": an area's two sides as one where they do the same.
std::string build_areas_text(const Pose& pose) {
  std::vector<std::string> areas;
  for (const AreaInfo& area : kAreas) {
    std::vector<std::string> moves;
    for (std::size_t i = 0; i < kMoveCount; ++i)
      if (kMoves[i].of == area.area && kMoves[i].side != Side::right && pose.values[i] != 0)
        moves.push_back(fmt::format("{}: {}", kMoves[i].move, format_number(pose.values[i], 3)));
    if (!moves.empty())
      areas.push_back(
          fmt::format("{}: {{{}}}", area.has_sides() ? area.plural : area.name, fmt::join(moves, ", ")));
  }
  return fmt::format("{{{}}}", fmt::join(areas, ", "));
}

// The word that begins with a mouth, as a comment behind its key.
std::string find_word(const MouthTrack& track, const MouthSegment& segment) {
  for (const MouthCue& word : track.words)
    if (word.from_s >= segment.from_s - 1e-6 && word.from_s < segment.to_s - 1e-6)
      return "        # " + word.name;
  return "";
}

}  // namespace

std::string build_cues_text(const MouthTrack& track, const SpeechData& data, const std::string& name,
                            const std::string& source) {
  const std::vector<MouthSegment> segments = list_track_segments(track, data);
  std::set<std::size_t> used;
  for (const MouthSegment& segment : segments) used.insert(segment.viseme);
  std::string text = fmt::format(
      "# The mouths of {}. To have them in another file: include: {{file: {}.yaml, take: [scripts]}}, and a "
      "cue\n"
      "# that plays the script. Without changing anything, `say: [{{mouths: {}}}]` follows the file itself.\n"
      "mien: 1\ntitle: {}\nexpressions:\n",
      show_word(source), name, show_word(source), name);
  text += "  shut: {}\n";
  for (const std::size_t viseme : used)
    text += fmt::format("  {}: {}  # {}\n", data.visemes[viseme].name,
                        build_areas_text(data.visemes[viseme].pose), data.visemes[viseme].meaning);
  const double end_s = std::max(track.end_s, segments.empty() ? 0 : segments.back().to_s);
  text +=
      fmt::format("clip:\n  length: {}s\n  draw: ones\n  scripts:\n    {}:\n      length: {}s\n      keys:\n",
                  format_number(end_s, 3), name, format_number(end_s, 3));
  double said_s = 0;
  std::string last;  // two keys of a millisecond are one
  const auto add_key = [&](double at_s, const std::string& express, const std::string& word) {
    const std::string at = format_number(at_s, 3);
    if (at == last) return;
    last = at;
    text += fmt::format("        - {{at: {}s, express: {}}}{}\n", at, express, word);
  };
  for (const MouthSegment& segment : segments) {
    constexpr double kPause_s = 0.2;  // between two mouths: it is shut
    if (segment.from_s - said_s > kPause_s || segment.from_s == segments.front().from_s) {
      if (said_s > 0) add_key(said_s, "shut", "");
      add_key(segment.from_s, "shut", "");
    }
    add_key((segment.from_s + segment.to_s) / 2, data.visemes[segment.viseme].name,
            find_word(track, segment));
    said_s = segment.to_s;
  }
  add_key(end_s > said_s ? said_s : end_s, "shut", "");
  text += fmt::format("  cues:\n    - {{from: 0s, play: {}, areas: [lips, corners, chin, tongue]}}\n", name);
  return text;
}

}  // namespace mien

#include "import/mouth_track.hpp"

#include <algorithm>
#include <cctype>

#include "core/text.hpp"
#include "import/mouth_reading.hpp"
#include "import/reading.hpp"

namespace mien {

namespace {

constexpr const char* kMouthEndings = ".tsv, .xml, .json, .dat, .pgo, .TextGrid, .vtt, .csv or .txt";

// The ending that a text of this content has if people do not call it .txt.
std::string find_content_ending(const MouthText& text) {
  const std::string_view content = trim_word({text.text, 0}).word;
  if (content.starts_with("WEBVTT")) return ".vtt";
  if (content.starts_with("MohoSwitch1")) return ".dat";
  if (content.starts_with("lipsync version")) return ".pgo";
  if (content.starts_with("File type")) return ".textgrid";
  if (content.starts_with('<')) return ".xml";
  if (content.starts_with('{')) return ".json";
  if (std::isdigit(static_cast<unsigned char>(content.front()))) return ".tsv";
  for (const char* name : {"from", "start", "time"})
    if (content.starts_with(name)) return ".csv";
  fail_at(text, 0,
          "this is no track of a mouth that is known; expected what Rhubarb, Moho, Papagayo or Praat "
          "write, WebVTT, or a table of phonemes");
}

}  // namespace

MouthTrack load_mouth_track(const std::filesystem::path& path, double fps) {
  const std::string file = path.string();
  std::string ending = find_ending(path);
  constexpr std::string_view kEndings[] = {".tsv",      ".xml", ".json", ".dat", ".pgo",
                                           ".textgrid", ".vtt", ".csv",  ".txt"};
  if (std::ranges::find(kEndings, ending) == std::end(kEndings))
    fail_file(file, std::string("the name ends otherwise; expected ") + kMouthEndings);
  const MouthText text =
      build_mouth_text(file, read_plain_file(path, file, "a track of a mouth", kMaxMouthBytes));
  if (text.text.find_first_not_of(" \t\n") == std::string::npos)
    fail_file(file, "is empty; expected a track of a mouth");
  if (ending == ".txt") ending = find_content_ending(text);
  MouthTrack track = ending == ".tsv"        ? read_rhubarb_tsv(text)
                     : ending == ".xml"      ? read_rhubarb_xml(text)
                     : ending == ".json"     ? read_rhubarb_json(text)
                     : ending == ".dat"      ? read_moho(text, fps)
                     : ending == ".pgo"      ? read_papagayo(text)
                     : ending == ".textgrid" ? read_textgrid(text)
                     : ending == ".vtt"      ? read_webvtt(text)
                                             : read_phoneme_csv(text);
  if (track.cues.empty()) fail_file(file, "has no cues; expected one at least");
  return track;
}

}  // namespace mien

// What tracks of mouths of all formats have in common: files, encodings, limits, and that no damage does
// harm.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "fuzz_rounds.hpp"
#include "import/mouth_samples.hpp"

namespace mien {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 11> kSamples{"hi.tsv",         "hi.xml",       "hi.json",   "hi.dat",
                                               "letters.dat",    "hi.pgo",       "words.vtt", "long.TextGrid",
                                               "short.TextGrid", "phonemes.csv", "times.csv"};

// All that is read, but for the lines.
std::string describe_track(const MouthTrack& track) {
  std::string text = fmt::format("{} {}\n", static_cast<int>(track.names), track.end_s);
  for (const std::vector<MouthCue>* cues : {&track.cues, &track.words})
    for (const MouthCue& cue : *cues) text += fmt::format("{} {} {}\n", cue.from_s, cue.to_s, cue.name);
  return text;
}

std::string replace_all(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

// In UTF-16; the samples have no letters beyond its first plane.
std::string widen(const std::string& text, bool is_big) {
  std::string wide = is_big ? "\xFE\xFF" : "\xFF\xFE";
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto first = static_cast<unsigned char>(text[i]);
    unsigned code = first;
    const auto follow = [&] { return static_cast<unsigned char>(text[++i]) & 0x3Fu; };
    if (first >= 0xE0) {
      code = (first & 0x0Fu) << 12;
      code |= follow() << 6;
      code |= follow();
    } else if (first >= 0xC0) {
      code = (first & 0x1Fu) << 6;
      code |= follow();
    }
    const char high = static_cast<char>(code >> 8), low = static_cast<char>(code & 0xFF);
    wide += is_big ? high : low;
    wide += is_big ? low : high;
  }
  return wide;
}

TEST(mouth_track, says_the_same_in_every_encoding_and_with_every_line_end) {
  for (const std::string name : kSamples) {
    const std::string text = read_mouth_sample(name);
    const std::string expected = describe_track(load_mouth_bytes(name, text));
    EXPECT_EQ(describe_track(load_mouth_bytes(name, "\xEF\xBB\xBF" + text)), expected) << name;
    EXPECT_EQ(describe_track(load_mouth_bytes(name, widen(text, false))), expected) << name;
    EXPECT_EQ(describe_track(load_mouth_bytes(name, widen(text, true))), expected) << name;
    EXPECT_EQ(describe_track(load_mouth_bytes(name, replace_all(text, "\n", "\r\n"))), expected) << name;
    EXPECT_EQ(describe_track(load_mouth_bytes(name, replace_all(text, "\n", "\r"))), expected) << name;
    EXPECT_EQ(describe_track(load_mouth_bytes(name, "\n \n" + text + "\n\n \n")), expected) << name;
    EXPECT_EQ(describe_track(load_mouth_bytes(name, text.substr(0, text.find_last_not_of("\n") + 1))),
              expected)
        << name;
    EXPECT_EQ(describe_track(load_mouth_bytes(name + ".txt", text)), expected) << name << " by its content";
  }
}

TEST(mouth_track, a_place_is_the_same_with_every_line_end) {
  const std::string broken = break_sample("short.TextGrid", "\"z\"", "\"Z\"");
  const std::string fault =
      "a.TextGrid:32:2: error: unknown phoneme 'Z'; expected one in IPA, such as a, tʃ or iː";
  EXPECT_EQ(find_mouth_fault("a.TextGrid", broken), fault);
  EXPECT_EQ(find_mouth_fault("a.TextGrid", replace_all(broken, "\n", "\r\n")), fault);
  EXPECT_EQ(find_mouth_fault("a.TextGrid", widen(broken, false)), fault);
}

TEST(mouth_track, tells_which_files_it_reads) {
  EXPECT_EQ(
      find_mouth_fault("a.wav", "x"),
      "a.wav: error: the name ends otherwise; expected .tsv, .xml, .json, .dat, .pgo, .TextGrid, .vtt, .csv "
      "or .txt");
  EXPECT_EQ(
      find_mouth_fault("a.txt", "hello"),
      "a.txt:1:1: error: this is no track of a mouth that is known; expected what Rhubarb, Moho, Papagayo or "
      "Praat write, WebVTT, or a table of phonemes");
  EXPECT_EQ(find_mouth_fault("a.txt", " \n\n"), "a.txt: error: is empty; expected a track of a mouth");
  EXPECT_EQ(find_mouth_fault("a.csv", ""), "a.csv: error: is empty; expected a track of a mouth");
  const fs::path folder = fs::path(testing::TempDir()) / "mien_mouths";
  fs::create_directories(folder / "folder.tsv");
  EXPECT_EQ(find_mouth_fault(folder / "folder.tsv"),
            "folder.tsv: error: is a folder; expected a track of a mouth");
  EXPECT_EQ(find_mouth_fault(folder / "none.tsv"),
            "none.tsv: error: there is no such file; expected a track of a mouth");
  const fs::path large = write_mouth_file("large.tsv", "0 X");
  fs::resize_file(large, kMaxMouthBytes + 1);
  EXPECT_EQ(find_mouth_fault(large), "large.tsv: error: has 33554433 bytes; expected 33554432 at most");
  fs::remove(large);
}

TEST(mouth_track, tells_what_is_no_text) {
  EXPECT_EQ(
      find_mouth_fault("a.csv", "time,phoneme\n0,\xE9\n"),
      "a.csv:2:3: error: the byte E9 is no UTF-8; expected a text in UTF-8, or in UTF-16 with its mark");
  EXPECT_EQ(find_mouth_fault("a.tsv", std::string("0\tX\n1\t\0\n", 8)),
            "a.tsv:2:3: error: the control character 00; expected a text");
  EXPECT_EQ(find_mouth_fault("a.tsv",
                             "\xFF\xFE"
                             "0"),
            "a.tsv: error: is UTF-16 and has 3 bytes; expected two a letter");
  EXPECT_EQ(find_mouth_fault("a.tsv", std::string("\xFE\xFF\xD8\x00", 4)),
            "a.tsv: error: is no UTF-16, as its first bytes say; expected UTF-8, or UTF-16 with its mark");
}

TEST(mouth_track, has_no_more_cues_than_a_day_of_speech) {
  std::string tsv, dat = "MohoSwitch1\n";
  for (int i = 0; i <= 100'001; ++i) {
    tsv += std::to_string(i / 10) + "." + std::to_string(i % 10) + "\tX\n";
    dat += std::to_string(i + 1) + " rest\n";
  }
  EXPECT_EQ(find_mouth_fault("many.tsv", tsv),
            "many.tsv:100001:9: error: more than 100000 cues; expected fewer");
  EXPECT_EQ(find_mouth_fault("many.dat", dat),
            "many.dat:100002:1: error: more than 100000 cues; expected fewer");
  EXPECT_EQ(load_mouth_bytes("most.tsv", tsv.substr(0, tsv.find("10000.1\t"))).cues.size(), 100'000u);
}

// What every track must be, whatever the file was.
void check_track(const MouthTrack& track, const std::string& bytes) {
  EXPECT_FALSE(track.cues.empty()) << bytes;
  for (const std::vector<MouthCue>* cues : {&track.cues, &track.words}) {
    double before_s = 0;
    for (const MouthCue& cue : *cues) {
      EXPECT_GE(cue.from_s, before_s) << bytes;
      EXPECT_GT(cue.to_s, cue.from_s) << bytes;
      EXPECT_LE(cue.to_s, kMaxMouthTime_s) << bytes;
      EXPECT_LE(cue.to_s, track.end_s) << bytes;
      EXPECT_FALSE(cue.name.empty()) << bytes;
      EXPECT_GE(cue.line, 1) << bytes;
      before_s = cue.to_s;
    }
  }
}

// A line, a byte or the rest gone, a number or a word in another's place, two files in one.
std::string damage(std::string bytes, const std::string& other, std::mt19937& random) {
  static const std::array<std::string, 16> kWords{
      "-1", "1e308", "nan", "0", "\"",  "<",  ">",    "\n\n",
      "\t", "AH9",   "é",   "!", "-->", "{}", "\xC3", "999999999999999999"};
  for (std::size_t i = 1 + random() % 4; i > 0 && !bytes.empty(); --i) {
    const std::size_t at = random() % bytes.size(), length = random() % 12;
    switch (random() % 6) {
      case 0:
        bytes.resize(at);
        break;
      case 1:
        bytes.erase(at, length);
        break;
      case 2:
        bytes[at] = static_cast<char>(random());
        break;
      case 3:
        bytes.replace(at, length, kWords[random() % kWords.size()]);
        break;
      case 4:
        bytes.insert(at, bytes.substr(random() % bytes.size(), 40));
        break;
      default:
        bytes.replace(at, length, other.substr(random() % other.size(), length));
        break;
    }
  }
  return bytes;
}

TEST(mouth_track, damage_is_read_or_told_and_never_more) {
  std::mt19937 random(find_fuzz_seed(11));
  std::vector<std::string> whole;
  for (const char* name : kSamples) whole.push_back(read_mouth_sample(name));
  const int rounds = count_fuzz_rounds(600);
  int told = 0;
  for (int round = 0; round < rounds; ++round) {
    const std::size_t sample = random() % kSamples.size();
    const std::string bytes = damage(whole[sample], whole[random() % whole.size()], random);
    const std::string name = random() % 8 == 0 ? "broken.txt" : std::string("broken_") + kSamples[sample];
    try {
      check_track(load_mouth_bytes(name, bytes, round % 3 == 0 ? 0 : 24), bytes);
    } catch (const InputError& e) {
      ++told;
      EXPECT_FALSE(e.diagnostics.at(0).message.empty()) << bytes;
    }
  }
  EXPECT_GT(told, rounds / 2);
}

}  // namespace
}  // namespace mien

// Praat's TextGrids, as the Montreal Forced Aligner writes them.
#include "import/mouth_samples.hpp"

namespace mien {
namespace {

const std::string kArpabet =
    "AA, AE, AH, AO, AW, AY, B, CH, D, DH, EH, ER, EY, F, G, HH, IH, IY, JH, K, L, M, N, NG, OW, OY, P, R, "
    "S, SH, "
    "T, TH, UH, UW, V, W, Y, Z or ZH, vowels with a stress from 0 to 2 or without";

TEST(textgrid, long_is_read) {
  const MouthTrack track = load_mouth_sample("long.TextGrid");
  EXPECT_EQ(track.names, MouthNames::arpabet);
  EXPECT_EQ(describe_mouth_cues(track.cues),
            "0.1 0.18 HH :40\n"
            "0.18 0.25 AH0 :44\n"
            "0.25 0.36 L :48\n"
            "0.36 0.62 OW1 :52\n");
  EXPECT_EQ(describe_mouth_cues(track.words), "0.1 0.62 hello :22\n");
  EXPECT_NEAR(track.end_s, 0.9, 1e-12);
}

TEST(textgrid, short_is_read) {
  const MouthTrack track = load_mouth_sample("short.TextGrid");
  EXPECT_EQ(track.names, MouthNames::ipa);
  EXPECT_EQ(describe_mouth_cues(track.cues),
            "0.1 0.2 tʃ :26\n"
            "0.2 0.38 iː :29\n"
            "0.38 0.5 z :32\n");
  EXPECT_EQ(describe_mouth_cues(track.words), "0.1 0.5 cheese :15\n");
  EXPECT_NEAR(track.end_s, 0.8, 1e-12);
}

std::string build_grid(const std::string& tiers, int count = 1) {
  return "File type = \"ooTextFile\"\nObject class = \"TextGrid\"\n0 2 <exists> " + std::to_string(count) +
         "\n" + tiers;
}

TEST(textgrid, words_alone_are_cues) {
  const MouthTrack track = load_mouth_bytes(
      "words.TextGrid",
      build_grid(
          "\"IntervalTier\" \"Words\" 0 2 4 ! times and texts\n0 1 \"hello,\" 1 1.5 \"-\" 1.5 1.7 \"<unk>\" "
          "1.7 2 \"don't\""));
  EXPECT_EQ(track.names, MouthNames::words);
  EXPECT_EQ(describe_mouth_cues(track.cues), "0 1 hello :5\n1.7 2 don't :5\n");
  EXPECT_TRUE(track.words.empty());
}

TEST(textgrid, ends_and_beginnings_that_are_rounded_meet) {
  const MouthTrack track = load_mouth_bytes(
      "round.TextGrid", build_grid("\"IntervalTier\" \"phones\" 0 2 2 0 0.50001 \"a\" 0.5 1 \"b\""));
  EXPECT_EQ(track.cues[1].from_s, 0.50001);
}

TEST(textgrid, other_tiers_are_passed_and_told_when_they_are_all) {
  const std::string point = "\"TextTier\" \"phones\" 0 2 1 0.5 \"x\"\n";
  const std::string other = "\"IntervalTier\" \"Mary\" 0 2 1 0 2 \"x\"\n";
  EXPECT_EQ(find_mouth_fault("other.TextGrid", build_grid(point + other, 2)),
            "other.TextGrid:3:14: error: no tier is called phones or words, but 'phones', 'Mary'; expected "
            "one of them");
  EXPECT_EQ(find_mouth_fault("other.TextGrid", build_grid("", 0)),
            "other.TextGrid:3:14: error: no tier is called phones or words, but there is none; expected one "
            "of them");
  EXPECT_EQ(find_mouth_fault("silent.TextGrid", build_grid("\"IntervalTier\" \"phones\" 0 2 1 0 2 \"sil\"")),
            "silent.TextGrid: error: has no cues; expected one at least");
}

TEST(textgrid, long_tells_what_is_wrong_and_where) {
  expect_mouth_faults(
      "long.TextGrid",
      {{"ooTextFile", "ooBinary", ":1:13: error: 'ooBinary' is no kind of file; expected ooTextFile"},
       {"class = \"TextGrid\"", "class = \"Pitch\"",
        ":2:16: error: an object of class 'Pitch'; expected TextGrid"},
       {"<exists>", "<absent>", ":6:8: error: <absent>; expected <exists>"},
       {"size = 2 \n", "size = 3 \n", ":56:22: error: the file ends here; expected \"IntervalTier\""},
       {"size = 2 \n", "size = x \n", ":10:17: error: \"IntervalTier\"; expected the number of tiers"},
       {"xmax = 0.18", "xmax = 0.1x", ":39:20: error: '0.1x' is no time; expected seconds from 0 to 86400"},
       {"xmax = 0.18", "xmax = 0.05",
        ":38:20: error: this lasts from 0.1 s to 0.05 s; expected an end after its beginning"},
       {"\"HH\"", "HH", ":42:20: error: 0.18; expected the text of interval 2 of 6"},
       {"\"HH\"", "\"HHH\"", ":40:21: error: unknown phoneme 'HHH'; expected " + kArpabet},
       {"\"AH0\"", "\"AH3\"", ":44:21: error: unknown phoneme 'AH3'; expected " + kArpabet},
       {"\"L\"", "\"L", ":48:20: error: this text goes on in the next line; expected a quote at its end"},
       {"\"phones\"", "\"words\"",
        ":29:16: error: a second tier of words, 'words'; expected one speaker a file"},
       {"\"IntervalTier\" \n        name = \"phones\"", "\"Tier\" \n        name = \"phones\"",
        ":28:17: error: 'Tier' is no tier; expected IntervalTier or TextTier"},
       {"size = 6", "size = 7",
        ":56:22: error: the file ends here; expected the beginning of interval 7 of 7"},
       {"size = 6", "size = 5", ":54:20: error: 0.62 behind the last tier; expected the end of the file"},
       {"size = 6", "size = 1000000",
        ":32:27: error: '1000000' is no number of intervals; expected one from 0 to 100000"},
       {"xmin = 0.25", "xmin = 0.2",
        ":46:20: error: this begins at 0.2 s, and what is before it ends at 0.25 s; expected rising times"},
       {"xmin = 0.25", "xmin = -0.25", ":46:20: error: '-0.25' is no time; expected seconds from 0 to 86400"},
       {"xmin = 0 \nxmax = 0.9 \ntiers", "tiers", ":4:8: error: <exists>; expected the grid's beginning"},
       {"\"AH0\"", "\"ah\"", ":44:21: error: unknown phoneme 'ah'; expected " + kArpabet}});
}

TEST(textgrid, short_tells_what_is_wrong_and_where) {
  expect_mouth_faults(
      "short.TextGrid",
      {{"\"tʃ\"", "\"t ʃ\"", ":26:2: error: unknown phoneme 't ʃ'; expected one in IPA, such as a, tʃ or iː"},
       {"\"tʃ\"", "\"T5\"", ":26:2: error: unknown phoneme 'T5'; expected one in IPA, such as a, tʃ or iː"},
       {"0.2\n0.38", "0.38\n0.2",
        ":27:1: error: this lasts from 0.38 s to 0.2 s; expected an end after its beginning"},
       {"0.2\n0.38", "0.1\n0.38",
        ":27:1: error: this begins at 0.1 s, and what is before it ends at 0.2 s; expected rising times"},
       {"0.38\n\"iː\"", "\n\"iː\"", ":29:1: error: \"iː\"; expected the end of interval 2 of 3"},
       {"\"Anna - phones\"", "\"Bob - words\"",
        ":20:1: error: a second tier of words, 'Bob - words'; expected one speaker a file"},
       {"0.8\n<exists>", "<exists>", ":5:1: error: <exists>; expected the grid's end"},
       {"3\n\"IntervalTier\"", "2.5\n\"IntervalTier\"",
        ":7:1: error: '2.5' is no number of tiers; expected one from 0 to 100"},
       {"\"a \"\"loud\"\" one\"\n", "",
        ":38:4: error: the file ends here; expected the text of interval 1 of 1"},
       {"\"z\"", "\"zzzzzzzzzzzzzzzzz\"",
        ":32:2: error: unknown phoneme 'zzzzzzzzzzzzzzzzz'; expected one in IPA, such as a, tʃ or iː"},
       {"0\n0.8\n<", "0\n90000\n<", ":5:1: error: '90000' is no time; expected seconds from 0 to 86400"},
       {"\"cheese\"", "cheese", ":16:1: error: 0.5; expected the text of interval 1 of 2"}});
}

}  // namespace
}  // namespace mien

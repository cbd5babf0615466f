// Tables of phonemes.
#include "import/mouth_samples.hpp"

namespace mien {
namespace {

TEST(phoneme_csv, with_ends_is_read) {
  const MouthTrack track = load_mouth_sample("phonemes.csv");
  EXPECT_EQ(track.names, MouthNames::ipa);
  EXPECT_EQ(describe_mouth_cues(track.cues),
            "0.1 0.18 h :2\n"
            "0.18 0.25 ə :3\n"
            "0.25 0.36 l :4\n"
            "0.36 0.62 oʊ :5\n");
  EXPECT_EQ(describe_mouth_cues(track.words), "");
  EXPECT_NEAR(track.end_s, 0.9, 1e-12);
}

TEST(phoneme_csv, with_times_is_read) {
  const MouthTrack track = load_mouth_sample("times.csv");
  EXPECT_EQ(track.names, MouthNames::ipa);
  EXPECT_EQ(describe_mouth_cues(track.cues),
            "0.1 0.2 tʃ :2\n"
            "0.2 0.38 iː :3\n"
            "0.5 0.61 z :5\n");
  EXPECT_EQ(describe_mouth_cues(track.words), "");
  EXPECT_NEAR(track.end_s, 0.61, 1e-12);
}

TEST(phoneme_csv, with_ends_tells_what_is_wrong_and_where) {
  expect_mouth_faults(
      "phonemes.csv",
      {{"from,to,phoneme", "from,to,phone",
        ":1:1: error: the first line has other names; expected from,to,phoneme or start,end,phoneme or "
        "time,phoneme"},
       {"from,to,phoneme", "from,phoneme",
        ":1:1: error: the first line has other names; expected from,to,phoneme or start,end,phoneme or "
        "time,phoneme"},
       {"0.18,0.25,ə", "0.18,0.25", ":3:1: error: this line has 2 cells; expected 3 as in the first line"},
       {"0.18,0.25,ə", "0.18,0.25,ə,1",
        ":3:1: error: this line has 4 cells; expected 3 as in the first line"},
       {"0.18,0.25,ə", "0.10,0.25,ə",
        ":3:1: error: this begins at 0.1 s, and what is before it ends at 0.18 s; expected rising times"},
       {"0.18,0.25,ə", "0.18,0.18,ə",
        ":3:1: error: this lasts from 0.18 s to 0.18 s; expected an end after its beginning"},
       {"0.18,0.25,ə", "0.18,x,ə", ":3:6: error: 'x' is no time; expected seconds from 0 to 86400"},
       {"0.18,0.25,ə", "-0.18,0.25,ə", ":3:1: error: '-0.18' is no time; expected seconds from 0 to 86400"},
       {"0.18,0.25,ə", "0.18,0.25,AH0",
        ":3:11: error: unknown phoneme 'AH0'; expected one in IPA, such as a, tʃ or iː"},
       {"0.18,0.25,ə", "0.18,inf,ə", ":3:6: error: 'inf' is no time; expected seconds from 0 to 86400"},
       {"0.62,0.90,", "0.60,0.90,",
        ":6:1: error: this begins at 0.6 s, and what is before it ends at 0.62 s; expected rising times"},
       {"oʊ", "o ʊ", ":5:11: error: unknown phoneme 'o ʊ'; expected one in IPA, such as a, tʃ or iː"},
       {"0.36,0.62", "0.36,86400.5", ":5:6: error: '86400.5' is no time; expected seconds from 0 to 86400"}});
}

TEST(phoneme_csv, with_times_tells_what_is_wrong_and_where) {
  expect_mouth_faults(
      "times.csv",
      {{"time;phoneme", "time,phoneme", ":2:1: error: this line has 1 cell; expected 2 as in the first line"},
       {"time;phoneme", "zeit;phoneme",
        ":1:1: error: the first line has other names; expected from,to,phoneme or start,end,phoneme or "
        "time,phoneme"},
       {"0.20;", "0.10;",
        ":3:1: error: this time is not after the one of the line before; expected rising times"},
       {"0.20;", "0.05;",
        ":3:1: error: this time is not after the one of the line before; expected rising times"},
       {"0.20;", "x;", ":3:1: error: 'x' is no time; expected seconds from 0 to 86400"},
       {"0.20;", ";", ":3:1: error: '' is no time; expected seconds from 0 to 86400"},
       {"0.61;\n", "",
        ":5:7: error: nothing says when the last phoneme 'z' ends; expected one more line, with a time and "
        "no phoneme"},
       {"0.61;", "0.61", ":6:1: error: this line has 1 cell; expected 2 as in the first line"},
       {"0.61;", "0.61;;", ":6:1: error: this line has 3 cells; expected 2 as in the first line"},
       {"\"tʃ\"", "\"tʃ", ":2:6: error: unknown phoneme '\"tʃ'; expected one in IPA, such as a, tʃ or iː"},
       {"iː", "I:", ":3:6: error: unknown phoneme 'I:'; expected one in IPA, such as a, tʃ or iː"},
       {"0.50;z", "5e5;z", ":5:1: error: '5e5' is no time; expected seconds from 0 to 86400"}});
}

}  // namespace
}  // namespace mien

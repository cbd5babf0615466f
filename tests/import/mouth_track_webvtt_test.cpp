// Captions with words, WebVTT.
#include "import/mouth_samples.hpp"

namespace mien {
namespace {

TEST(webvtt, is_read) {
  const MouthTrack track = load_mouth_sample("words.vtt");
  EXPECT_EQ(track.names, MouthNames::words);
  EXPECT_EQ(describe_mouth_cues(track.cues),
            "1 1.5 Well :11\n"
            "1.5 2 hello :11\n"
            "2 2.5 there :11\n"
            "3 3.4 It's :14\n"
            "3.4 3.8 Tom :14\n"
            "3.8 4.2 I :14\n");
  EXPECT_EQ(describe_mouth_cues(track.words), "");
  EXPECT_NEAR(track.end_s, 6, 1e-12);
}

// As YouTube writes live captions: each line once more above the next one, and alone between them.
TEST(webvtt, lines_that_roll_up_are_said_once) {
  const MouthTrack track = load_mouth_bytes(
      "roll.vtt",
      "WEBVTT\n\n00:00.000 --> 00:02.000 align:start\n \nso<00:00.500><c> today</c>\n\n"
      "00:02.000 --> 00:02.010\nso today\n \n\n00:02.010 --> 00:04.010\nso today\nwe<00:03.010><c> go</c>\n");
  EXPECT_EQ(describe_mouth_cues(track.cues),
            "0 0.5 so :5\n0.5 2 today :5\n2.01 3.01 we :13\n3.01 4.01 go :13\n");
  EXPECT_EQ(load_mouth_bytes("twice.vtt",
                             "WEBVTT\n\n00:00.000 --> 00:01.000\nNo!\n\n00:01.000 --> 00:02.000\nNo!\n")
                .cues.size(),
            2u)
      << "what is said twice";
}

TEST(webvtt, a_cue_needs_no_empty_line_before_the_next_times) {
  EXPECT_EQ(describe_mouth_cues(load_mouth_bytes("near.vtt",
                                                 "WEBVTT\n\n00:00.000 --> 00:01.000\na\n00:01.000 --> "
                                                 "00:02.000\n&lt;b&gt; c&nbsp;\n\n \n\nREGION\nid:x\n")
                                    .cues),
            "0 1 a :4\n1 1.5 b :6\n1.5 2 c :6\n");
}

TEST(webvtt, tells_what_is_wrong_and_where) {
  expect_mouth_faults(
      "words.vtt",
      {{"WEBVTT", "WEBVTTT", ":1:1: error: 'WEBVTTT - two people'; expected WEBVTT"},
       {"Kind: captions\n", "00:00.000 --> 00:01.000\n",
        ":2:1: error: a cue follows the head at once; expected an empty line above it"},
       {"--> 00:02.500", "--> 00:00.500",
        ":10:15: error: this cue lasts from 1 s to 0.5 s; expected an end after its beginning"},
       {"--> 00:02.500 align:start position:0%", "-->",
        ":10:11: error: a cue without an end; expected a time behind -->"},
       {"00:01.000", "1.000",
        ":10:1: error: '1.000' is no time; expected one such as 00:01.500 or 01:02:03.500"},
       {"00:01.000", "00:61.000",
        ":10:1: error: '00:61.000' is no time; expected one such as 00:01.500 or 01:02:03.500"},
       {"00:01.000", "00:0a.000",
        ":10:1: error: '00:0a.000' is no time; expected one such as 00:01.500 or 01:02:03.500"},
       {"1\n00:01.000 --> 00:02.500 align:start position:0%\n", "1\n",
        ":9:1: error: '1' is no cue; expected a line such as 00:01.000 --> 00:02.500"},
       {"00:00:03.000 -->", "00:00:02.000 -->",
        ":13:1: error: this begins at 2 s, and what is before it ends at 2.5 s; expected rising times"},
       {"<00:00:03.400>", "<00:00:04.400>",
        ":14:6: error: the time 4.4 s; expected one from 3 s, where the words before it begin, to 4.2 s, "
        "where the cue ends"},
       {"<00:00:03.800>", "<00:00:03.200>",
        ":14:31: error: the time 3.2 s; expected one from 3.4 s, where the words before it begin, to 4.2 s, "
        "where the cue ends"},
       {"<00:00:03.800>", "<00:00:03.800",
        ":14:31: error: '00:00:03.800<c' is no time; expected one such as 00:01.500 or 01:02:03.500"},
       {"<00:00:03.800>", "<00:00:03.400>",
        ":14:23: error: no time is left for this word; expected rising times"},
       {"<00:00:03.800>", "<0x>",
        ":14:31: error: '0x' is no time; expected one such as 00:01.500 or 01:02:03.500"},
       {"00:06.000", "25:00:06.000", ":16:15: error: 90006 is no time; expected seconds from 0 to 86400"},
       {"!”</v>", "!”</v",
        ":11:29: error: nothing closes this tag; expected '>', or &lt; for the sign itself"}});
}

}  // namespace
}  // namespace mien

// Moho's switch data and Papagayo's files.
#include <cmath>

#include "import/mouth_samples.hpp"

namespace mien {
namespace {

TEST(moho, switch_data_is_read) {
  const MouthTrack track = load_mouth_sample("hi.dat");
  EXPECT_EQ(track.names, MouthNames::preston_blair);
  EXPECT_EQ(describe_mouth_cues(track.cues),
            "0 0.0833333 rest :2\n"
            "0.0833333 0.25 AI :3\n"
            "0.25 0.333333 E :4\n"
            "0.333333 0.5 MBP :5\n"
            "0.5 0.541667 rest :6\n");
  EXPECT_EQ(describe_mouth_cues(track.words), "");
  EXPECT_NEAR(track.end_s, 13 / 24.0, 1e-12);
}

TEST(moho, switch_data_of_letters_is_read) {
  const MouthTrack track = load_mouth_sample("letters.dat");
  EXPECT_EQ(track.names, MouthNames::rhubarb);
  EXPECT_EQ(describe_mouth_cues(track.cues),
            "0 0.0416667 X :2\n"
            "0.0416667 0.291667 D :3\n"
            "0.291667 0.458333 E :4\n"
            "0.458333 0.5 X :5\n");
  EXPECT_EQ(describe_mouth_cues(track.words), "");
  EXPECT_NEAR(track.end_s, 12 / 24.0, 1e-12);
}

// Papagayo ends a rest of one frame twice, and others begin with the frame of the set-up.
TEST(moho, of_two_mouths_in_a_frame_the_later_counts) {
  const MouthTrack track =
      load_mouth_bytes("twice.dat", "MohoSwitch1\n0 rest\n1 AI\n5 rest\n5 rest\n6 E\n", 10);
  EXPECT_EQ(describe_mouth_cues(track.cues), "0 0.4 AI :3\n0.4 0.5 rest :5\n0.5 0.6 E :6\n");
}

TEST(moho, the_rate_is_the_files_own_or_asked_for) {
  const std::string head = "MohoSwitch1\n", keys = "1 rest\n11 E\n";
  EXPECT_EQ(load_mouth_bytes("rate.dat", head + "FPS 10\n" + keys, 0).end_s, 1.1);
  EXPECT_EQ(load_mouth_bytes("rate.dat", head + "FPS 10\n" + keys, 24).end_s, 1.1);
  EXPECT_EQ(load_mouth_bytes("rate.dat", head + keys, 5).end_s, 2.2);
  for (const double fps : {0.0, -1.0, double(NAN), double(INFINITY)})
    EXPECT_EQ(find_mouth_fault("rate.dat", head + keys, fps),
              "rate.dat:1:1: error: the file does not say how many frames a second it counts; expected them "
              "as fps");
}

TEST(moho, switch_data_tells_what_is_wrong_and_where) {
  expect_mouth_faults(
      "hi.dat",
      {{"MohoSwitch1", "MohoSwitch2", ":1:1: error: 'MohoSwitch2'; expected MohoSwitch1"},
       {"3 AI", "3 A I", ":3:1: error: a line of 3 words; expected a frame and a mouth, such as 12 MBP"},
       {"3 AI", "3", ":3:1: error: a line of 1 word; expected a frame and a mouth, such as 12 MBP"},
       {"3 AI", "3 AH", ":3:3: error: unknown mouth 'AH'; expected AI, E, O, U, etc, L, WQ, MBP, FV or rest"},
       {"3 AI", "-3 AI", ":3:1: error: '-3' is no frame; expected a whole number from 0 to 86400000"},
       {"3 AI", "3.5 AI", ":3:1: error: '3.5' is no frame; expected a whole number from 0 to 86400000"},
       {"7 E", "2 E", ":4:1: error: this frame is before the one of the line before; expected rising frames"},
       {"7 E", "x E", ":4:1: error: 'x' is no frame; expected a whole number from 0 to 86400000"},
       {"1 rest\n3 AI\n7 E\n9 MBP\n13 rest\n", "",
        ":1:12: error: the file ends here; expected lines such as 12 MBP"},
       {"9 MBP", "9 mbp",
        ":5:3: error: unknown mouth 'mbp'; expected AI, E, O, U, etc, L, WQ, MBP, FV or rest"},
       {"13 rest", "3000000 rest",
        ":6:1: error: at 24 frames a second this comes at 125000 s; expected 86400 s at most"},
       {"1 rest", "FPS 0", ":2:5: error: '0' is no number of frames a second; expected one from 1 to 1000"},
       {"1 rest", "FPS x", ":2:5: error: 'x' is no number of frames a second; expected one from 1 to 1000"},
       {"7 E", "FPS 24", ":4:1: error: 'FPS' is no frame; expected a whole number from 0 to 86400000"}});
}

TEST(moho, switch_data_of_letters_tells_what_is_wrong_and_where) {
  expect_mouth_faults(
      "letters.dat",
      {{"2 D", "2 d", ":3:3: error: unknown mouth 'd'; expected A, B, C, D, E, F, G, H or X"},
       {"2 D", "2 AI", ":3:3: error: unknown mouth 'AI'; expected A, B, C, D, E, F, G, H or X"},
       {"8 E", "1 E", ":4:1: error: this frame is before the one of the line before; expected rising frames"},
       {"8 E", "8 ", ":4:1: error: a line of 1 word; expected a frame and a mouth, such as 12 MBP"},
       {"8 E", "eight E", ":4:1: error: 'eight' is no frame; expected a whole number from 0 to 86400000"},
       {"8 E", "8 E X", ":4:1: error: a line of 3 words; expected a frame and a mouth, such as 12 MBP"},
       {"12 X", "12 x", ":5:4: error: unknown mouth 'x'; expected A, B, C, D, E, F, G, H or X"},
       {"12 X", "12 rest", ":5:4: error: unknown mouth 'rest'; expected A, B, C, D, E, F, G, H or X"},
       {"MohoSwitch1\n", "", ":1:1: error: '1 X'; expected MohoSwitch1"},
       {"1 X\n", "1 Q\n", ":2:3: error: unknown mouth 'Q'; expected A, B, C, D, E, F, G, H or X"},
       {"12 X", "123456789012 X",
        ":5:1: error: '123456789012' is no frame; expected a whole number from 0 to 86400000"}});
}

TEST(papagayo, is_read) {
  const MouthTrack track = load_mouth_sample("hi.pgo", 0);
  EXPECT_EQ(track.names, MouthNames::preston_blair);
  EXPECT_EQ(describe_mouth_cues(track.cues),
            "0.166667 0.25 etc :14\n"
            "0.25 0.5 AI :15\n"
            "0.583333 0.75 etc :17\n"
            "0.75 1 E :18\n"
            "1 1.25 etc :19\n");
  EXPECT_EQ(describe_mouth_cues(track.words),
            "0.166667 0.5 Hi :13\n"
            "0.583333 1.25 there :16\n");
  EXPECT_NEAR(track.end_s, 2.5, 1e-12);
}

TEST(papagayo, words_that_share_a_frame_do_not_overlap) {
  const MouthTrack track = load_mouth_bytes(
      "share.pgo", break_sample("hi.pgo", "there! 14 29 3\n\t\t\t\t14", "there! 11 29 3\n\t\t\t\t11"));
  EXPECT_EQ(describe_mouth_cues(track.words), "0.166667 0.5 Hi :13\n0.5 1.25 there :16\n");
  EXPECT_EQ(describe_mouth_cues({track.cues[1], track.cues[2]}), "0.25 0.5 AI :15\n0.5 0.75 etc :17\n");
  EXPECT_EQ(find_mouth_fault("share.pgo",
                             break_sample("hi.pgo", "there! 14 29 3\n\t\t\t\t14", "there! 5 9 1\n\t\t\t\t6")),
            "share.pgo:16:11: error: this word is before the one before it; expected rising frames");
}

TEST(papagayo, other_sets_of_phonemes_are_known) {
  const std::string head = "lipsync version 1\n\n10\n20\n1\n\n\n1\n\n0\n9\n1\n";
  EXPECT_EQ(load_mouth_bytes("cmu.pgo", head + "a 0 9 2\n0 AH0\n5 NG\n").names, MouthNames::arpabet);
  EXPECT_EQ(describe_mouth_cues(load_mouth_bytes("cmu.pgo", head + "a 0 9 2\n0 AH0\n5 rest\n").cues),
            "0 0.5 AH0 :14\n")
      << "no cue is a rest";
  EXPECT_EQ(load_mouth_bytes("letters.pgo", head + "a 0 9 2\n0 A\n5 X\n").names, MouthNames::rhubarb);
  EXPECT_EQ(load_mouth_bytes("both.pgo", head + "a 0 9 1\n0 E\n").names, MouthNames::preston_blair);
}

TEST(papagayo, a_second_voice_is_told) {
  const std::string voice = "\tAnn\n\t\n\t1\n\t\tA\n\t\t0\n\t\t9\n\t\t1\n\t\t\tA 0 9 1\n\t\t\t\t0 AI\n";
  EXPECT_EQ(find_mouth_fault("two.pgo", "lipsync version 1\n\n10\n20\n2\n" + voice + voice),
            "two.pgo:15:2: error: a second voice, 'Ann'; expected one, and a file for each");
  EXPECT_EQ(find_mouth_fault("two.pgo", "lipsync version 1\n\n10\n20\n2\n" + voice + "\tBob\n\t\n\t0\n"), "")
      << "he says nothing";
}

TEST(papagayo, tells_what_is_wrong_and_where) {
  expect_mouth_faults(
      "hi.pgo",
      {{"version 1", "version 2", ":1:1: error: 'lipsync version 2'; expected lipsync version 1"},
       {"\n24\n", "\nfast\n",
        ":3:1: error: 'fast' is no number of frames a second; expected one from 1 to 1000"},
       {"\n24\n", "\n0\n", ":3:1: error: '0' is no number of frames a second; expected one from 1 to 1000"},
       {"\n60\n", "\n-60\n", ":4:1: error: '-60' is no frame; expected a whole number from 0 to 86400000"},
       {"\n1\n\tVoice", "\n1.5\n\tVoice",
        ":5:1: error: '1.5' is no number of voices; expected one from 0 to 100"},
       {"\n1\n\tVoice", "\n2\n\tVoice", ":19:11: error: the file ends here; expected the name of a voice"},
       {"\t29\n", "\t3\n",
        ":11:3: error: this ends with frame 3 and begins with 4; expected an end after its beginning"},
       {"Hi, 4 11 2", "Hi, 4 11",
        ":13:4: error: this is no word; expected it, its first and last frame, and how many phonemes it has, "
        "such as hello 10 20 4"},
       {"Hi, 4 11 2", "Hi, 4 11 3",
        ":16:4: error: this is no phoneme; expected a frame and a name, such as 12 MBP"},
       {"Hi, 4 11 2", "Hi, 4 11 1",
        ":15:5: error: this is no word; expected it, its first and last frame, and how many phonemes it has, "
        "such as hello 10 20 4"},
       {"Hi, 4 11 2", "Hi, 11 4 2",
        ":13:11: error: this ends with frame 4 and begins with 11; expected an end after its beginning"},
       {"6 AI", "3 AI", ":15:5: error: this phoneme has the frame 3; expected one of its word's, 4 to 11"},
       {"6 AI", "12 AI", ":15:5: error: this phoneme has the frame 12; expected one of its word's, 4 to 11"},
       {"6 AI", "6 AH9",
        ":15:7: error: unknown mouth 'AH9'; expected AI, E, O, U, etc, L, WQ, MBP, FV or rest"},
       {"18 E", "30 E", ":18:5: error: this phoneme has the frame 30; expected one of its word's, 14 to 29"},
       {"18 E", "12 E", ":18:5: error: this phoneme has the frame 12; expected one of its word's, 14 to 29"},
       {"24 etc", "17 etc",
        ":19:5: error: this phoneme is before the one of the line before; expected rising frames"},
       {"there! 14", "there! x",
        ":16:11: error: 'x' is no frame; expected a whole number from 0 to 86400000"},
       {"24 etc\n", "24 etc\nmore\n",
        ":20:1: error: something stands behind the last voice; expected the end of the file"},
       {"14 29 3", "14 29 4", ":19:11: error: the file ends here; expected a phoneme, such as 12 MBP"},
       {"Hi, 4 11 2", "Hi, 4 3000000 2",
        ":13:10: error: at 24 frames a second this comes at 125000 s; expected 86400 s at most"},
       {"\t4 etc\n\t\t\t\t6 AI\n", "\t4 etc",
        ":14:5: error: this is no phoneme; expected a frame and a name, such as 12 MBP"}});
}

}  // namespace
}  // namespace mien

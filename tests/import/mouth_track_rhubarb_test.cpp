// Rhubarb Lip Sync's TSV, XML and JSON.
#include "import/mouth_samples.hpp"

namespace mien {
namespace {

TEST(rhubarb, tsv_is_read) {
  const MouthTrack track = load_mouth_sample("hi.tsv");
  EXPECT_EQ(track.names, MouthNames::rhubarb);
  EXPECT_EQ(describe_mouth_cues(track.cues),
            "0 0.05 X :1\n"
            "0.05 0.27 D :2\n"
            "0.27 0.31 C :3\n"
            "0.31 0.43 B :4\n"
            "0.43 0.47 X :5\n");
  EXPECT_EQ(describe_mouth_cues(track.words), "");
  EXPECT_NEAR(track.end_s, 0.47, 1e-12);
}

TEST(rhubarb, xml_is_read) {
  const MouthTrack track = load_mouth_sample("hi.xml");
  EXPECT_EQ(track.names, MouthNames::rhubarb);
  EXPECT_EQ(describe_mouth_cues(track.cues),
            "0 0.05 X :9\n"
            "0.05 0.27 D :10\n"
            "0.27 0.47 H :11\n");
  EXPECT_EQ(describe_mouth_cues(track.words), "");
  EXPECT_NEAR(track.end_s, 0.5, 1e-12);
}

TEST(rhubarb, json_is_read) {
  const MouthTrack track = load_mouth_sample("hi.json");
  EXPECT_EQ(track.names, MouthNames::rhubarb);
  EXPECT_EQ(describe_mouth_cues(track.cues),
            "0 0.05 X :7\n"
            "0.05 0.27 D :8\n"
            "0.27 0.47 H :9\n");
  EXPECT_EQ(describe_mouth_cues(track.words), "");
  EXPECT_NEAR(track.end_s, 0.5, 1e-12);
}

// Numbers of JSON may be written in many ways, keys stand in any order, and others may be among them.
TEST(rhubarb, json_is_read_however_it_is_written) {
  const MouthTrack track = load_mouth_bytes(
      "any.json",
      "{\"mouthCues\":[{\"value\":\"\\u0041\",\"end\":1,\"start\":0,\"more\":[{\"start\":\"x\"},null,true]},"
      "{\"start\":10e-1,\"end\":2.5E0,\"value\":\"X\"}],\"more\":{\"mouthCues\":3}}");
  EXPECT_EQ(describe_mouth_cues(track.cues), "0 1 A :1\n1 2.5 X :1\n");
  EXPECT_EQ(track.end_s, 2.5);
}

TEST(rhubarb, a_line_shows_where_its_mistake_is) {
  const auto file = write_mouth_file("hi.xml", break_sample("hi.xml", ">D<", ">d<"));
  try {
    load_mouth_track(file, 0);
    ADD_FAILURE();
  } catch (const InputError& e) {
    EXPECT_EQ(std::string(e.what()),
              file.string() +
                  ":10:39: error: unknown mouth 'd'; expected A, B, C, D, E, F, G, H or X\n"
                  "      <mouthCue start=\"0.05\" end=\"0.27\">d</mouthCue>\n"
                  "                                        ^");
  }
}

TEST(rhubarb, tsv_tells_what_is_wrong_and_where) {
  expect_mouth_faults(
      "hi.tsv",
      {{"0.05\tD", "0.05\tQ", ":2:6: error: unknown mouth 'Q'; expected A, B, C, D, E, F, G, H or X"},
       {"0.05\tD", "0.05 D now", ":2:1: error: a line of 3 words; expected seconds, a tab and a shape"},
       {"0.05\tD", "0.05", ":2:1: error: a line of 1 word; expected seconds, a tab and a shape"},
       {"0.27\tC", "x\tC", ":3:1: error: 'x' is no time; expected seconds from 0 to 86400"},
       {"0.27\tC", "-0.27\tC", ":3:1: error: '-0.27' is no time; expected seconds from 0 to 86400"},
       {"0.27\tC", "0.05\tC",
        ":3:1: error: this time is not after 0.05 s, of the line before; expected rising times"},
       {"0.31\tB", "0.02\tB",
        ":4:1: error: this time is not after 0.27 s, of the line before; expected rising times"},
       {"0.31\tB", "1e9\tB", ":4:1: error: '1e9' is no time; expected seconds from 0 to 86400"},
       {"0.31\tB", "nan\tB", ":4:1: error: 'nan' is no time; expected seconds from 0 to 86400"},
       {"0.47\tX\n", "0.47\tD\n",
        ":6:7: error: the last line has the open mouth 'D'; expected the time of the end, and X or A"},
       {"0.27\tC", "0,27\tC", ":3:1: error: '0,27' is no time; expected seconds from 0 to 86400"},
       {"0.05\tD", "0.05\té", ":2:6: error: unknown mouth 'é'; expected A, B, C, D, E, F, G, H or X"}});
}

TEST(rhubarb, xml_tells_what_is_wrong_and_where) {
  expect_mouth_faults(
      "hi.xml",
      {{">D<", ">d<", ":10:39: error: unknown mouth 'd'; expected A, B, C, D, E, F, G, H or X"},
       {"start=\"0.05\"", "start=\"x\"", ":10:22: error: 'x' is no time; expected seconds from 0 to 86400"},
       {" end=\"0.27\"", "",
        ":10:6: error: a cue without 'end'; expected <mouthCue start=\"0.1\" end=\"0.2\">A</mouthCue>"},
       {"start=\"0.05\"", "start=\"0.04\"",
        ":10:6: error: this begins at 0.04 s, and what is before it ends at 0.05 s; expected rising times"},
       {"start=\"0.05\" end=\"0.27\"", "start=\"0.05\" end=\"0.05\"",
        ":10:6: error: this lasts from 0.05 s to 0.05 s; expected an end after its beginning"},
       {"</mouthCues>", "</mouthCue>",
        ":12:5: error: 'mouthCue' is closed here, and 'mouthCues' is open; expected </mouthCues>"},
       {"</mouthCues>\n</rhubarbResult>\n", "",
        ":11:51: error: the file ends here, within 'mouthCues'; expected </mouthCues>"},
       {"rhubarbResult", "result", ":2:2: error: an element 'result'; expected rhubarbResult"},
       {"end=\"0.05\"", "end=0.05", ":9:32: error: a value without quotes; expected \"..\""},
       {"end=\"0.05\"", "end=\"0.05", ":9:32: error: nothing closes this quote; expected one more"},
       {"-->", "- ->", ":7:3: error: nothing closes this; expected '-->' behind it"},
       {"<mouthCues>", "<cues>",
        ":12:5: error: 'mouthCues' is closed here, and 'cues' is open; expected </cues>"},
       {"<duration>0.50", "<duration>long",
        ":5:15: error: 'long' is no time; expected seconds from 0 to 86400"},
       {"<mouthCue start=\"0.05\" end=\"0.27\">D</mouthCue>", "<mouthCue start=\"0.05\" end=\"0.27\"/>",
        ":10:6: error: unknown mouth ''; expected A, B, C, D, E, F, G, H or X"},
       {"</rhubarbResult>\n", "</rhubarbResult>\nmore", ":14:1: error: 'more'; expected the end of the file"},
       {"</rhubarbResult>\n", "</rhubarbResult>\n</a>",
        ":14:3: error: 'a' is closed here, and nothing is open; expected the end of the file"},
       {"<mouthCue start=\"0.05\" end=\"0.27\">D", "<mouthCue start=\"0.05\" end>D",
        ":10:31: error: an attribute has no value; expected =\"..\""},
       {"<?xml version=\"1.0\" encoding=\"utf-8\"?>", "<>",
        ":1:2: error: no name stands here; expected XML as Rhubarb writes it"}});
}

TEST(rhubarb, json_tells_what_is_wrong_and_where) {
  expect_mouth_faults(
      "hi.json",
      {{"\"D\"", "\"d\"", ":8:45: error: unknown mouth 'd'; expected A, B, C, D, E, F, G, H or X"},
       {"\"D\"", "4", ":8:44: error: 'value' is no text; expected the letter of a shape"},
       {"0.05, \"end\": 0.27", "\"0.05\", \"end\": 0.27",
        ":8:16: error: 'start' is no number; expected seconds"},
       {"\"end\": 0.27, ", "", ":8:5: error: a cue without 'end'; expected start, end and value"},
       {"\"start\": 0.05, \"end\"", "\"start\": 0.04, \"end\"",
        ":8:5: error: this begins at 0.04 s, and what is before it ends at 0.05 s; expected rising times"},
       {"\"end\": 0.27", "\"end\": 0.05",
        ":8:5: error: this lasts from 0.05 s to 0.05 s; expected an end after its beginning"},
       {"\"end\": 0.27", "\"end\": -1", ":8:29: error: -1 is no time; expected seconds from 0 to 86400"},
       {"\"end\": 0.27", "\"end\": 1e999", ":8:29: error: a number that is too large; expected seconds"},
       {"\"end\": 0.27", "\"end\": 0.27.1",
        ":8:33: error: '.' cannot stand here; expected JSON as Rhubarb writes it"},
       {"\n  ]\n}\n", "", ":9:49: error: the file ends within its JSON; expected the rest"},
       {"\"mouthCues\"", "\"cues\"",
        ":1:1: error: the object has no mouthCues; expected what Rhubarb writes"},
       {"\"mouthCues\": [", "\"mouthCues\": 3, \"a\": [",
        ":6:16: error: 'mouthCues' is no list; expected one of cues"},
       {"{ \"start\": 0.05, \"end\": 0.27, \"value\": \"D\" }", "\"D\"",
        ":8:5: error: a cue is no object; expected {\"start\": 0.1, \"end\": 0.2, \"value\": \"A\"}"},
       {"\"D\" },", "\"D\" }", ":9:5: error: '{' cannot stand here; expected JSON as Rhubarb writes it"},
       {"\"value\": \"D\"", "\"value\": null",
        ":8:44: error: 'value' is no text; expected the letter of a shape"},
       {"0.50", "true", ":4:17: error: 'duration' is no number; expected seconds"},
       {"\"end\": 0.27", "\"end\": [0.27]", ":8:29: error: 'end' is no number; expected seconds"},
       {"\"D\"", "\"\\\"\\\\\"", ":8:45: error: unknown mouth '\"\\'; expected A, B, C, D, E, F, G, H or X"},
       {"}\n", "} 1", ":9:50: error: '1' cannot stand here; expected JSON as Rhubarb writes it"}});
}

TEST(rhubarb, deep_files_are_no_danger) {
  EXPECT_EQ(find_mouth_fault("deep.json", "{\"a\":" + std::string(100000, '[')),
            "deep.json:1:69: error: more than 64 lists and objects within each other; expected fewer");
  std::string xml = "<rhubarbResult>";
  for (int i = 0; i < 100000; ++i) xml += "<a>";
  EXPECT_EQ(find_mouth_fault("deep.xml", xml),
            "deep.xml:1:62: error: more than 16 elements within each other; expected fewer");
  EXPECT_EQ(find_mouth_fault("empty.xml", "<rhubarbResult><mouthCues/></rhubarbResult>"),
            "empty.xml: error: has no cues; expected one at least");
  EXPECT_EQ(find_mouth_fault("none.xml", "<rhubarbResult/>"),
            "none.xml:1:17: error: the file ends here without mouthCues; expected what Rhubarb writes");
  EXPECT_EQ(find_mouth_fault("two.xml", "<rhubarbResult><mouthCues/></rhubarbResult><rhubarbResult/>"),
            "two.xml:1:45: error: an element 'rhubarbResult'; expected the end of the file");
  EXPECT_EQ(find_mouth_fault("empty.json", "{\"mouthCues\": []}"),
            "empty.json: error: has no cues; expected one at least");
}

}  // namespace
}  // namespace mien

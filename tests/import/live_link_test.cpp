// Takes of Live Link Face.
#include <fmt/format.h>

#include "import/take_samples.hpp"

namespace mien {
namespace {

// A take of these rows of timecode, jawOpen and the head's yaw.
Take load_rows(const std::string& rows, double fps = 0) {
  return load_take(
      write_take_file("rows.csv", "Timecode,BlendShapeCount,JawOpen,HeadYaw,HeadPitch,HeadRoll\n" + rows),
      TakeKind::live_link, fps);
}

TEST(live_link, a_take_is_read_by_its_names) {
  const Take take = load_take(find_take_sample("live_link.csv"), TakeKind::live_link);
  EXPECT_EQ(take.mapping, "arkit");
  EXPECT_EQ(take.channels.size(), 52u);
  EXPECT_EQ(take.channels.front().name, "eyeBlinkLeft");
  EXPECT_EQ(take.channels.front().line, 1);
  EXPECT_EQ(take.channels.front().column, 26);
  EXPECT_EQ(take.row_count, 24);
  ASSERT_EQ(take.at_s.size(), 24u);
  EXPECT_EQ(take.start, "14:21:33:48.518");
  EXPECT_NEAR(find_take_value(take, 23, "mouthSmileLeft"), 0.9, 1e-6);
  EXPECT_NEAR(find_take_value(take, 23, "jawOpen"), 0.3, 1e-6);
  EXPECT_EQ(guess_take_kind(find_take_sample("live_link.csv")), TakeGuess::live_link);
}

TEST(live_link, time_is_the_timecodes) {
  const Take take = load_take(find_take_sample("live_link.csv"), TakeKind::live_link);
  for (std::size_t i = 0; i < take.at_s.size(); ++i)
    EXPECT_NEAR(take.at_s[i], static_cast<double>(i) / 60, 1e-9) << i;
  EXPECT_NEAR(take.end_s, 23.0 / 60, 1e-9);
}

TEST(live_link, frames_of_59_94_a_second_are_longer) {
  const Take take = load_rows("00:00:00:00.0,61,0,0,0,0\n00:10:00:00.0,61,1,0,0,0\n", 59.94);
  EXPECT_NEAR(take.at_s[1], 600 * 60 / 59.94, 1e-9);
  EXPECT_NEAR(load_rows("00:00:00:00.0,61,0,0,0,0\n00:10:00:00.0,61,1,0,0,0\n", 60).at_s[1], 600, 1e-9);
}

TEST(live_link, the_rate_is_what_frames_count_up_to) {
  const Take take =
      load_rows("00:00:00:23.0,61,0,0,0,0\n00:00:00:29.0,61,0,0,0,0\n00:00:01:00.0,61,1,0,0,0\n");
  EXPECT_NEAR(take.at_s[2], 7.0 / 30, 1e-9);
  // Within a second nobody sees how many there are: a phone's.
  EXPECT_NEAR(load_rows("00:00:00:10.0,61,0,0,0,0\n00:00:00:16.0,61,0,0,0,0\n").at_s[1], 0.1, 1e-9);
}

TEST(live_link, a_take_goes_on_past_midnight) {
  const Take take = load_rows("23:59:59:59.0,61,0,0,0,0\n00:00:00:00.0,61,1,0,0,0\n");
  EXPECT_NEAR(take.at_s[1], 1.0 / 60, 1e-9);
}

TEST(live_link, radians_and_degrees_are_told_apart) {
  const Take radians = load_rows("00:00:00:00.0,61,0,0.5,-0.1,0.2\n00:00:00:01.0,61,0,0,0,0\n");
  EXPECT_NEAR(radians.turn_deg[0][0], 28.648, 1e-3);  // to the character's left
  EXPECT_NEAR(radians.turn_deg[0][1], -5.730, 1e-3);
  EXPECT_NEAR(radians.turn_deg[0][2], 11.459, 1e-3);
  const Take degrees = load_rows("00:00:00:00.0,61,0,25,-10,2\n00:00:00:01.0,61,0,0,0,0\n");
  EXPECT_NEAR(degrees.turn_deg[0][0], 25, 1e-5);
}

TEST(live_link, rows_without_a_face_and_repeated_ones_are_counted) {
  const Take take = load_rows(
      "00:00:00:00.0,61,0.5,0,0,0\n00:00:00:01.0,0,,,,\n00:00:00:02.0,0\n00:00:00:03.0,61,0.7,0,0,0\n"
      "00:00:00:03.0,61,0.7,0,0,0\n");
  EXPECT_EQ(take.row_count, 5);
  EXPECT_EQ(take.unseen_count, 2);
  EXPECT_EQ(take.repeated_count, 1);
  ASSERT_EQ(take.at_s.size(), 2u);
  EXPECT_NEAR(take.at_s[1], 0.05, 1e-9);
}

TEST(live_link, what_is_wrong_is_told_at_its_place) {
  const auto fault = [](const std::string& from, const std::string& to) {
    return find_broken_take_fault("live_link.csv", TakeKind::live_link, from, to);
  };
  EXPECT_EQ(
      fault("Timecode", "Time"),
      "live_link.csv:1:1: error: no column is 'Timecode'; expected the first line of Live Link Face's CSV");
  EXPECT_EQ(fault("EyeBlinkRight", "EyeBlinkLeft"),
            "live_link.csv:1:124: error: 'eyeBlinkLeft' is there twice; expected it once");
  EXPECT_EQ(
      fault("14:21:33:50.518", "14:21:33"),
      "live_link.csv:4:1: error: '14:21:33' is no timecode; expected hours:minutes:seconds:frames such as "
      "14:21:07:33.518");
  EXPECT_EQ(fault("14:21:33:50.518", "14:61:33:50.518"),
            "live_link.csv:4:1: error: '14:61:33:50.518' is no timecode; expected "
            "hours:minutes:seconds:frames such "
            "as 14:21:07:33.518");
  EXPECT_EQ(fault("14:21:33:50.518", "14:20:33:50.518"),
            "live_link.csv:4:1: error: this time is before the one of the row before; expected rising times");
  EXPECT_EQ(fault("14:21:33:50.518,61,0.00000", "14:21:33:50.518,61,x"),
            "live_link.csv:4:20: error: 'EyeBlinkLeft' is 'x'; expected a number from -10 to 10");
  EXPECT_EQ(fault("14:21:33:50.518,61,0.00000", "14:21:33:50.518,61,nan"),
            "live_link.csv:4:20: error: 'EyeBlinkLeft' is 'nan'; expected a number from -10 to 10");
  EXPECT_EQ(fault("14:21:33:50.518,61,0.00000,", "14:21:33:50.518,61,"),
            "live_link.csv:4:1: error: this line has 62 cells; expected 63 as in the first line");
  EXPECT_EQ(find_take_fault("a.csv", "\n\n", TakeKind::live_link),
            "a.csv: error: is empty; expected a take of Live Link Face");
  EXPECT_EQ(find_take_fault("a.csv", "Timecode,JawOpen\n", TakeKind::live_link),
            "a.csv: error: has no row with a face; expected one at least");
}

}  // namespace
}  // namespace mien

// Takes of OpenFace 2.
#include "import/take_samples.hpp"

namespace mien {
namespace {

TEST(openface, a_take_is_read_by_its_names) {
  const Take take = load_take(find_take_sample("openface.csv"), TakeKind::openface);
  EXPECT_EQ(take.mapping, "facs");
  EXPECT_EQ(take.channels.size(), 18u);
  EXPECT_EQ(take.row_count, 10);
  EXPECT_EQ(take.unseen_count, 2);
  ASSERT_EQ(take.at_s.size(), 8u);
  EXPECT_NEAR(take.at_s[4], 0.2, 1e-9);  // the two before were not seen
  EXPECT_NEAR(find_take_value(take, 0, "AU12"), 0.5, 1e-6);
  EXPECT_NEAR(find_take_value(take, 7, "AU1"), 1, 1e-6);
  EXPECT_NEAR(find_take_value(take, 7, "AU28"), 0, 1e-6);
  EXPECT_EQ(guess_take_kind(find_take_sample("openface.csv")), TakeGuess::openface);
}

TEST(openface, a_head_that_turns_to_the_pictures_left_turns_to_its_right) {
  const Take take = load_take(find_take_sample("openface.csv"), TakeKind::openface);
  // Rx 0.1 nods, Ry -0.2 turns to the character's left, Rz 0.05 tilts to its left.
  EXPECT_NEAR(take.turn_deg[0][0], 11.459, 1e-3);
  EXPECT_NEAR(take.turn_deg[0][1], 5.730, 1e-3);
  EXPECT_NEAR(take.turn_deg[0][2], 2.865, 1e-3);
}

TEST(openface, a_gaze_is_told_within_the_head) {
  const Take take = load_take(find_take_sample("openface.csv"), TakeKind::openface);
  EXPECT_NEAR(take.gaze_deg[0][0], 5.730 - 11.459, 1e-3);  // less to the left than the head
  EXPECT_NEAR(take.gaze_deg[0][1], 5.730 - 2.865, 1e-3);   // down by less than the head
}

TEST(openface, what_is_wrong_is_told_at_its_place) {
  const auto fault = [](const std::string& from, const std::string& to) {
    return find_broken_take_fault("openface.csv", TakeKind::openface, from, to);
  };
  EXPECT_EQ(fault("2, 0, 0.033", "2, 1, 0.033"),
            "openface.csv:3:4: error: face 1 after face 0; expected the rows of one face");
  EXPECT_EQ(fault("3, 0, 0.067", "3, 0, 0.017"),
            "openface.csv:4:7: error: this time is before the one of the row before; expected rising times");
  EXPECT_EQ(fault("3, 0, 0.067", "3, 0, -1"),
            "openface.csv:4:7: error: 'timestamp' is '-1'; expected a number from 0 to 86400");
  EXPECT_EQ(fault("2.50", "7.5"),
            "openface.csv:2:138: error: 'AU12_r' is '7.5'; expected a number from 0 to 5");
  EXPECT_EQ(fault("0.98, 1, 0.100", "1.98, 1, 0.100"),
            "openface.csv:2:14: error: 'confidence' is '1.98'; expected a number from 0 to 1");
  EXPECT_EQ(fault(", 512.0", ""),
            "openface.csv:2:1: error: this line has 49 cells; expected 50 as in the first line");
  EXPECT_EQ(find_take_fault("a.csv", "frame, timestamp\n1, 0\n", TakeKind::openface),
            "a.csv:1:1: error: no column is an action unit; expected some, such as AU12_r");
}

}  // namespace
}  // namespace mien

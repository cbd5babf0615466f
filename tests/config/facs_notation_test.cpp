// Expressions as action units of FACS.
#include "config/facs_notation.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tuple>

#include "config/config_fixture.hpp"
#include "config/mapping_data.hpp"

namespace mien {
namespace {

Pose pose_notation(const std::string& word) {
  std::string fault;
  const auto pose = find_notation_pose(*find_language()->libraries.mappings, word, fault);
  EXPECT_TRUE(pose) << word << ": " << fault;
  return pose.value_or(Pose{});
}

std::string find_notation_fault(const std::string& word) {
  std::string fault;
  EXPECT_FALSE(find_notation_pose(*find_language()->libraries.mappings, word, fault)) << word;
  return fault;
}

TEST(facs, notations_are_told_from_names) {
  for (const char* word : {"AU12", "AU6C+AU12D", "L12C", "R12", "1+2+5B+26", "LAU12E", "4B", "R12A+R14A"})
    EXPECT_TRUE(is_facs_notation(word)) << word;
  for (const char* word :
       {"smile", "12", "AU", "AU123", "AU12F", "AU12+", "+AU12", "AU-1", "AU1 +AU2", "L", "", "Lu12"})
    EXPECT_FALSE(is_facs_notation(word)) << word;
}

TEST(facs, what_emfacs_is_known_by_poses_what_the_library_poses) {
  const ExpressionBook& book = find_language()->libraries;
  const std::pair<const char*, const char*> kKnown[] = {
      {"AU6+AU12", "joy"},
      {"12+6", "joy"},
      {"AU6E+AU12E+AU25E", "joy"},
      {"AU1+AU4+AU15", "sadness"},
      {"1+4+15+17", "sadness"},
      {"AU1+AU2+AU5B+AU26", "surprise"},
      {"1+2+4+5+20+26", "fear"},
      {"AU1+AU2+AU4+AU5+AU7+AU20+AU26", "fear"},
      {"4+5+7+23", "anger"},
      {"AU4+AU5+AU7+AU24", "anger"},
      {"9+15+16", "disgust"},
      {"L12+L14", "contempt_left"},
      {"R12E+R14E", "contempt_right"},
  };
  for (const auto& [notation, name] : kKnown) {
    const auto index = find_expression(book, std::string("emfacs/") + name);
    ASSERT_TRUE(index) << name;
    const Pose pose = pose_notation(notation);
    for (std::size_t i = 0; i < kMoveCount; ++i)
      EXPECT_NEAR(pose.values[i], book.expressions[*index].pose.values[i], 1e-9)
          << notation << " " << name_move(i);
  }
}

// Du, Tao and Martinez, "Compound facial expressions of emotion", PNAS 2014: six, which `emfacs` has, and
// fifteen.
struct KnownFace {
  const char *notation, *expression;
};
constexpr KnownFace kCompounds[] = {{"6+12", "emfacs/joy"},
                                    {"4+15", "emfacs/sadness"},
                                    {"1+4+20+25", "emfacs/fear"},
                                    {"4+7+24", "emfacs/anger"},
                                    {"1+2+25+26", "emfacs/surprise"},
                                    {"9+10+17", "emfacs/disgust"},
                                    {"1+2+12+25", "compound/happily_surprised"},
                                    {"10+12+25", "compound/happily_disgusted"},
                                    {"1+4+15+25", "compound/sadly_fearful"},
                                    {"4+7+15", "compound/sadly_angry"},
                                    {"1+4+25+26", "compound/sadly_surprised"},
                                    {"4+10", "compound/sadly_disgusted"},
                                    {"4+20+25", "compound/fearfully_angry"},
                                    {"1+2+5+20+25", "compound/fearfully_surprised"},
                                    {"1+4+10+20+25", "compound/fearfully_disgusted"},
                                    {"4+25+26", "compound/angrily_surprised"},
                                    {"4+10+17", "compound/angrily_disgusted"},
                                    {"1+2+5+10", "compound/disgustedly_surprised"},
                                    {"4+9+10", "compound/appalled"},
                                    {"4+7+10", "compound/hatred"},
                                    {"1+2+5+25", "compound/awed"}};

TEST(facs, the_21_compound_expressions_pose_what_the_libraries_pose) {
  const ExpressionBook& book = find_language()->libraries;
  std::vector<Pose> poses;
  for (const auto& [notation, name] : kCompounds) {
    const auto index = find_expression(book, name);
    ASSERT_TRUE(index) << name;
    poses.push_back(pose_notation(notation));
    for (std::size_t i = 0; i < kMoveCount; ++i)
      EXPECT_NEAR(poses.back().values[i], book.expressions[*index].pose.values[i], 1e-9)
          << notation << " " << name_move(i);
    for (std::size_t other = 0; other + 1 < poses.size(); ++other)
      EXPECT_NE(poses[other], poses.back()) << kCompounds[other].notation << " and " << notation;
  }
}

// The libraries' are written by hand, unit by unit; the units of takes are measured on scanned people. Both
// are the same face: their poses point the same way, and no move differs by 0.7 of its limit. What both sides
// of a lip do alike is the lip's.
TEST(facs, the_15_of_two_feelings_are_near_the_sum_of_their_units) {
  const ExpressionBook& book = find_language()->libraries;
  const Mapping& facs = book.mappings->mappings.at("facs");
  double least = 1, most = 0;
  for (const auto& [notation, name] : kCompounds) {
    if (!std::string(name).starts_with("compound/")) continue;
    std::vector<double> weights(facs.units.size());
    std::stringstream words(notation);
    for (std::string number; std::getline(words, number, '+');) weights[*find_unit(facs, "AU" + number)] = 1;
    std::array<double, kMoveCount> sum{};
    add_mapped_moves(facs, weights, sum);
    for (const auto& [move, lips, sign] : {std::tuple("lift", "upper", 1.0), {"bare", "lower", -1.0}}) {
      double& left = sum[*find_move("corner", Side::left, move)];
      double& right = sum[*find_move("corner", Side::right, move)];
      const double alike = std::min(left, right);
      sum[*find_move("lips", Side::none, lips)] += sign * alike;
      left -= alike;
      right -= alike;
    }
    const Pose& pose = book.expressions[*find_expression(book, name)].pose;
    double both = 0, mine = 0, its = 0;
    for (std::size_t i = 0; i < kMoveCount; ++i) {
      const double clamped = std::clamp(sum[i], kMoves[i].low, kMoves[i].high);
      both += clamped * pose.values[i];
      mine += pose.values[i] * pose.values[i];
      its += clamped * clamped;
      most = std::max(most, std::abs(clamped - pose.values[i]));
      EXPECT_LT(std::abs(clamped - pose.values[i]), 0.7) << name << " " << name_move(i);
    }
    least = std::min(least, both / std::sqrt(mine * its));
    EXPECT_GT(both / std::sqrt(mine * its), 0.7) << name;
  }
  RecordProperty("least_cosine", std::to_string(least));
  RecordProperty("most_off", std::to_string(most));
}

TEST(facs, an_intensity_is_a_fifth_for_each_letter) {
  const std::size_t corner = *find_move(Area::corner, Side::left, "up");
  const double most = pose_notation("AU12").values[corner];
  EXPECT_GT(most, 0.4);
  EXPECT_NEAR(pose_notation("AU12E").values[corner], most, 1e-9);
  EXPECT_NEAR(pose_notation("AU12A").values[corner], most / 5, 1e-9);
  EXPECT_NEAR(pose_notation("AU12C").values[corner], most * 3 / 5, 1e-9);
}

TEST(facs, what_is_known_weakens_evenly) {
  const Pose strong = pose_notation("AU6+AU12"), weak = pose_notation("AU6C+AU12C");
  for (std::size_t i = 0; i < kMoveCount; ++i)
    EXPECT_NEAR(weak.values[i], 0.6 * strong.values[i], 1e-9) << name_move(i);
}

TEST(facs, a_side_is_the_characters_own) {
  const Pose left = pose_notation("L12C"), right = pose_notation("R12C"), both = pose_notation("AU12C"),
             each = pose_notation("L12C+R12C");
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    if (kMoves[i].side == Side::right) {
      EXPECT_EQ(left.values[i], 0) << name_move(i);
    }
    if (kMoves[i].side == Side::left) {
      EXPECT_EQ(right.values[i], 0) << name_move(i);
    }
    if (kMoves[i].side == Side::left) {
      EXPECT_NEAR(left.values[i], both.values[i], 1e-9) << name_move(i);
    }
    EXPECT_NEAR(each.values[i], both.values[i], 1e-9) << name_move(i);
  }
  EXPECT_GT(left.values[*find_move(Area::corner, Side::left, "up")], 0.2);
}

TEST(facs, what_is_wrong_is_said) {
  EXPECT_TRUE(find_notation_fault("AU99").starts_with("unknown action unit 'AU99'; known: AU1, AU2, AU4"));
  EXPECT_EQ(find_notation_fault("AU12+AU12B"), "action unit 'AU12' is there twice; expected it once");
  EXPECT_EQ(find_notation_fault("AU12+L12B"), "action unit 'AU12' is there twice; expected it once");
}

TEST(facs, a_notation_stands_wherever_an_expression_may) {
  const Spec spec = load_text(R"(mien: 1
expressions:
  mine: {from: AU1+AU2, chin: {down: 0.2}}
clip:
  keys:
    - {at: 0s, express: AU6C+AU12D}
    - {at: 1s, express: {AU6C+AU12D: 0.5, L12C: 0.5}}
    - {at: 2s, express: mine}
  cues: [{from: 0.2s, express: R12C+R14C}]
busts: [{express: AU4B+AU7C+AU23D}]
)");
  EXPECT_EQ(spec.clip.keys[0].label, "AU6C+AU12D");
  EXPECT_GT(spec.clip.keys[0].pose.values[*find_move(Area::corner, Side::right, "up")], 0.3);
  EXPECT_GT(spec.clip.keys[2].pose.values[*find_move(Area::brow, Side::left, "up")], 0.3);
  EXPECT_NEAR(spec.clip.keys[2].pose.values[*find_move(Area::chin, Side::none, "down")], 0.2, 1e-9);
  EXPECT_EQ(spec.busts[0].expression.name, "AU4B_AU7C_AU23D");
  EXPECT_GT(take_expression(spec, "AU27").pose.values[*find_move(Area::chin, Side::none, "down")], 0.5);
  EXPECT_EQ(take_expression(spec, "AU6+AU12").name, "AU6_AU12");
}

TEST(facs, an_unknown_unit_is_told_at_its_place) {
  const std::string fault = find_text_mistakes("mien: 1\nclip:\n  keys: [{at: 0s, express: AU6+AU88}]\n");
  EXPECT_TRUE(fault.starts_with("test.yaml:3:28: error: unknown action unit 'AU88'; known: AU1, AU2"))
      << fault;
}

TEST(facs, a_name_of_the_authors_own_comes_first) {
  const Spec spec = load_text(
      "mien: 1\nexpressions:\n  L12C: {chin: {down: 0.5}}\nclip:\n  keys: [{at: 0s, express: L12C}]\n");
  EXPECT_EQ(spec.clip.keys[0].pose.values[*find_move(Area::chin, Side::none, "down")], 0.5);
}

}  // namespace
}  // namespace mien

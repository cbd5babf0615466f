// The shipped libraries against what they are made from: the thesis's own table of areas (Yen, "Animation of
// Human Faces", Tamkang University, 1990, section 4.2), its mirror variants, and the shapes that lip sync
// needs.
#include <map>
#include <set>

#include "config/config_fixture.hpp"

namespace mien {
namespace {

const std::vector<Expression>& all() {
  static const auto libraries = load_expression_libraries(kData / "configs/expressions");
  return libraries;
}

const Pose& find(const std::string& library, const std::string& name) {
  for (const Expression& expression : all())
    if (expression.library == library && expression.name == name) return expression.pose;
  throw std::runtime_error("no " + library + "/" + name);
}

Pose mirror(const Pose& pose) {
  Pose mirrored = pose;
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    const MoveInfo& info = kMoves[i];
    if (info.side == Side::none) continue;
    const Side other = info.side == Side::left ? Side::right : Side::left;
    const double value = pose.values[*find_move(info.area, other, info.move)];
    mirrored.values[i] = info.move == "side" ? 0 - value : value;
  }
  return mirrored;
}

// "brow.left.up+": the moves of a pose, with their directions.
std::set<std::string> list_moves(const Pose& pose) {
  std::set<std::string> moves;
  for (std::size_t i = 0; i < kMoveCount; ++i) {
    if (pose.values[i] == 0) continue;
    const MoveInfo& info = kMoves[i];
    const char* side = info.side == Side::none ? "" : info.side == Side::left ? ".left" : ".right";
    moves.insert(std::string(info.area) + side + "." + std::string(info.move) +
                 (pose.values[i] > 0 ? "+" : "-"));
  }
  return moves;
}

// "brow.up+" as both sides, "brow.left.up+" and "lips.upper+" as they are.
std::set<std::string> spread(const std::set<std::string>& words) {
  std::set<std::string> moves;
  for (const std::string& word : words) {
    const std::size_t dot = word.find('.');
    const std::string area = word.substr(0, dot), rest = word.substr(dot);
    const bool is_sided = area == "brow" || area == "lid" || area == "corner";
    if (!is_sided || rest.starts_with(".left") || rest.starts_with(".right")) {
      moves.insert(word);
    } else {
      moves.insert(area + ".left" + rest);
      moves.insert(area + ".right" + rest);
    }
  }
  return moves;
}

// Section 4.2: what moves in each expression, and which way; nothing else does.
const std::map<std::string, std::set<std::string>> kThesis{
    {"neutral", {}},
    {"smile", {"lid.upper-", "lips.upper+", "corner.out+", "corner.up+"}},
    {"laugh", {"lid.upper-", "lips.upper+", "lips.lower-", "corner.out+", "corner.up+"}},
    {"anger", {"brow.out-", "brow.turn-", "lips.upper+"}},
    {"surprise", {"brow.up+", "lid.upper+"}},
    {"shout", {"brow.up+", "lid.upper+", "lips.upper+", "lips.lower-", "corner.out-", "chin.down+"}},
    {"fear", {"brow.up+", "lid.upper+", "lips.upper+", "lips.lower-", "chin.down+"}},
    {"sadness", {"brow.out-", "lid.upper-", "corner.out+", "corner.up-"}},
    {"doubt_left",
     {"brow.left.up+", "lid.left.upper+", "lid.right.upper-", "lips.press+", "corner.left.out+"}},
    {"doubt_right",
     {"brow.right.up+", "lid.right.upper+", "lid.left.upper-", "lips.press+", "corner.right.out+"}},
};

TEST(tezuka, moves_exactly_the_areas_of_the_thesis_in_its_directions) {
  std::set<std::string> names, expected;
  for (const Expression& expression : all())
    if (expression.library == "tezuka") names.insert(expression.name);
  for (const auto& [name, moves] : kThesis) {
    expected.insert(name);
    EXPECT_EQ(list_moves(find("tezuka", name)), spread(moves)) << name;
  }
  EXPECT_EQ(names, expected);
}

TEST(tezuka, moves_more_in_a_laugh_than_in_a_smile_and_little_where_the_thesis_says_slightly) {
  const Pose &smile = find("tezuka", "smile"), &laugh = find("tezuka", "laugh"),
             &sad = find("tezuka", "sadness");
  const auto value = [](const Pose& pose, const char* area, const char* move) {
    return find_value(pose, area, std::string(area) == "lips" ? Side::none : Side::left, move);
  };
  EXPECT_LT(value(laugh, "lid", "upper"), value(smile, "lid", "upper"));
  EXPECT_GT(value(laugh, "lips", "upper"), value(smile, "lips", "upper"));
  EXPECT_GT(value(laugh, "corner", "up"), value(smile, "corner", "up"));
  EXPECT_GE(value(sad, "brow", "out"), -0.5);
  EXPECT_LE(value(sad, "corner", "out"), 0.5);
  EXPECT_GE(value(sad, "corner", "up"), -0.5);
}

TEST(tezuka, is_symmetric_but_for_doubt_whose_variants_mirror_each_other_to_the_last_bit) {
  for (const auto& [name, moves] : kThesis) {
    const Pose& pose = find("tezuka", name);
    EXPECT_EQ(pose == mirror(pose), !name.starts_with("doubt")) << name;
  }
  EXPECT_EQ(mirror(find("tezuka", "doubt_left")), find("tezuka", "doubt_right"));
}

TEST(libraries, have_sides_that_mirror_each_other) {
  EXPECT_EQ(mirror(find("extras", "wink_left")), find("extras", "wink_right"));
  EXPECT_EQ(find("extras", "wink"), find("extras", "wink_left"));
  EXPECT_EQ(mirror(find("emfacs", "contempt_left")), find("emfacs", "contempt_right"));
  EXPECT_EQ(find_value(find("extras", "wink_left"), "lid", Side::left, "upper"), -1);
}

TEST(libraries, have_the_marks_by_which_emfacs_tells_emotions) {
  const auto brow = [](const char* name, const char* move) {
    return find_value(find("emfacs", name), "brow", Side::left, move);
  };
  EXPECT_GT(brow("sadness", "turn"), 0.5);  // 1, which the thesis's sadness lacks
  EXPECT_LT(brow("fear", "out"), -0.5);     // 4, which the thesis's fear lacks
  EXPECT_GT(brow("fear", "up"), 0.5);
  EXPECT_LT(brow("anger", "up"), -0.5);                                                // 4 lowers
  EXPECT_GT(find_value(find("emfacs", "anger"), "lips", Side::none, "press"), 0.5);    // 23
  EXPECT_GT(find_value(find("emfacs", "joy"), "lid", Side::left, "lower"), 0.3);       // 6
  EXPECT_GT(find_value(find("emfacs", "surprise"), "chin", Side::none, "down"), 0.3);  // 26
}

TEST(libraries, are_taken_by_name_and_by_library) {
  const Spec spec = load_text(
      "mien: 1\nlibrary: emfacs\nclip: {keys: [{at: 0s, express: joy}, {at: 1s, express: tezuka/smile}]}\n");
  EXPECT_EQ(spec.clip.keys[0].pose, find("emfacs", "joy"));
  EXPECT_EQ(spec.clip.keys[1].pose, find("tezuka", "smile"));
}

// The invariants of Rhubarb's own description of its shapes (README.adoc, "Mouth shapes").
TEST(libraries, have_the_nine_shapes_of_rhubarb) {
  const auto open = [](const char* name) {
    return find_value(find("mouths", name), "chin", Side::none, "down");
  };
  const auto wide = [](const char* name) {
    return find_value(find("mouths", name), "corner", Side::left, "out");
  };
  EXPECT_EQ(find("mouths", "X"), Pose{});
  EXPECT_EQ(open("A"), 0);
  EXPECT_GT(find_value(find("mouths", "A"), "lips", Side::none, "press"), 0.5);
  EXPECT_LT(open("B"), open("C"));
  EXPECT_LT(open("C"), open("D"));
  EXPECT_LE(open("E"), open("C"));
  EXPECT_LE(open("C"), open("H"));
  EXPECT_LT(open("H"), open("D"));
  EXPECT_LT(wide("F"), wide("E"));
  EXPECT_LT(wide("E"), wide("C"));
  EXPECT_GT(find_value(find("mouths", "G"), "lips", Side::none, "lower"), 0);  // to the teeth
  for (const char* vowel : {"a", "e", "i", "o", "u"}) EXPECT_NE(find("mouths", vowel), Pose{});
}

}  // namespace
}  // namespace mien

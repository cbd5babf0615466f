// Heads drawn at random: how people differ, as templates/head/people.yaml tells it, and `random` among a
// head's other keys.
#include "config/people.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "config/config_fixture.hpp"
#include "config/head_words.hpp"
#include "config/starter.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

const HeadWords& words() {
  static const HeadWords ours = [] {
    Findings findings;
    HeadWords read = load_head_words(kData, findings);
    throw_mistakes(std::move(findings));
    return read;
  }();
  return ours;
}

const People& people() { return words().people; }

HeadSpec draw(std::uint64_t seed, HeadSpec head = {}) {
  draw_person(people(), seed, head);
  return head;
}

HeadSpec load_head_text(const std::string& head) { return load_text("mien: 1\nhead: " + head + "\n").head; }

bool are_alike(const HeadSpec& a, const HeadSpec& b) {
  return a.skull == b.skull && a.character == b.character && a.features == b.features && a.hair == b.hair &&
         a.look.skin == b.look.skin && a.look.lips == b.look.lips && a.look.iris == b.look.iris &&
         a.look.brow == b.look.brow && a.look.hair == b.look.hair && a.look.beard == b.look.beard &&
         a.look.freckles == b.look.freckles;
}

constexpr std::uint64_t kCrowd = 4000;

TEST(people, differ_in_every_feature) {
  // `character` is the head's own.
  for (const std::string& feature : words().features)
    EXPECT_TRUE(feature == "character" || draw(1).features.contains(feature)) << feature;
}

TEST(people, are_the_same_by_the_same_seed_and_others_by_another) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    EXPECT_TRUE(are_alike(draw(seed), draw(seed))) << seed;
    EXPECT_FALSE(are_alike(draw(seed), draw(seed + 1))) << seed;
  }
}

// What is drawn must not change with the compiler, the machine or a new version: authors keep seeds in files.
TEST(people, seven_is_who_he_was) {
  const HeadSpec seven = draw(7);
  std::string text = fmt::format("{:.2f}", seven.character);
  for (const char* name : {"nose_length", "jaw_width", "adams_apple"})
    text += fmt::format(" {:.2f}", seven.features.at(name));
  EXPECT_EQ(text + " " + seven.hair, "-0.79 0.77 0.25 -0.49 bun");
}

TEST(people, go_together_as_their_file_says) {
  const std::size_t count = people().dials.size();
  std::vector<double> sum(count, 0);
  std::vector<std::vector<double>> product(count, std::vector<double>(count, 0));
  for (std::uint64_t seed = 0; seed < kCrowd; ++seed) {
    const std::vector<double> dials = draw_dials(people(), seed, draw(seed).character);
    for (std::size_t i = 0; i < count; ++i) {
      sum[i] += dials[i] / kCrowd;
      for (std::size_t j = 0; j < count; ++j) product[i][j] += dials[i] * dials[j] / kCrowd;
    }
  }
  // Four standard errors of a correlation of 0 among so many; and what is cut at `most`.
  const double tolerance = 4 / std::sqrt(static_cast<double>(kCrowd)) + 0.03;
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_NEAR(sum[i], 0, tolerance) << people().dials[i];
    for (std::size_t j = 0; j < count; ++j)
      EXPECT_NEAR(product[i][j], people().together[i][j], i == j ? 2 * tolerance : tolerance)
          << people().dials[i] << " " << people().dials[j];
  }
}

TEST(people, are_of_both_sexes_all_skins_and_many_cuts) {
  double women = 0, darker = 0;
  std::set<std::string> hers, his;
  for (std::uint64_t seed = 0; seed < kCrowd; ++seed) {
    const HeadSpec head = draw(seed);
    women += head.character < 0;
    darker += head.look.skin.g < words().looks[2].second.skin.g;
    (head.character < 0 ? hers : his).insert(head.hair);
    EXPECT_GE(std::abs(head.character), 0.2);
    double sum = 0;
    for (const auto& [name, weight] : head.skull) {
      EXPECT_GT(weight, 0) << name;
      sum += weight;
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    for (const auto& [name, value] : head.features) EXPECT_LE(std::abs(value), 1) << name;
  }
  EXPECT_NEAR(women / kCrowd, 0.5, 0.03);
  EXPECT_NEAR(darker / kCrowd, 7.0 / 15, 0.04);  // half of the olive ones, and all that are darker
  for (const std::string& cut : kHairs) {
    const auto known = people().cuts.find(cut);
    const CutShares& shares = known == people().cuts.end() ? people().other_cuts : known->second;
    EXPECT_EQ(hers.contains(cut), shares.women > 0) << cut;
    EXPECT_EQ(his.contains(cut), shares.men > 0) << cut;
  }
}

TEST(people, some_men_wear_beards_and_some_light_skins_have_freckles) {
  constexpr int kFew = 400;
  int bearded = 0, men = 0, freckled = 0;
  std::set<std::string> beards;
  for (int seed = 0; seed < kFew; ++seed) {
    const HeadSpec head = draw(static_cast<std::uint64_t>(seed));
    men += head.character > 0;
    bearded += head.look.beard != "none";
    beards.insert(head.look.beard);
    if (head.character < 0) {
      EXPECT_EQ(head.look.beard, "none") << seed;
    }
    if (head.look.freckles == 0) continue;
    ++freckled;
    EXPECT_GE(head.look.freckles, people().least_freckles) << seed;
    EXPECT_LE(head.look.freckles, people().most_freckles) << seed;
  }
  EXPECT_EQ(beards.size(), people().beards.size());
  double sum = 0;
  for (const auto& [name, share] : people().beards) sum += share;
  EXPECT_NEAR(static_cast<double>(bearded) / men, 1 - people().beards.at("none") / sum, 0.08);
  EXPECT_NEAR(static_cast<double>(freckled) / kFew, (2 * 0.45 + 4 * 0.2 + 4 * 0.06) / 15, 0.04);
  const Look said = load_head_text("{random: 3, character: 1, look: {beard: short, freckles: 0.9}}").look;
  EXPECT_EQ(said.beard, "short");
  EXPECT_EQ(said.freckles, 0.9);
}

TEST(people, random_draws_what_the_file_does_not_say) {
  EXPECT_TRUE(are_alike(load_head_text("{random: 7}"), draw(7)));
  EXPECT_EQ(load_head_text("{random: 7}").age, (Mix{{"adult", 1.0}}));
  const HeadSpec head = load_head_text(
      "{age: child, random: 7, skull: round, hair: bun, features: {nose_length: -0.5}, look: {iris: "
      "\"#102030\"}}");
  HeadSpec expected = draw(7);
  expected.skull = {{"round", 1.0}};
  expected.hair = "bun";
  expected.features["nose_length"] = -0.5;
  expected.look.iris = glm::vec3(16, 32, 48) / 255.0f;
  EXPECT_TRUE(are_alike(head, expected));
  EXPECT_EQ(head.age, (Mix{{"child", 1.0}}));
}

TEST(people, a_skin_by_its_name_brings_its_colours) {
  const Look said = load_head_text("{look: {skin: deep}}").look,
             look = load_head_text("{random: 3, look: {skin: deep}}").look;
  EXPECT_EQ(look.skin, said.skin);
  EXPECT_EQ(look.lips, said.lips);
  EXPECT_EQ(look.hair, said.hair);
  EXPECT_EQ(look.iris, said.iris);
  EXPECT_FALSE(load_head_text("{random: 3, look: {skin: \"#806040\"}}").look.lips)
      << "made from that skin's colour";
}

TEST(people, a_character_that_is_said_has_the_hair_that_suits_it) {
  for (int seed = 0; seed < 200; ++seed) {
    const HeadSpec woman = load_head_text(fmt::format("{{random: {}, character: female}}", seed));
    EXPECT_EQ(woman.character, -1);
    EXPECT_NE(woman.hair, "none") << seed;
  }
}

TEST(people, of_a_clip_keep_what_was_drawn_while_they_grow) {
  const Spec spec = load_text("mien: 1\nhead: {random: 7}\nclip: {head: [{at: 1s}, {at: 2s, age: child}]}\n");
  ASSERT_EQ(spec.clip.head.size(), 2u);
  EXPECT_TRUE(are_alike(spec.clip.head.back().head, draw(7)));
}

TEST(people, spelled_out_by_new_are_the_same_head) {
  for (int seed = 0; seed < 40; ++seed) {
    const Spec spec = load_text(load_starter(kData, "otto", seed));
    EXPECT_TRUE(are_alike(spec.head, draw(static_cast<std::uint64_t>(seed)))) << seed;
    EXPECT_FALSE(spec.head.random) << "all of it is said";
    EXPECT_EQ(spec.title, "otto");
    EXPECT_GT(spec.clip.keys.size(), 2u) << "the rest is the template's";
  }
  EXPECT_EQ(load_text(load_starter(kData, "otto", {})).head.skull, (Mix{{"average", 1.0}}));
}

// Mistakes of our own data are told as those of an author's file.
std::string find_people_mistakes(const std::string& from, const std::string& to) {
  std::string text = read_file(kData / "templates/head/people.yaml");
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  const auto file = make_test_folder() / "people.yaml";
  write_file(file, text.replace(at, from.size(), to));
  Findings findings;
  load_people(file, {words().features, words().looks}, findings);
  try {
    throw_mistakes(std::move(findings));
  } catch (const InputError& error) {
    std::string told;
    for (Diagnostic diagnostic : error.diagnostics) {
      EXPECT_EQ(std::filesystem::path(diagnostic.place.file).filename(), "people.yaml");
      EXPECT_GT(diagnostic.place.line, 20);
      told += (told.empty() ? "" : "\n") + diagnostic.message;
    }
    return told;
  }
  return "";
}

TEST(people, mistakes_of_their_file_are_told_at_their_places) {
  EXPECT_EQ(find_people_mistakes("most:", "most:"), "");
  EXPECT_EQ(find_people_mistakes("\n  ear_angle: ", "\n  ear_angel: ").substr(0, 70),
            "unknown feature 'ear_angel' in 'features'; did you mean 'ear_angle'?\nu")
      << "then it is no dial";
  EXPECT_EQ(find_people_mistakes("more: wide", "more: wode"), "unknown skull 'wode'; did you mean 'wide'?");
  EXPECT_EQ(find_people_mistakes("  bob: {women", "  bub: {women"),
            "unknown cut of hair 'bub' in 'cuts'; did you mean 'bob'?");
  EXPECT_EQ(find_people_mistakes("adams_apple: {character: 0.5}", "adams_apple: {character: 1.55}"),
            "'together.adams_apple.character' is '1.55'; expected a number from -1 to 1");
  EXPECT_EQ(find_people_mistakes("adams_apple: {character: 0.5}",
                                 "adams_apple: {character: 0.5, neck_width: 0.99}"),
            "'together' contradicts itself: 'adams_apple' cannot go with those before it as it says; "
            "expected weaker "
            "correlations");
  EXPECT_EQ(find_people_mistakes("adams_apple: {character: 0.5}",
                                 "adams_apple: {cheek_fullness: 0.1, adams_apple: 1}"),
            "'adams_apple' and 'cheek_fullness' are told twice; expected each two of them once\n"
            "'adams_apple' and 'adams_apple' are told to be one; expected each two of them once");
}

TEST(people, without_their_file_do_not_differ) {
  Findings findings;
  const People nobody = load_people(make_test_folder() / "people.yaml", {}, findings);
  HeadSpec head;
  draw_person(nobody, 7, head);
  EXPECT_TRUE(are_alike(head, {}));
}

}  // namespace
}  // namespace mien

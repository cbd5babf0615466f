// Drawing people. Numbers that go together: T. W. Anderson, "An Introduction to Multivariate Statistical
// Analysis" (2003), section 2.4.
#include "config/people.hpp"

#include <algorithm>
#include <cmath>

#include "core/seeded.hpp"
#include "core/smooth.hpp"

namespace mien {

namespace {

// Each use of a seed has a generator of its own.
enum Use : std::uint64_t { kUseCharacter, kUseDials, kUseLook, kUseHair, kUseBeard, kUseFreckles };

constexpr double kHundred = 100;  // what is drawn is a whole number of hundredths
// Nearer to the middle nobody is drawn; a head that is set there may have a woman's or a man's hair.
constexpr double kLeastCharacter = 0.2;

double round_hundredths(double value) { return std::round(value * kHundred) / kHundred + 0.0; }

// srgb, as "#rrggbb" would say it.
glm::vec3 round_colour(const glm::vec3& colour) {
  return glm::round(glm::clamp(colour, 0.0f, 1.0f) * 255.0f) / 255.0f;
}

double draw_character(const People& people, std::uint64_t seed) {
  std::mt19937_64 random = build_random(seed, kUseCharacter);
  const double sex = sample_uniform(random) < 0.5 ? -1 : 1;
  const double size = people.character_middle + people.character_spread * sample_normal(random);
  return sex * round_hundredths(std::clamp(size, kLeastCharacter, 1.0));
}

// Wide 0.2 and round 0.1, say, and so much of the average that all is 1.
Mix draw_skull(const People& people, const std::vector<double>& dials) {
  Mix mix;
  double sum = 0;
  for (std::size_t i = 0; i < people.skulls.size(); ++i) {
    const SkullWay& way = people.skulls[i];
    const double weight = way.spread * dials[2 + i];
    mix[weight > 0 ? way.more : way.less] += std::abs(weight);
    sum += std::abs(weight);
  }
  const double share = sum > people.most_skull ? people.most_skull / sum : 1;
  double rest = kHundred;
  Mix rounded;
  for (const auto& [name, weight] : mix)
    if (const double hundredths = std::round(share * weight * kHundred); hundredths > 0) {
      rounded[name] = hundredths / kHundred;
      rest -= hundredths;
    }
  if (rest > 0) rounded["average"] = rest / kHundred;
  double whole = 0;  // as the reader of a file that says the same sums them
  for (const auto& [name, weight] : rounded) whole += weight;
  for (auto& [name, weight] : rounded) weight /= whole;
  return rounded;
}

// One of the names, as often as its weight says; the first if none weighs anything.
std::string draw_name(const std::map<std::string, double>& weights, std::mt19937_64& random) {
  double sum = 0;
  for (const auto& [name, weight] : weights) sum += weight;
  double at = sum * sample_uniform(random);
  for (const auto& [name, weight] : weights) {
    if (at < weight) return name;
    at -= weight;
  }
  return weights.begin()->first;
}

// The share of people whose skin is lighter: of a standard normal number.
double compute_rank(double normal) { return 0.5 * std::erfc(-normal / std::sqrt(2.0)); }

// Where a rank lies among the skins: 0.5 is half way from the first to the second one.
double find_skin(const People& people, double rank) {
  double sum = 0, below = 0;
  for (const PeoplesSkin& skin : people.skins) sum += skin.share;
  const double most = static_cast<double>(people.skins.size()) - 1;
  for (std::size_t i = 0; i < people.skins.size(); ++i) {
    const double share = people.skins[i].share / sum;
    if (rank <= below + share && share > 0)  // each skin stands in the middle of its people
      return std::clamp(static_cast<double>(i) + (rank - below) / share - 0.5, 0.0, most);
    below += share;
  }
  return most;
}

Look draw_look(const People& people, std::uint64_t seed, double tone) {
  std::mt19937_64 random = build_random(seed, kUseLook);
  const double at = find_skin(people, compute_rank(tone));
  const auto lighter = static_cast<std::size_t>(at);
  const std::size_t darker = std::min(lighter + 1, people.skins.size() - 1);
  const double share = at - static_cast<double>(lighter);
  const Look &from = people.skins[lighter].look, &to = people.skins[darker].look;
  const PeoplesSkin& own = people.skins[sample_uniform(random) < share ? darker : lighter];
  const HairColour& hair = people.hair_colours.at(draw_name(own.hairs, random));
  const glm::vec3 iris = people.irises.at(draw_name(own.irises, random));
  const auto shade = static_cast<float>(1 + people.shade * sample_uniform(random, -1, 1));
  Look look;
  look.skin = round_colour(glm::mix(from.skin, to.skin, static_cast<float>(share)));
  if (from.lips && to.lips)
    look.lips = round_colour(glm::mix(*from.lips, *to.lips, static_cast<float>(share)));
  look.iris = round_colour(iris);
  look.hair = round_colour(hair.hair * shade);
  look.brow = round_colour(hair.brow * shade);
  return look;
}

std::string draw_cut(const People& people, std::uint64_t seed, double character) {
  std::mt19937_64 random = build_random(seed, kUseHair);
  const double man = smooth_step(-kLeastCharacter, kLeastCharacter, character);
  std::map<std::string, double> weights;
  for (const std::string& cut : kHairs) {
    const auto known = people.cuts.find(cut);
    const CutShares& shares = known == people.cuts.end() ? people.other_cuts : known->second;
    weights[cut] = glm::mix(shares.women, shares.men, man);
  }
  return draw_name(weights, random);
}

std::string draw_beard(const People& people, std::uint64_t seed, double character) {
  if (people.beards.empty() || character < kLeastCharacter) return "none";
  std::mt19937_64 random = build_random(seed, kUseBeard);
  return draw_name(people.beards, random);
}

double draw_freckles(const People& people, std::uint64_t seed, double tone) {
  std::mt19937_64 random = build_random(seed, kUseFreckles);
  const auto nearest = static_cast<std::size_t>(std::lround(find_skin(people, compute_rank(tone))));
  if (sample_uniform(random) >= people.skins[nearest].freckled) return 0;
  return round_hundredths(sample_uniform(random, people.least_freckles, people.most_freckles));
}

}  // namespace

std::vector<double> draw_dials(const People& people, std::uint64_t seed, double character) {
  std::mt19937_64 random = build_random(seed, kUseDials);
  // A crowd's character is on both sides of 0: its standard deviation is the root of its mean square.
  std::vector<double> own{character / std::hypot(people.character_middle, people.character_spread)};
  std::vector<double> dials{std::clamp(own[0], -people.most, people.most)};
  for (std::size_t i = 1; i < people.root.size(); ++i) {
    own.push_back(sample_normal(random));
    double sum = 0;
    for (std::size_t j = 0; j <= i; ++j) sum += people.root[i][j] * own[j];
    dials.push_back(std::clamp(sum, -people.most, people.most));
  }
  return dials;
}

void draw_person(const People& people, std::uint64_t seed, HeadSpec& head) {
  if (people.root.empty()) return;
  const auto is_said = [&](const std::string& key) { return head.said.contains(key); };
  if (!is_said("character")) head.character = draw_character(people, seed);
  const std::vector<double> dials = draw_dials(people, seed, head.character);
  if (!is_said("skull")) head.skull = draw_skull(people, dials);
  const std::size_t first = dials.size() - people.features.size();
  for (std::size_t i = 0; i < people.features.size(); ++i) {
    const auto& [name, spread] = people.features[i];
    if (!is_said("features." + name))
      head.features[name] = round_hundredths(std::clamp(spread * dials[first + i], -1.0, 1.0));
  }
  if (!is_said("hair")) head.hair = draw_cut(people, seed, head.character);
  const Look look = draw_look(people, seed, dials[1]);
  if (!is_said("look.skin")) {
    head.look.skin = look.skin;
    if (!is_said("look.lips")) head.look.lips = look.lips;
  }
  if (!is_said("look.iris")) head.look.iris = look.iris;
  if (!is_said("look.brow")) head.look.brow = look.brow;
  if (!is_said("look.hair")) head.look.hair = look.hair;
  if (!is_said("look.beard")) head.look.beard = draw_beard(people, seed, head.character);
  if (!is_said("look.freckles")) head.look.freckles = draw_freckles(people, seed, dials[1]);
}

}  // namespace mien

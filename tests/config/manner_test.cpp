// How expressions grow with their strength, and which of two opposite ones an area follows.
#include <random>

#include "config/config_fixture.hpp"
#include "config/pose_mix.hpp"

namespace mien {
namespace {

const std::size_t kCornerUp = *find_move(Area::corner, Side::left, "up");
const std::size_t kBrowUp = *find_move(Area::brow, Side::left, "up");
const std::size_t kUpperLid = *find_move(Area::lid, Side::left, "upper");

PoseShare make_share(double weight, std::size_t move, double value, double dominance, double growth = 1) {
  auto manner = std::make_shared<Manner>();
  manner->dominance[move] = dominance;
  manner->growth[move] = growth;
  PoseShare share{weight, {}, manner};
  share.pose.values[move] = value;
  return share;
}

double mix_two(double up, double down, double of_up, double of_down, std::size_t move = kCornerUp) {
  return mix_poses({make_share(1, move, up, of_up), make_share(1, move, down, of_down)}).values[move];
}

TEST(manner, lets_the_dominant_one_of_two_opposites_keep_its_way) {
  EXPECT_NEAR(mix_two(0.9, -0.8, 3, 1), 0.9 - 0.8 * 2 / 10, 1e-12);
  EXPECT_NEAR(mix_two(0.9, -0.8, 1, 3), 0.9 - 0.8 * 8 / 10 - 0.8, 1e-12);
  EXPECT_NEAR(mix_two(0.9, -0.8, 1, 0), 0.9, 1e-12);
  for (const double dominance : {1.0, 2.5}) EXPECT_NEAR(mix_two(0.9, -0.8, dominance, dominance), 0.1, 1e-12);
}

TEST(manner, adds_what_goes_the_same_way) {
  EXPECT_NEAR(mix_two(0.3, 0.4, 3, 1), 0.7, 1e-12);
  EXPECT_NEAR(mix_two(-0.3, -0.4, 3, 1), -0.7, 1e-12);
  EXPECT_NEAR(mix_two(-0.3, -0.4, 3, 1, kUpperLid), -0.4, 1e-12) << "a lid shuts once";
}

TEST(manner, of_a_mix_changes_without_a_jump) {
  std::mt19937 random(11);
  const auto roll = [&](double low, double high) {
    return low + (high - low) * 0x1p-32 * static_cast<double>(random());
  };
  for (int i = 0; i < 200; ++i) {
    const double up = roll(0, 1), down = -roll(0, 1), a = roll(0.1, 5), b = roll(0.1, 5);
    const double step = 1e-6, here = mix_two(up, down, a, b);
    EXPECT_NEAR(mix_two(up + step, down, a, b), here, 3 * step);
    EXPECT_NEAR(mix_two(up, down - step, a, b), here, 3 * step);
    EXPECT_NEAR(mix_two(up, down, a + step, b), here, 30 * step);
    EXPECT_NEAR(mix_two(up, -1e-9, a, b), up, 1e-8) << "an opposite that is nearly none takes nothing";
  }
}

TEST(manner, has_areas_grow_early_or_late_and_meet_at_full_strength) {
  const auto at = [](double strength, double growth) {
    return strength * mix_poses({make_share(1, kCornerUp, 0.8, 1, growth)}, strength).values[kCornerUp];
  };
  EXPECT_NEAR(at(0.25, 0.5), 0.4, 1e-12);
  EXPECT_NEAR(at(0.5, 2), 0.2, 1e-12);
  for (const double growth : {0.25, 0.5, 1.0, 2.0, 4.0}) {
    EXPECT_NEAR(at(1, growth), 0.8, 1e-12);
    EXPECT_EQ(at(0, growth), 0);
    for (double strength = 0; strength < 1; strength += 0.05)
      EXPECT_LT(at(strength, growth), at(strength + 0.05, growth));
  }
}

TEST(manner, is_written_with_an_expression_and_handed_on) {
  const Spec spec = load_text(R"(mien: 1
expressions:
  gay: {corners: {up: 0.8}, chin: {down: 0.8}, dominance: {corners: 3}, growth: {chin: 2, corner.left: 0.5}}
  grave: {corners: {up: -0.8}}
  gayer: {from: gay, growth: {chin: 4}, dominance: {corners: 1}}
  half: {from: gay, strength: 0.5}
clip:
  keys:
    - {at: 0s, express: gay, strength: 0.25}
    - {at: 1s, express: {gay: 1, grave: 1}}
    - {at: 2s, express: {gayer: 0.5, grave: 0.5}}
    - {at: 3s, express: gay, strength: "0.25"}
)");
  const auto value = [&](std::size_t key, std::string_view area, Side side, std::string_view move) {
    return find_value(spec.clip.keys[key].pose, area, side, move);
  };
  EXPECT_NEAR(value(0, "chin", Side::none, "down"), 0.05, 1e-12);
  EXPECT_NEAR(value(0, "corner", Side::left, "up"), 0.4, 1e-12);
  EXPECT_NEAR(value(0, "corner", Side::right, "up"), 0.2, 1e-12);
  EXPECT_NEAR(value(1, "corner", Side::right, "up"), 0.8 - 0.8 * 0.2, 1e-12);
  EXPECT_NEAR(value(2, "chin", Side::none, "down"), 0.4, 1e-12);
  EXPECT_NEAR(value(2, "corner", Side::right, "up"), 0, 1e-12) << "equals cancel";
  EXPECT_EQ(spec.clip.keys[3].pose, spec.clip.keys[0].pose) << "a formula's strength is a strength";
  EXPECT_NEAR(find_value(find_expression(spec, "half").pose, "chin", Side::none, "down"), 0.2, 1e-12);
}

TEST(manner, of_the_house_keeps_both_feelings_of_a_mix) {
  const Spec spec = load_text(
      "mien: 1\nclip: {keys: [{at: 0s, express: {smile: 0.8, sadness: 0.9}}, {at: 1s, express: {smile: 0.9, "
      "anger: 0.8}}]}\n");
  const Pose& wistful = spec.clip.keys[0].pose;
  EXPECT_GT(wistful.values[kCornerUp], 0.5) << "a mouth that smiles";
  EXPECT_GT(find_value(wistful, "brow", Side::left, "turn"), 0.7) << "under brows that grieve";
  const Pose& gloating = spec.clip.keys[1].pose;
  EXPECT_GT(gloating.values[kCornerUp], 0.5);
  EXPECT_LT(gloating.values[kBrowUp], -0.3);
}

}  // namespace
}  // namespace mien

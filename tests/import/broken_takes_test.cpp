// Takes that are broken at random: each is read or told at a place, and never anything else.
#include <random>

#include "import/take_samples.hpp"
#include "import/unit_pose.hpp"

namespace mien {
namespace {

constexpr unsigned kRounds = 60;

// One of the ways in which files break: cut, a byte changed, a piece lost or twice, a piece of others' words.
std::string break_bytes(std::string text, std::mt19937& random) {
  const auto pick = [&](std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
  };
  const std::size_t at = pick(text.size()), length = 1 + pick(std::min<std::size_t>(text.size() - at, 80));
  const char* words[] = {"nan", "-1e400", "\"", "{", "]", ",,", "\n", "\xFF\xFE", "1e9", ":", "null", "[[[["};
  switch (pick(5)) {
    case 0:
      return text.substr(0, at);
    case 1:
      text[at] = static_cast<char>(pick(256));
      return text;
    case 2:
      return text.erase(at, length);
    case 3:
      return text.insert(at, text.substr(at, length));
    default:
      return text.insert(at, words[pick(std::size(words))]);
  }
}

void expect_told(const std::string& name, TakeKind kind) {
  const std::string whole = read_take_sample(name);
  for (unsigned seed = 1; seed <= kRounds; ++seed) {
    std::mt19937 random(seed);
    const std::string broken = break_bytes(whole, random);
    const std::string file = "broken_" + std::to_string(seed) + "_" + name;
    try {
      const Take take = load_take(write_take_file(file, broken), kind);
      EXPECT_EQ(take.values.size(), take.at_s.size() * take.channels.size()) << file;
      for (std::size_t i = 1; i < take.at_s.size(); ++i) EXPECT_GT(take.at_s[i], take.at_s[i - 1]) << file;
    } catch (const InputError& error) {
      ASSERT_FALSE(error.diagnostics.empty()) << file;
      EXPECT_NE(error.diagnostics[0].place.file, "") << file;
      EXPECT_NE(error.diagnostics[0].message.find("xpected"), std::string::npos)
          << file << ": " << error.diagnostics[0].message;
    }
  }
}

void expect_pose_told(const std::string& name) {
  const std::string whole = read_take_sample(name);
  for (unsigned seed = 1; seed <= kRounds; ++seed) {
    std::mt19937 random(seed);
    const std::string file = "broken_" + std::to_string(seed) + "_" + name;
    try {
      EXPECT_LE(load_unit_pose(write_take_file(file, break_bytes(whole, random))).units.size(), 4u) << file;
    } catch (const InputError& error) {
      ASSERT_FALSE(error.diagnostics.empty()) << file;
      EXPECT_NE(error.diagnostics[0].message.find("xpected"), std::string::npos)
          << file << ": " << error.diagnostics[0].message;
    }
  }
}

TEST(broken_takes, of_makehuman_are_told) { expect_pose_told("smile.mhpose"); }
TEST(broken_takes, of_mpfb_are_told) { expect_pose_told("mpfb.json"); }
TEST(broken_takes, of_live_link_are_told) { expect_told("live_link.csv", TakeKind::live_link); }
TEST(broken_takes, of_openface_are_told) { expect_told("openface.csv", TakeKind::openface); }
TEST(broken_takes, of_mediapipe_are_told) { expect_told("mediapipe.json", TakeKind::arkit); }
TEST(broken_takes, of_arkit_are_told) { expect_told("arkit.json", TakeKind::arkit); }
TEST(broken_takes, of_openfacefx_are_told) { expect_told("openfacefx.json", TakeKind::tracks); }
TEST(broken_takes, of_vrm_are_told) { expect_told("gesture.vrma", TakeKind::vrma); }
TEST(broken_takes, of_gltf_are_told) { expect_told("head.glb", TakeKind::gltf); }

}  // namespace
}  // namespace mien

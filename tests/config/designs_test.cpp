#include <gtest/gtest.h>

#include <algorithm>

#include "config/design_data.hpp"
#include "config/words.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

const std::vector<Design>& shipped_designs() { return shipped_stock().head->designs; }

TEST(designs, stand_with_meaning_and_style_in_a_file_each) {
  std::vector<std::string> names;
  for (const Design& design : shipped_designs()) {
    names.push_back(design.name);
    EXPECT_FALSE(design.meaning.empty()) << design.name;
    EXPECT_EQ(design.style, design.name == "caricature" ? Style::studio : Style::ink) << design.name;
  }
  EXPECT_EQ(names, (std::vector<std::string>{"caricature", "comic", "manga"}));
}

TEST(designs, real_changes_no_dial) {
  const DesignNumbers real = mix_designs(shipped_designs(), {{kReal, 1.0}}, {{"child", 1.0}}), plain;
  for (const DesignDial& dial : kDesignDials) EXPECT_EQ(real.*dial.number, plain.*dial.number) << dial.name;
}

TEST(designs, mix_dial_by_dial_and_age_by_age) {
  const std::vector<Design>& all = shipped_designs();
  const DesignNumbers adult = mix_designs(all, {{"comic", 1.0}}, {{"adult", 1.0}});
  const DesignNumbers child = mix_designs(all, {{"comic", 1.0}}, {{"child", 1.0}});
  EXPECT_EQ(adult.eye_size, 1.62);
  EXPECT_EQ(child.eye_size, 1.55);
  EXPECT_EQ(child.lip_height, adult.lip_height);  // what the age says nothing of is everybody's
  const DesignNumbers mixed =
      mix_designs(all, {{kReal, 0.6}, {"comic", 0.4}}, {{"adult", 0.25}, {"child", 0.75}});
  const DesignNumbers plain;
  for (const DesignDial& dial : kDesignDials)
    EXPECT_NEAR(mixed.*dial.number,
                0.6 * plain.*dial.number + 0.4 * (0.25 * adult.*dial.number + 0.75 * child.*dial.number),
                1e-12)
        << dial.name;
  EXPECT_EQ(mix_designs(all, {{"comic", 1.0}}, {}).eye_size, adult.eye_size);  // a scan that says no age
  EXPECT_THROW(mix_designs(all, {{"cubist", 1.0}}, {}), RunError);
}

TEST(designs, dials_stay_in_their_ranges_in_every_file) {
  for (const Design& design : shipped_designs())
    for (const auto& [age, numbers] : design.ages)
      for (const DesignDial& dial : kDesignDials) {
        EXPECT_GE(numbers.*dial.number, dial.low) << design.name << ' ' << dial.name;
        EXPECT_LE(numbers.*dial.number, dial.high) << design.name << ' ' << dial.name;
      }
}

TEST(designs, files_are_checked_at_their_places) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "odd_designs";
  std::filesystem::create_directories(folder);
  write_file(folder / "odd.yaml",
             "meaning: odd\nstyle: oil\neyes: {size: 9, bigger: 2}\nnoses: {}\nages: {aged: {}}\n");
  Findings findings;
  EXPECT_EQ(load_designs(folder, findings).size(), 1U);
  std::string told;
  for (const Diagnostic& mistake : findings.mistakes) told += mistake.message + "\n";
  for (const char* part : {"oil", "0.6 to 2", "bigger", "noses", "aged"})
    EXPECT_NE(told.find(part), std::string::npos) << part << " in\n" << told;
}

}  // namespace
}  // namespace mien

// The heads measured as an anthropometrist measures them: by landmarks on the skin of the neutral head.
// Sources: the guide lines by Loomis, "Drawing the Head and Hands" (1956), plates 18 and 57-60 and the chart
// of ages in "Figure Drawing"; distances by Farkas, "Anthropometry of the Head and Face" (1994), by ANSUR II
// (Gordon et al. 2014) where it has them; ratios of the ages as Farkas' tables and MakeHuman's heads have
// them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "core/data.hpp"
#include "head/distances.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

const Places& places_of(const std::string& age) {
  static std::map<std::string, Places> known;
  if (!known.contains(age)) {
    HeadSpec spec;
    spec.age = {{age, 1.0}};
    known[age] = measure(spec);
  }
  return known[age];
}

struct Chart {
  const char* age;
  double units;  // of Loomis in the head's height
  double height_mm, height_tolerance_mm;
  double hairline, brow_line, eye_line, nose_base, mouth_line, ear_top, ear_base;
};

constexpr Chart kCharts[] = {
    {"infant", 4.0, 152, 12, .750, .500, .400, .250, .140, .470, .220},
    {"child", 3.85, 178, 12, .780, .520, .440, .255, .160, .500, .245},
    {"teenager", 3.75, 195, 8, .800, .533, .480, .265, .175, .530, .265},
    {"young_adult", 3.52, 222, 8, .857, .570, .495, .280, .190, .560, .280},
    {"adult", 3.5, 225, 8, .857, .571, .500, .286, .190, .571, .286},
    {"old", 3.5, 225, 8, .875, .567, .500, .277, .181, .574, .270},
};

TEST(proportions, every_guide_line_lies_where_loomis_has_it) {
  constexpr double kTolerance_units = 0.03;
  for (const Chart& chart : kCharts) {
    const Places& p = places_of(chart.age);
    const double height = head_height(p), unit_mm = height / chart.units;
    EXPECT_NEAR(height, chart.height_mm, chart.height_tolerance_mm) << chart.age;
    const auto expect_line = [&](const char* landmark, double fraction) {
      const double y = p.at(landmark).y - p.at("gn").y;
      EXPECT_NEAR(y / unit_mm, fraction * chart.units, kTolerance_units) << chart.age << " " << landmark;
    };
    expect_line("tr", chart.hairline);
    expect_line("g", chart.brow_line);
    expect_line("pupil_l", chart.eye_line);
    expect_line("sn", chart.nose_base);
    expect_line("sto", chart.mouth_line);
    expect_line("sa_l", chart.ear_top);
    expect_line("sba_l", chart.ear_base);
  }
}

TEST(proportions, the_adults_brows_lie_on_the_brow_line) {
  const Places& p = places_of("adult");
  const double unit_mm = head_height(p) / 3.5;
  const auto height = [&](const char* landmark) { return (p.at(landmark).y - p.at("gn").y) / unit_mm; };
  EXPECT_NEAR((height("brow_inner_l") + height("brow_mid_l") + height("brow_outer_l")) / 3, 2, 0.03);
  EXPECT_GT(height("brow_mid_l"), height("brow_inner_l"));
  EXPECT_GT(height("brow_mid_l"), height("brow_outer_l"));
}

// tr-n is the one that cannot hold: Loomis' forehead of one unit is longer than most people's.
TEST(proportions, the_average_adult_is_between_the_mean_man_and_the_mean_woman) {
  int within = 0;
  for (const Distance& d : list_distances(places_of("adult"))) {
    const bool fits = d.ours_mm >= std::min(d.man_mm - d.man_sd, d.woman_mm - d.woman_sd) &&
                      d.ours_mm <= std::max(d.man_mm + d.man_sd, d.woman_mm + d.woman_sd);
    within += fits;
    EXPECT_TRUE(fits || d.name == std::string("tr-n")) << d.name << " " << d.ours_mm;
  }
  EXPECT_EQ(within, 23);
}

TEST(proportions, women_are_smaller_than_men_where_people_differ) {
  HeadSpec man, woman;
  man.character = 1;
  woman.character = -1;
  const Places his = measure(man), hers = measure(woman);
  EXPECT_GT(across(his, "zy"), across(hers, "zy") + 4);
  EXPECT_GT(across(his, "go"), across(hers, "go") + 6);
  EXPECT_GT(between(his, "n", "gn"), between(hers, "n", "gn") + 4);
  EXPECT_GT(between(his, "n", "sn"), between(hers, "n", "sn"));
  EXPECT_GT(his.at("g").z - his.at("n").z, hers.at("g").z - hers.at("n").z + 1);  // the ridge of the brows
  // Eyes differ least.
  EXPECT_NEAR(between(his, "en_l", "ex_l"), between(hers, "en_l", "ex_l"), 1.5);
}

struct Ratio {
  const char* name;
  double (*measure)(const Places&);
  double infant, child, teenager, young_adult, adult;  // an old head's bones are the adult's
  double tolerance;                                    // of the value
};

double measure_breadth(const Places& p) { return across(p, "eu"); }

const Ratio kRatios[] = {
    {"breadth / height", [](const Places& p) { return measure_breadth(p) / head_height(p); }, .79, .735, .70,
     .69, .66, .03},
    {"length / height", [](const Places& p) { return between(p, "g", "op") / head_height(p); }, .99, .957,
     .932, .922, .88, .03},
    {"breadth / length", [](const Places& p) { return measure_breadth(p) / between(p, "g", "op"); }, .795,
     .77, .755, .75, .737, .03},
    {"pupils / breadth", [](const Places& p) { return across(p, "pupil") / measure_breadth(p); }, .37, .388,
     .395, .398, .41, .10},
    {"eye / breadth", [](const Places& p) { return between(p, "en_l", "ex_l") / measure_breadth(p); }, .226,
     .217, .206, .205, .203, .06},
    {"mouth / breadth", [](const Places& p) { return across(p, "ch") / measure_breadth(p); }, .327, .323,
     .312, .325, .356, .15},
    {"ear / height", [](const Places& p) { return between(p, "sa_l", "sba_l") / head_height(p); }, .257, .245,
     .25, .26, .285, .10},
};

TEST(proportions, ages_have_their_own_ratios) {
  for (const Ratio& ratio : kRatios) {
    const double wanted[] = {ratio.infant, ratio.child, ratio.teenager, ratio.young_adult, ratio.adult};
    for (int i = 0; i < 5; ++i) {
      const double found = ratio.measure(places_of(kCharts[i].age));
      EXPECT_NEAR(found / wanted[i], 1, ratio.tolerance)
          << kCharts[i].age << " " << ratio.name << " " << found;
    }
  }
}

// Breadth of the face at the height of the mouth, mm, the ears left out by their depth.
double measure_jaw(const NeutralHead& head, double mouth_y) {
  constexpr float kSlice_mm = 3;
  float widest = 0;
  for (const glm::vec3& p : head.skin.positions)
    if (p.z > 10 && std::abs(p.y - static_cast<float>(mouth_y)) < kSlice_mm)
      widest = std::max(widest, std::abs(p.x));
  return 2.0 * widest;
}

// Bounds: the cephalic index's classes (brachycephalic over .80, dolichocephalic under .75), the facial
// index's, and the jaw of a square head as MakeHuman has it.
TEST(proportions, skulls_have_the_silhouettes_of_their_names) {
  struct Skull {
    double by_height, by_length, jaw, face;
  };
  const auto measure_skull = [](const char* name) {
    HeadSpec spec;
    spec.skull = {{name, 1.0}};
    const Places p = measure(spec);
    const double breadth = measure_breadth(p);
    return Skull{breadth / head_height(p), breadth / between(p, "g", "op"),
                 measure_jaw(build_neutral_head(shipped().heads, spec), p.at("sto").y) / breadth,
                 between(p, "n", "gn") / across(p, "zy")};
  };
  EXPECT_GT(measure_skull("square").jaw, 0.89);
  const Skull round = measure_skull("round");
  EXPECT_GT(round.by_height, 0.72);
  EXPECT_GT(round.by_length, 0.82);
  const Skull wide = measure_skull("wide");
  EXPECT_GT(wide.by_length, 0.81);
  EXPECT_LT(wide.face, 0.81);
  const Skull narrow = measure_skull("narrow");
  EXPECT_LT(narrow.by_length, 0.72);
  EXPECT_GT(narrow.face, 0.93);
}

TEST(proportions, a_child_is_no_small_adult) {
  const auto order = [](auto measure) {
    std::vector<double> values;
    for (const Chart& chart : kCharts)
      if (chart.age != std::string("old")) values.push_back(measure(places_of(chart.age)));
    return values;  // what is grown does not grow on
  };
  const auto rises = [](const std::vector<double>& v) { return std::is_sorted(v.begin(), v.end()); };
  EXPECT_TRUE(rises(order(head_height)));
  EXPECT_TRUE(rises(order([](const Places& p) { return between(p, "sn", "prn"); }))) << "nose";
  EXPECT_TRUE(rises(order([](const Places& p) { return between(p, "n", "gn") / head_height(p); }))) << "face";
  const Places &infant = places_of("infant"), &adult = places_of("adult");
  EXPECT_GT(across(infant, "pupil") / head_height(infant), across(adult, "pupil") / head_height(adult));
}

}  // namespace
}  // namespace mien

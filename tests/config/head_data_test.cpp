// mien's own data are checked as an author's file is: at their places, unknown keys and missing names too.
#include "config/head_data.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "config/config_fixture.hpp"
#include "config/data_table.hpp"
#include "config/head_parts.hpp"
#include "config/stock.hpp"

namespace mien {
namespace {

namespace fs = std::filesystem;

// A copy of templates/head with `from` replaced by `to` in one file.
fs::path copy_data(const std::string& name, const std::string& from, const std::string& to) {
  const fs::path folder = make_test_folder();
  fs::create_directories(folder / "templates");
  fs::copy(kData / "templates/head", folder / "templates/head");
  const fs::path file = folder / "templates/head" / name;
  std::string text = read_file(file);
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  if (at != text.npos) text.replace(at, from.size(), to);
  write_file(file, text);
  return folder;
}

// What is told of it, less the text of the line.
std::string find_mistake(const std::string& name, const std::string& from, const std::string& to) {
  try {
    load_head_data(copy_data(name, from, to), find_language()->words);
  } catch (const InputError& error) {
    const std::string text = format_error(error);
    return text.substr(0, text.find('\n'));
  } catch (const RunError& error) {
    const std::string text = error.what();
    return text.substr(text.find(name));
  }
  return "none";
}

// "areas.yaml:80:14", where `from` stands in the shipped file, or so many lines below: its rows are not
// counted here.
std::string build_place(const std::string& name, const std::string& from, int column, int below = 0) {
  const std::string text = read_file(kData / "templates/head" / name);
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(text.find(from), text.size()));
  return fmt::format("{}:{}:{}", name, 1 + below + std::count(text.begin(), end, '\n'), column);
}

TEST(head_data, is_right_as_it_is_shipped) { EXPECT_EQ(find_mistake("parts.yaml", "eye:", "eye:"), "none"); }

TEST(head_data, parts_are_told_what_they_lack) {
  EXPECT_EQ(find_mistake("parts.yaml", "  limbus:", "  limbs:"),
            "parts.yaml:6:3: error: 'eye' has no 'limbus'; expected a value");
  EXPECT_EQ(find_mistake("parts.yaml", "  corner: 24.24", "  corner: wide"),
            "parts.yaml:47:11: error: 'mouth.corner' is 'wide'; expected a number");
  EXPECT_EQ(find_mistake("parts.yaml", "iris_edge: [5.9, 11.42]", "iris_edge: [5.9]"),
            "parts.yaml:9:14: error: 'eye.iris_edge' has 1 items; expected 2");
  EXPECT_EQ(find_mistake("parts.yaml", "  station:  [0.25, ", "  station:  ["),
            "parts.yaml:30:3: error: 'above' has 8 numbers; expected 7, as many as 'station' has");
  EXPECT_EQ(find_mistake("parts.yaml", "lashes:", "eyelashes:"),
            "parts.yaml:5:1: error: the file has no 'lashes'; expected a value");
}

TEST(head_data, unknown_keys_are_told_with_the_nearest_known_one) {
  EXPECT_EQ(find_mistake("hair.yaml", "    whorl: 26", "    whorl: 26\n    whirl: 3"),
            "hair.yaml:36:5: error: unknown key 'whirl'; did you mean 'whorl'?");
  EXPECT_EQ(find_mistake("heads.yaml", "    brow_thickness: 0.9", "    brow_thicknes: 0.9"),
            "heads.yaml:30:5: error: unknown key 'brow_thicknes'; did you mean 'brow_thickness'?");
  EXPECT_EQ(find_mistake("areas.yaml", "  wide_deg: 19", "  wide_deg: 19\n  meting: 1"),
            build_place("areas.yaml", "  wide_deg: 19", 3, 1) +
                ": error: unknown key 'meting'; did you mean 'meeting'?");
}

TEST(head_data, names_of_points_areas_and_anchors_are_those_that_there_are) {
  EXPECT_EQ(find_mistake("areas.yaml", "    anchors: brow_up\n", "    anchors: brow_upp\n"),
            build_place("areas.yaml", "    anchors: brow_up\n", 14) +
                ": error: unknown anchor set 'brow_upp'; did you mean 'brow_up'?");
  EXPECT_TRUE(find_mistake("areas.yaml", "at: E1_12}", "at: E1_99}")
                  .starts_with(build_place("areas.yaml", "at: E1_12}", 20) +
                               ": error: unknown point 'E1_99'; did you mean 'E1_"));
  EXPECT_EQ(find_mistake("areas.yaml", "past_limits: {brow.up+", "past_limits: {brow.upp+"),
            build_place("areas.yaml", "past_limits: {brow.up+", 26) +
                ": error: 'brow.upp+' is no move and its sign; expected one such as brow.up+");
  EXPECT_EQ(find_mistake("areas.yaml", "  rows_lower: {EB: 1, E0: 1,", "  rows_lower: {EB: 1,"),
            build_place("areas.yaml", "  rows_upper: ", 3) +
                ": error: 'rows_lower' has no 'E0'; expected the rings of 'rows_upper'");
  EXPECT_EQ(find_mistake("areas.yaml", "  brow.up:\n", "  brow.upp:\n"),
            build_place("areas.yaml", "  brow.up:\n", 3) +
                ": error: unknown move 'brow.upp'; did you mean 'brow.up'?");
  EXPECT_EQ(find_mistake("hair.yaml", "areas: {moustache: 0.9", "areas: {mustache: 0.9"),
            "hair.yaml:262:45: error: unknown area of a beard 'mustache'; did you mean 'moustache'?");
  EXPECT_EQ(find_mistake("landmarks.yaml", "  g: p_g ", "  g: p_q "),
            "landmarks.yaml:7:6: error: unknown point 'p_q'; did you mean 'p_g'?");
  EXPECT_EQ(find_mistake("landmarks.yaml", "needed: [n,", "needed: [nn,"),
            "landmarks.yaml:68:10: error: 'nn' is no code of 'middle' or 'sided'; expected one");
  EXPECT_EQ(find_mistake("fields.csv", "\ninfant,", "\ninfant,x"), "fields.csv:5: unknown point 'xp_F4'");
}

TEST(head_data, has_each_word_of_the_language) {
  EXPECT_EQ(find_mistake("hair.yaml", "  crop:\n", "  cropp:\n"),
            "hair.yaml:32:1: error: 'cuts' has no 'crop'; expected one");
  EXPECT_EQ(find_mistake("heads.yaml", "  teenager: {teen: 1} ", "  teeny: {teen: 1} "),
            "heads.yaml:10:3: error: 'ages' has no 'teenager'; expected a value");
  EXPECT_EQ(find_mistake("features.yaml", "    view: side", "    view: top"),
            "features.yaml:9:11: error: unknown view 'top'; known: front, three_quarter, side");
}

TEST(head_data, folds_are_told_at_their_places) {
  const auto find = [](const char* from, const char* to) { return find_mistake("folds.yaml", from, to); };
  EXPECT_EQ(find("broken: .7", "broken: 2"),
            "folds.yaml:24:56: error: 'uneven.broken' is '2'; expected a number from 0 to 1");
  EXPECT_EQ(find("edge: 1.0", "edge: wide"),
            "folds.yaml:25:7: error: 'edge' is 'wide'; expected a number from 0.3 to 3");
  EXPECT_EQ(find("edge: 1.0", ""), "folds.yaml:21:1: error: the file has no 'edge'; expected a value");
  EXPECT_NE(find("[brow.up+]", "[brow.upp+]").find("expected a move and its sign, such as brow.up+"),
            std::string::npos);
  EXPECT_NE(find("[p_F1, p_F2,", "[p_F1, p_Q2,").find("unknown point 'p_Q2'"), std::string::npos);
  EXPECT_NE(find("always: .85", "always: 2").find("always' is '2'; expected a number from 0 to 1"),
            std::string::npos);
  EXPECT_NE(find("edge: .55", "edge: 2").find("edge' is '2'; expected a number from 0.1 to 1"),
            std::string::npos);
  EXPECT_NE(find("[.6, lid.upper-]", "[.6]").find("a drive without a move; expected one such as brow.up+"),
            std::string::npos);
  EXPECT_NE(find("    spread:", "    spred:").find("has no 'spread'"), std::string::npos);
}

TEST(data_table, tells_what_was_never_asked_for) {
  Findings findings;
  auto source = build_source("t.yaml", "a: 1\nb: {c: [1, 2, 3], d: true}\ne: 2\n", findings);
  const auto document = scan_document(std::move(*source), findings);
  double a = 0;
  glm::dvec3 c{0};
  bool d = false;
  {
    const DataTable table(find_root(*document, findings));
    EXPECT_TRUE(table.read("a", a));
    const DataTable b = table.at("b");
    EXPECT_TRUE(b.read("c", c));
    EXPECT_TRUE(b.read("d", d));
    EXPECT_EQ(table.find("f"), nullptr);
  }
  EXPECT_EQ(a, 1);
  EXPECT_EQ(c, glm::dvec3(1, 2, 3));
  EXPECT_TRUE(d);
  ASSERT_EQ(findings.mistakes.size(), 1u);
  EXPECT_EQ(findings.mistakes[0].place.line, 3);
  EXPECT_EQ(findings.mistakes[0].message, "unknown key 'e'; did you mean 'a'?");
}

// Whoever lists words does not read, and so does not judge, what heads are made from besides.
TEST(head_parts, are_read_without_the_others) {
  const fs::path folder = copy_data("areas.yaml", "\nlimits:", "\nlimmits:");
  EXPECT_EQ(load_shapes_alone(folder).features.size(), load_shapes_alone(kData).features.size());
  EXPECT_EQ(load_hair_alone(folder).cuts.size(), load_hair_alone(kData).cuts.size());
  EXPECT_THROW(load_head_data(folder, find_language()->words), InputError);
}

TEST(head_parts, tell_their_own_mistakes_at_their_places) {
  const auto find_first_line = [](const auto& load, const fs::path& folder) {
    try {
      load(folder);
    } catch (const InputError& error) {
      const std::string text = format_error(error);
      return text.substr(0, text.find('\n'));
    }
    return std::string("none");
  };
  EXPECT_EQ(find_first_line(load_hair_alone, copy_data("hair.yaml", "    whorl: 26", "    whirl: 26")),
            find_mistake("hair.yaml", "    whorl: 26", "    whirl: 26"));
  EXPECT_EQ(find_first_line(load_shapes_alone, copy_data("features.yaml", "features:", "featurs:")),
            find_mistake("features.yaml", "features:", "featurs:"));
  EXPECT_EQ(find_first_line(load_shapes_alone, kData), "none");
}

TEST(stock, has_all_templates_and_says_which_is_missing) {
  const Stock stock = load_stock(kData);
  for (const char* name : {"povray/head.inc", "povray/light_moon.inc", "openscad/bust.scad"})
    EXPECT_FALSE(find_template(stock.templates, name).text.empty()) << name;
  try {
    find_template(stock.templates, "povray/nothing.inc");
    FAIL();
  } catch (const RunError& error) {
    EXPECT_STREQ(error.what(), "templates/povray/nothing.inc is missing");
  }
}

}  // namespace
}  // namespace mien

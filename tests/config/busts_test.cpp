// A set of busts says of all of them what a list says of one.
#include <fmt/format.h>

#include "config/config_fixture.hpp"

namespace mien {
namespace {

TEST(busts, of_a_set_take_its_strength_and_exaggeration) {
  const Spec plain = load_text("mien: 1\nbusts: {all: mien}\n");
  const Spec weak = load_text("mien: 1\nbusts: {all: mien, strength: 0.5, exaggerate: 1.5}\n");
  const Spec one = load_text("mien: 1\nbusts: [{express: smile, strength: 0.5, exaggerate: 1.5}]\n");
  const Spec file = load_text("mien: 1\nexaggerate: 1.5\nbusts: {all: mien, strength: 0.5}\n");
  ASSERT_EQ(weak.busts.size(), plain.busts.size());
  for (std::size_t i = 0; i < weak.busts.size(); ++i) {
    EXPECT_EQ(file.busts[i].expression.pose, weak.busts[i].expression.pose);
    if (weak.busts[i].expression.name != "smile") continue;
    EXPECT_EQ(weak.busts[i].expression.pose, one.busts[0].expression.pose);
    EXPECT_NE(weak.busts[i].expression.pose, plain.busts[i].expression.pose);
    EXPECT_EQ(plain.busts[i].expression.pose, find_expression(plain, "smile").pose);
  }
}

Names list_names(const Spec& spec) {
  Names names;
  for (const BustSpec& bust : spec.busts)
    names.push_back(fmt::format("{}/{}: {}", bust.expression.library, bust.expression.name, bust.label));
  return names;
}

TEST(busts, of_a_set_may_be_chosen) {
  const Spec spec = load_text(
      "mien: 1\nexpressions: {sly: {from: smile}}\n"
      "busts: {all: [smile, tezuka/doubt_left, sly], height: 60mm, strength: 0.5, plate: 220x220mm}\n");
  EXPECT_EQ(list_names(spec), (Names{"mien/smile: smile", "tezuka/doubt_left: doubt L", "/sly: sly"}));
  EXPECT_EQ(spec.plate_mm, glm::dvec2(220));
  const Spec one = load_text("mien: 1\nbusts: [{express: smile, strength: 0.5}]\n");
  EXPECT_EQ(spec.busts[0].expression.pose, one.busts[0].expression.pose);
  EXPECT_EQ(spec.busts[0].height_mm, 60);
}

BustSpec build_asked(const std::string& busts, const std::string& name = "smile") {
  const Spec spec = load_text("mien: 1\nbusts: " + busts + "\n");
  const BustSpec asked = build_asked_bust(spec, take_expression(spec, name));
  EXPECT_EQ(asked.expression.pose, find_expression(spec, name).pose);
  return asked;
}

TEST(busts, an_asked_one_is_printed_as_the_files_own_of_that_expression) {
  const BustSpec asked = build_asked(
      "[{express: laugh, height: 30mm}, {express: smile, strength: 0.5, height: 60mm, base: plinth, label: "
      "Ha, "
      "hollow: true, wall: 3mm, drain: 5mm, magnet: 6x2mm, triangles: 9000}]");
  EXPECT_EQ(asked.height_mm, 60);
  EXPECT_EQ(asked.base, "plinth");
  EXPECT_EQ(asked.label, "Ha");
  EXPECT_TRUE(asked.is_hollow);
  EXPECT_EQ(asked.wall_mm, 3);
  EXPECT_EQ(asked.drain_mm, 5);
  EXPECT_EQ(asked.magnet_mm, glm::dvec2(6, 2));
  EXPECT_EQ(asked.triangles, 9000);
  EXPECT_EQ(build_asked("[{express: tezuka/smile, height: 60mm}, {height: 30mm}]").height_mm,
            80);  // another smile
}

TEST(busts, an_asked_one_has_the_options_that_all_others_share) {
  const BustSpec asked = build_asked(
      "[{express: laugh, height: 60mm, hollow: true, wall: 3mm}, {express: anger, height: 60mm, hollow: "
      "true, "
      "base: plinth}]");
  EXPECT_EQ(asked.height_mm, 60);
  EXPECT_TRUE(asked.is_hollow);
  EXPECT_EQ(asked.wall_mm, 2);
  EXPECT_EQ(asked.base, "round");
  EXPECT_EQ(asked.label, "");
  const BustSpec of_a_set =
      build_asked("{all: tezuka, height: 40mm, base: plinth, magnet: 6x2mm, drain: 3mm}");
  EXPECT_EQ(of_a_set.height_mm, 40);
  EXPECT_EQ(of_a_set.base, "plinth");
  EXPECT_EQ(of_a_set.magnet_mm, glm::dvec2(6, 2));
  EXPECT_EQ(of_a_set.drain_mm, 3);
  const Spec none = load_text("mien: 1\n");
  EXPECT_EQ(build_asked_bust(none, find_expression(none, "smile")).height_mm, BustSpec{}.height_mm);
}

TEST(busts, an_asked_one_bears_its_own_name_where_all_bear_labels) {
  EXPECT_EQ(build_asked("{all: tezuka}", "tezuka/doubt_left").label, "doubt L");  // the set's own
  EXPECT_EQ(build_asked("{all: tezuka}", "emfacs/contempt_left").label, "contempt L");
  EXPECT_EQ(build_asked("{all: tezuka, label: Anna}").label, "Anna");
  EXPECT_EQ(build_asked("{all: tezuka, base: none}").label, "");
  EXPECT_EQ(build_asked("[{express: laugh, label: Ha}]").label, "smile");
  EXPECT_EQ(build_asked("[{express: laugh, label: Ha}, {express: anger, label: Grr}]").label, "smile");
  EXPECT_EQ(build_asked("[{express: laugh, label: Ha}, {express: anger}]").label, "");
}

}  // namespace
}  // namespace mien

// A set of busts says of all of them what a list says of one.
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

}  // namespace
}  // namespace mien

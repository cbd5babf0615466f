// A head that grows in a clip: its keys to the last bit, and nothing that jumps between them.
#include <gtest/gtest.h>

#include "clip/scenes.hpp"
#include "config/config_fixture.hpp"
#include "head/form.hpp"
#include "shipped.hpp"
#include "timeline/head_track.hpp"

namespace mien {
namespace {

constexpr const char* kGrowth = R"(mien: 1
head: {age: infant, features: {ear_size: 0.5}}
clip:
  head:
    - {at: 0s}
    - {at: 1s, age: child, guides: {eye_line: 0.42}}
    - {at: 2s, age: adult, skull: {square: 0.5, round: 0.5}, guides: {brow_line: 0.6, eye_line: 0.5}}
)";

std::vector<HeadKey> load_heads() { return load_text(kGrowth).clip.head; }

TEST(growth, a_keys_mesh_is_that_of_its_head_alone_to_the_last_bit) {
  const HeadSpec alone = load_text(R"(mien: 1
head:
  age: adult
  skull: {square: 0.5, round: 0.5}
  guides: {brow_line: 0.6, eye_line: 0.5}
  features: {ear_size: 0.5}
)")
                             .head;
  const Figure grown = build_figure(shipped().heads, sample_head(load_heads(), 2)),
               plain = build_figure(shipped().heads, alone);
  ASSERT_EQ(grown.model.parts.size(), plain.model.parts.size());
  for (std::size_t i = 0; i < plain.model.parts.size(); ++i) {
    EXPECT_EQ(grown.model.parts[i].rest.positions, plain.model.parts[i].rest.positions);
    EXPECT_EQ(grown.model.parts[i].rest.normals, plain.model.parts[i].rest.normals);
  }
}

TEST(growth, a_head_that_cannot_be_between_two_good_ones_is_told_before_anything_is_written) {
  Clip clip;
  clip.spec = load_text("mien: 1\nclip: {length: 1s}\n");
  clip.frame_count = count_frames(clip.spec.clip);
  clip.performance = build_performance(clip.spec.clip);
  // Each line alone is where its own age has room for it; halfway they have crossed.
  HeadKey old, young;
  old.head = load_text("mien: 1\nhead: {age: adult, guides: {eye_line: 0.55}}\n").head;
  young.head = load_text("mien: 1\nhead: {age: infant, guides: {brow_line: 0.42}}\n").head;
  young.at_s = 1;
  Actor actor{"", old.head, {}, clip.performance};
  actor.performance.clip.head = {old, young};
  clip.actors = {actor};
  try {
    build_cast(clip, shipped().heads);
    ADD_FAILURE() << "all were built";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("test.yaml: the head at 0."), std::string::npos) << message;
    EXPECT_NE(message.find("guide line 'brow_line' meets the one below it"), std::string::npos) << message;
  }
}

double find_jump_mm(const HeadForm& a, const HeadForm& b) {
  double most = glm::distance(a.eye.centre, b.eye.centre);
  for (std::size_t i = 0; i < a.points.size(); ++i)
    most = std::max(most, glm::distance(a.points[i], b.points[i]));
  return most;
}

TEST(growth, is_continuous_at_and_between_its_keys) {
  const HeadStock stock = shipped().heads;
  const std::vector<HeadKey> keys = load_heads();
  const auto form_at = [&](double time_s) { return build_form(stock, sample_head(keys, time_s)); };
  // Nearly nothing happens in a hundred thousandth of a second, beside a key as elsewhere.
  for (const double time_s : {0.0, 0.5, 1.0, 1.7, 2.0})
    EXPECT_LT(find_jump_mm(form_at(time_s), form_at(time_s + 1e-5)), 0.01) << time_s;
  EXPECT_LT(find_jump_mm(form_at(1 - 1e-5), form_at(1)), 0.01);
  EXPECT_LT(find_jump_mm(form_at(2 - 1e-5), form_at(2)), 0.01);
  // A twelfth of a second is a drawing on twos.
  HeadForm before = form_at(0);
  for (int drawing = 1; drawing <= 24; ++drawing) {
    HeadForm form = form_at(drawing / 12.0);
    EXPECT_LT(find_jump_mm(before, form), 12) << drawing;
    before = std::move(form);
  }
}

TEST(growth, is_framed_by_the_largest_head_all_through) {
  Options options;
  options.file = make_test_folder() / "growth.yaml";
  write_file(options.file, kGrowth);
  const Clip clip = plan_clip(options, *shipped().stock.language);
  const Cast cast = build_cast(clip, shipped().heads);
  ASSERT_EQ(cast.figures.size(), 1u);
  EXPECT_EQ(cast.figures.front(), nullptr) << "no single head stands for the clip";
  Framing largest;
  add_figure(build_figure(shipped().heads, compute_head(clip.actors.front(), 2)), glm::dmat4(1), largest);
  EXPECT_EQ(cast.framing.crown_mm, largest.crown_mm);
  EXPECT_EQ(cast.framing.chin_mm, largest.chin_mm);
}

}  // namespace
}  // namespace mien

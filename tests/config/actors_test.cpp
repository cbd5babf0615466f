// Several who play together, and how they wait for each other.
#include "config/config_fixture.hpp"
#include "timeline/performance.hpp"

namespace mien {
namespace {

constexpr const char* kTwo = R"(mien: 1
actors:
  ann:
    head: {age: child}
    place: {at: [-120mm, 0, 1cm], turn: 25deg}
    clip:
      keys:
        - {at: 12f, express: smile, name: hello}
        - {at: {after: bob.reply, delay: 0.25s}, express: laugh, name: end}
  bob:
    clip:
      keys:
        - {at: {after: ann.hello, delay: 6f}, express: surprise, name: reply}
      turn:
        - {at: {after: reply, delay: -0.5s}, nod: 5deg}
        - {at: {after: ann.end}, nod: 0deg}
clip:
  draw: twos
  camera: [{at: 0s}, {at: {after: ann.end, delay: 1s}, angle: 20deg, look_at: ann.nose_tip, lens: 60mm}]
  light: [{at: {after: bob.reply}, set: moon, brightness: 0.5, angle: -30deg}]
)";

TEST(actors, have_a_head_a_place_and_a_clip_each) {
  const Spec spec = load_text(kTwo);
  ASSERT_EQ(spec.actors.size(), 2u);
  const ActorSpec &ann = spec.actors[0], &bob = spec.actors[1];
  EXPECT_EQ(ann.name, "ann");
  EXPECT_EQ(ann.head.age, (Mix{{"child", 1.0}}));
  EXPECT_EQ(bob.head.age, (Mix{{"adult", 1.0}}));
  EXPECT_EQ(ann.place.at_mm, glm::dvec3(-120, 0, 10));
  EXPECT_EQ(ann.place.turn_deg, 25);
  for (const ActorSpec& actor : spec.actors) {
    EXPECT_EQ(actor.clip.draw, 2);
    EXPECT_EQ(actor.clip.length_s, spec.clip.length_s);
  }
}

TEST(actors, wait_for_each_other) {
  const Spec spec = load_text(kTwo);
  EXPECT_DOUBLE_EQ(spec.actors[0].clip.keys[0].at_s, 0.5);
  EXPECT_DOUBLE_EQ(spec.actors[1].clip.keys[0].at_s, 0.75);
  EXPECT_DOUBLE_EQ(spec.actors[0].clip.keys[1].at_s, 1);
  EXPECT_DOUBLE_EQ(spec.actors[1].clip.turn[0].at_s, 0.25);
  EXPECT_DOUBLE_EQ(spec.actors[1].clip.turn[1].at_s, 1);
  EXPECT_DOUBLE_EQ(spec.clip.light[0].at_s, 0.75);
  EXPECT_DOUBLE_EQ(spec.clip.camera[1].at_s, 2);
  EXPECT_DOUBLE_EQ(spec.clip.length_s, 2);
}

TEST(actors, share_a_camera_and_its_lights) {
  const Spec spec = load_text(kTwo);
  const CameraKey& key = spec.clip.camera[1];
  EXPECT_EQ(key.aim.kind, Aim::Kind::landmark);
  EXPECT_EQ(key.aim.actor, "ann");
  EXPECT_EQ(key.aim.landmark, "nose_tip");
  EXPECT_EQ(key.lens_mm, 60);
  EXPECT_EQ(spec.clip.light[0].set, "moon");
  EXPECT_EQ(spec.clip.light[0].brightness, 0.5);
  EXPECT_EQ(spec.clip.light[0].angle_deg, -30);
}

TEST(actors, take_heads_from_files) {
  const auto folder = make_test_folder();
  write_file(folder / "ann.yaml", "mien: 1\nhead: {age: infant}\n");
  write_file(folder / "two.yaml", "mien: 1\nactors:\n  ann: {head: ann.yaml}\n");
  EXPECT_EQ(load_spec(folder / "two.yaml", *find_language()).actors[0].head.age, (Mix{{"infant", 1.0}}));
}

TEST(actors, a_clip_alone_may_wait_for_its_own_keys) {
  const Spec spec = load_text(R"(mien: 1
clip:
  keys: [{at: 1s, express: smile, name: smiled}]
  turn: [{at: {after: smiled, delay: 500ms}, turn: 5deg}]
)");
  EXPECT_DOUBLE_EQ(spec.clip.turn[0].at_s, 1.5);
  EXPECT_TRUE(spec.actors.empty());
  EXPECT_EQ(list_actors(spec).size(), 1u);
}

TEST(actors, see_the_camera_from_where_they_stand_though_its_angle_is_a_formula) {
  const auto load = [](const std::string& angle) {
    return load_text(
        "mien: 1\nactors:\n  ann: {place: {turn: 25deg}}\nclip: {length: 2s, camera: [{at: 0s, angle: " +
        angle + "}]}\n");
  };
  const Spec spec = load("\"10 + 5*t\"");
  for (const double time_s : {0.0, 1.0, 2.0}) {
    const double shown = sample_performance(build_performance(spec.clip), time_s).camera.angle_deg;
    EXPECT_EQ(shown, 10 + 5 * time_s);
    EXPECT_EQ(sample_performance(build_performance(spec.actors[0].clip), time_s).camera.angle_deg,
              shown - 25);
  }
}

}  // namespace
}  // namespace mien

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "drawn_subject.hpp"
#include "head/cage.hpp"

namespace mien {
namespace {

constexpr glm::dvec3 kBeside_mm{900, -40, 80}, kBefore_mm{0, 0, 900};

const Subject& child() {
  static const Subject subject = build_of_age("child");
  return subject;
}

const Subject& infant() {
  static const Subject subject = build_of_age("infant");
  return subject;
}

TEST(ink_profile, lips_and_the_bridge_of_the_nose_have_an_outline) {
  const auto measure = [](const Subject& subject, const char* name, const glm::dvec3& camera_mm) {
    return measure_outline_mm(subject, name, 3, {camera_mm, {0, 0.6, 0.8}, 1});
  };
  for (const char* name : {"M3_0", "M3_12", "p_b1"}) {
    EXPECT_GT(measure(child(), name, kBeside_mm), 0.4) << name;
    EXPECT_GT(measure(comic(), name, kBeside_mm), 0.4) << name;
  }
  for (const char* name : {"M3_0", "M3_12"}) EXPECT_LT(measure(comic(), name, kBefore_mm), 0.2) << name;
}

TEST(ink_profile, the_crease_of_the_lid_is_of_the_front) {
  const auto measure = [](const glm::dvec3& camera_mm) {
    return measure_width(
        find_stroke(comic(), draw(comic(), Pose{}, TurnKey{}, {camera_mm, {0, 0, 1}, 1}), "crease"));
  };
  EXPECT_GT(measure(kBefore_mm), 0.5);
  EXPECT_LT(measure(kBeside_mm), 0.05);
}

// A shade there would be a blotch behind the corner of the mouth.
TEST(ink_profile, a_cheek_is_light_beside_the_mouth_that_laughs) {
  constexpr double kTerminator = 0.12;  // as materials_drawn.inc has it: cosine
  const glm::dvec3 to_light = glm::normalize(glm::dvec3(0.8, 0.6, 0));
  const Drawing drawing = draw(child(), make_pose({{"corner.up", 1}, {"corner.out", 1}, {"chin.down", 0.4}}),
                               TurnKey{}, {kBeside_mm, to_light, 1});
  for (const char* name : {"M2_6", "M4_6", "M5_6", "M6_6", "M5_7", "M6_7", "E2_4", "E3_4", "q12_C2"})
    EXPECT_GT(glm::dot(glm::dvec3(drawing.parts.front().normals[find_point(child().figure.head.cage, name)]),
                       to_light),
              kTerminator)
        << name;
}

TEST(ink_profile, folds_that_are_seen_along_are_not_drawn) {
  const Subject old = build_of_age("old");
  const auto count = [&](const glm::dvec3& camera_mm) {  // rings of folds on the far side that can be seen
    const Drawing drawing = draw(old, Pose{}, TurnKey{}, {camera_mm, {0, 0, 1}, 1});
    const std::vector<glm::vec3>& p = drawing.parts[find_part(old.ink.model, "lines")].positions;
    std::size_t first = 0, wide = 0;
    for (const InkStroke& stroke : old.ink.strokes) {
      if (stroke.rule.is_brow || stroke.rule.is_on_hair) continue;
      if (stroke.fold && stroke.side < 0)
        for (std::size_t ring = first; ring < first + kStrokeVertices; ring += kStrokeSpokes)
          wide += glm::distance(p[ring], p[ring + kStrokeSpokes / 2]) > 0.2 ? 1 : 0;
      first += kStrokeVertices;
    }
    return wide;
  };
  EXPECT_GT(count(kBefore_mm), 100U);
  EXPECT_LT(count(kBeside_mm), 10U);
}

TEST(ink_profile, lips_that_meet_have_one_line) {
  const auto measure = [](double jaw) {
    const Pose pose = make_pose({{"chin.down", jaw}});
    return measure_width(
        find_stroke(comic(), draw(comic(), pose, TurnKey{}, {kBefore_mm, {0, 0, 1}, 1}), "lower_lip"));
  };
  EXPECT_LT(measure(0), 0.05);
  EXPECT_GT(measure(0.6), 0.8);
}

TEST(ink_profile, a_button_of_a_nose_casts_no_shadow) {
  const auto casts = [](const Subject& subject, float reach_mm) {
    const Part& caster = subject.ink.model.parts[find_part(subject.ink.model, "shadow")];
    const std::vector<glm::vec3>& skin = subject.figure.model.parts.front().rest.positions;
    const glm::vec3 tip = skin[find_point(subject.figure.head.cage, "p_tip")];
    return std::ranges::any_of(caster.rest.triangles,
                               [&](const Triangle& t) { return glm::distance(skin[t[0]], tip) < reach_mm; });
  };
  EXPECT_TRUE(casts(comic(), 4));
  EXPECT_FALSE(casts(child(), 4));
  EXPECT_FALSE(casts(build_subject(make_spec("manga")), 9));  // next to no nose
}

// The eye's depth: from the front of its ball to the outer corner of the lids.
TEST(ink_profile, eyes_are_drawn_out_and_lids_stay_on_them) {
  struct Eye {
    float deep_mm = 0, off_mm = 1e9f, iris_mm = 0;
  };
  const auto measure = [](const glm::dvec3& camera_mm) {
    const Drawing drawing = draw(comic(), Pose{}, TurnKey{}, {camera_mm, {0, 0, 1}, 1});
    const glm::vec3 corner = drawing.parts.front().positions[find_point(comic().figure.head.cage, "E1_8")];
    Eye eye;
    for (const glm::vec3& p : drawing.parts[find_part(comic().ink.model, "eye_left")].positions) {
      eye.deep_mm = std::max(eye.deep_mm, p.z - corner.z);
      eye.off_mm = std::min(eye.off_mm, glm::distance(p, corner));
    }
    const Box iris = compute_bounds(drawing.parts[find_part(comic().ink.model, "iris_left")].positions);
    eye.iris_mm = iris.high.z - iris.low.z;
    return eye;
  };
  const Eye before = measure(kBefore_mm), beside = measure(kBeside_mm);
  EXPECT_GT(beside.deep_mm, 1.4f * before.deep_mm);
  EXPECT_GT(beside.iris_mm, 1.05f * before.iris_mm);
  EXPECT_LT(beside.iris_mm, 1.25f * before.iris_mm);  // or no white is left behind it
  EXPECT_LT(beside.off_mm, before.off_mm + 0.5f);
}

// Else an open mouth would be a notch; what is in the middle of the face is its outline and stays.
TEST(ink_profile, mouths_are_drawn_out_and_no_tooth_comes_through) {
  const Pose open = make_pose({{"chin.down", 0.8}, {"corner.out", -0.6}});
  const Cage& cage = comic().figure.head.cage;
  const auto find_z = [&](const Drawing& drawing, const char* name) {
    return drawing.parts.front().positions[find_point(cage, name)].z;
  };
  const auto measure_deep_mm = [&](const Drawing& drawing) {
    return find_z(drawing, "M1_0") - find_z(drawing, "M1_6");
  };
  const Drawing before = draw(comic(), open, TurnKey{}, {kBefore_mm, {0, 0, 1}, 1}),
                beside = draw(comic(), open, TurnKey{}, {kBeside_mm, {0, 0, 1}, 1});
  EXPECT_GT(measure_deep_mm(beside), 1.4f * measure_deep_mm(before));
  for (const char* name : {"M1_0", "M3_0", "M1_12", "M4_12", "p_tip"})
    EXPECT_EQ(find_z(beside, name), find_z(before, name)) << name;
  const float cheek_mm = beside.parts.front().positions[find_point(cage, "M5_6")].x;
  const PartShape& teeth = beside.parts[comic().ink.teeth];
  const Mesh& rest = comic().ink.model.parts[comic().ink.teeth].rest;
  for (std::size_t v = 0; v < rest.positions.size(); ++v) {
    const glm::vec3 p = teeth.positions.empty()
                            ? glm::vec3(teeth.world_from_rest * glm::vec4(rest.positions[v], 1))
                            : teeth.positions[v];
    EXPECT_LT(std::abs(p.x), cheek_mm);
  }
}

TEST(ink_profile, from_before_eyes_are_as_they_are) {
  DeformBuffers buffers;
  Drawing plain;
  deform_figure(comic().figure, Pose{}, TurnKey{}, buffers, plain);
  const Drawing drawing = draw(comic(), Pose{}, TurnKey{}, {kBefore_mm, {0, 0, 1}, 1});
  const std::size_t white = find_part(comic().ink.model, "eye_left");
  EXPECT_EQ(drawing.parts[white].positions, plain.parts[white].positions);
}

// Nearer to the skin, what casts its shadow would leave chips of it at lids and cheek; in thin ears it
// would come out on the other side.
TEST(ink_profile, what_casts_lies_deeper_but_in_ears) {
  const auto measure_mm = [](const char* name, const glm::dvec3& camera_mm) {
    const std::uint32_t point = find_point(comic().figure.head.cage, name);
    const Drawing drawing = draw(comic(), Pose{}, TurnKey{}, {camera_mm, {0, 0, 1}, 1});
    return glm::distance(drawing.parts[comic().ink.caster].positions[point],
                         drawing.parts.front().positions[point]) /
           comic().ink.eye_size;
  };
  EXPECT_NEAR(measure_mm("s1_C1", kBefore_mm), 3.5f, 0.05f);
  EXPECT_NEAR(measure_mm("s1_C1", kBeside_mm), 5.0f, 0.05f);
  EXPECT_NEAR(measure_mm("M5_6", kBefore_mm), 3.5f, 0.05f);
  EXPECT_NEAR(measure_mm("M5_6", kBeside_mm), 9.0f, 0.05f);  // a cheek in a laugh
  EXPECT_NEAR(measure_mm("er6_4", kBeside_mm), 0.9f, 0.05f);
}

// From the mouth's walls it would come through the cheeks.
TEST(ink_profile, the_inside_of_the_mouth_casts_no_shadow) {
  const Part& caster = comic().ink.model.parts[comic().ink.caster];
  const std::uint32_t wall = find_point(comic().figure.head.cage, "MB2_6");
  for (const Triangle& t : caster.rest.triangles) EXPECT_TRUE(t[0] != wall && t[1] != wall && t[2] != wall);
}

TEST(ink_profile, the_line_of_full_lips_that_meet_lies_before_them) {
  const Drawing drawing = draw(infant(), make_pose({{"corner.up", -0.8}, {"lips.press", 0.4}}), TurnKey{},
                               {kBefore_mm, {0, 0, 1}, 1});
  float line_mm = -1e9f;
  for (const glm::vec3& p : find_stroke(infant(), drawing, "upper_lip"))
    if (std::abs(p.x) < 1) line_mm = std::max(line_mm, p.z);
  for (const char* name : {"M2_0", "M2_12"})
    EXPECT_GT(line_mm, drawing.parts.front().positions[find_point(infant().figure.head.cage, name)].z)
        << name;
}

TEST(ink_profile, the_line_of_lips_that_meet_lies_on_their_slit) {
  const Drawing drawing =
      draw(infant(), make_pose({{"corner.up", -0.8}, {"lips.press", 0.4}, {"chin.up", 0.8}}), TurnKey{},
           {kBefore_mm, {0, 0, 1}, 1});
  const auto find_height = [](const glm::vec3& p) {  // in the picture, at the head's distance
    return static_cast<float>(kBefore_mm.z) * p.y / (static_cast<float>(kBefore_mm.z) - p.z);
  };
  const auto find_slit = [&](const char* name) {
    return find_height(drawing.parts.front().positions[find_point(infant().figure.head.cage, name)]);
  };
  float low = 1e9f, high = -1e9f;
  for (const glm::vec3& p : find_stroke(infant(), drawing, "upper_lip"))
    if (std::abs(p.x) < 1) {
      low = std::min(low, find_height(p));
      high = std::max(high, find_height(p));
    }
  EXPECT_LT(low, find_slit("M1_12"));
  EXPECT_GT(high, find_slit("M1_0"));
}

TEST(ink_profile, lobes_have_an_outline) {
  HeadSpec spec = make_spec("comic");
  spec.hair = "crop";
  const Subject subject = build_subject(spec);
  EXPECT_GT(measure_outline_mm(subject, "er6_8", 3, {kBefore_mm, {0, 0.6, 0.8}, 1}), 0.4);
}

// Else a blotch lies there: the walls of the mouth, which look anywhere, say nothing of the lips' tones.
TEST(ink_profile, the_lit_corner_of_a_smile_has_no_shade) {
  constexpr double kTerminator = 0.12;
  const glm::dvec3 to_light = glm::normalize(glm::dvec3(-0.46, 0.6, 0.66));
  const Drawing drawing = draw(infant(), make_pose({{"corner.up", 0.7}, {"corner.out", 0.5}}), TurnKey{},
                               {kBefore_mm, to_light, 1});
  const Cage& cage = infant().figure.head.cage;
  for (const char* name : {"M2_6", "M2_7", "M3_6", "M3_7"})
    EXPECT_GT(
        glm::dot(glm::dvec3(drawing.parts.front().normals[cage.mirror[find_point(cage, name)]]), to_light),
        kTerminator)
        << name;
}

TEST(ink_profile, cheekbones_have_no_dashes_from_below) {
  const Pose laugh =
      make_pose({{"corner.up", 1}, {"corner.out", 0.9}, {"lid.lower", 0.9}, {"chin.down", 0.5}});
  const InkView below{{0, -450, 780}, {0, 0.6, 0.8}, 1};
  for (const char* name : {"E5_10", "s1_L10", "s1_C1"})
    EXPECT_LT(measure_outline_mm(infant(), name, 4, below, laugh), 0.1) << name;
}

InkView view_turned(double turn_deg) {
  const double turn = glm::radians(turn_deg);
  return {{900 * std::sin(turn), -60, 900 * std::cos(turn)}, {0, 0.6, 0.8}, 1};
}

// Ticks about the holes else, or a nose without an edge against the ground.
TEST(ink_profile, nostrils_have_an_outline_where_the_nose_does) {
  const auto measure = [](double turn_deg) {
    double most = 0;
    for (const char* name : {"nr_0", "nr_2", "nr_4", "nr_6", "R:nr_0", "R:nr_2", "R:nr_4", "R:nr_6"})
      most = std::max(most, measure_outline_mm(comic(), name, 2, view_turned(turn_deg)));
    return most;
  };
  for (const double turn_deg : {-35, -20, 0, 20, 35}) EXPECT_LT(measure(turn_deg), 0.1) << turn_deg;
  for (const double turn_deg : {-55, 55}) EXPECT_GT(measure(turn_deg), 0.2) << turn_deg;
}

TEST(ink_profile, far_lips_have_an_outline_where_they_stand_before_the_ground) {
  const Pose round = make_pose({{"chin.down", 0.5}, {"corner.out", -0.8}});
  const auto measure = [&](const char* name, double turn_deg) {
    return measure_outline_mm(child(), name, 3, view_turned(turn_deg), round);
  };
  for (const char* name : {"R:M3_2", "R:M2_9", "R:M2_10"}) {
    EXPECT_GT(measure(name, 50), 0.3) << name;
    EXPECT_LT(measure(name, 35), 0.1) << name;
    EXPECT_LT(measure(name, 0), 0.1) << name;
  }
}

TEST(ink_profile, throats_have_an_outline) {
  EXPECT_GT(measure_outline_mm(infant(), "m12_N1", 3, {kBeside_mm, {0, 0.6, 0.8}, 1}), 0.4);
}

TEST(ink_profile, the_thin_line_below_an_old_eye_is_of_the_front) {
  const Subject old = build_of_age("old");
  const auto measure = [&](const glm::dvec3& camera_mm) {
    return measure_width(
        find_stroke(old, draw(old, Pose{}, TurnKey{}, {camera_mm, {0, 0, 1}, 1}), "lower_lid"));
  };
  EXPECT_GT(measure(kBefore_mm), 0.2);
  EXPECT_LT(measure(kBeside_mm), 0.05);
}

// A cheek's pad would stand before the half of its blush.
TEST(ink_profile, the_blush_of_a_laugh_is_seen_whole) {
  const Pose laugh = make_pose(
      {{"corner.up", 1}, {"corner.out", 0.9}, {"chin.down", 0.5}, {"lid.lower", 0.95}, {"lips.upper", 0.5}});
  for (const Subject* subject : {&child(), &infant()}) {
    const auto find_depth_mm = [&](const glm::dvec3& camera_mm) {
      const Drawing drawing = draw(*subject, laugh, TurnKey{}, {camera_mm, {0, 0, 1}, 1});
      const std::vector<glm::vec3>& p = drawing.parts.front().positions;
      float sum_mm = 0, count = 0;
      for (std::size_t v = 0; v < subject->ink.flush_places.size(); ++v) {
        if (subject->ink.flush_places[v].z < 0.999f || p[v].x < 0) continue;
        sum_mm += p[v].z;
        ++count;
      }
      return sum_mm / count;
    };
    EXPECT_LT(find_depth_mm(kBeside_mm), find_depth_mm(kBefore_mm) - 6 * subject->ink.eye_size);
  }
}

// Toward the nose as it does toward the ear.
TEST(ink_profile, a_blush_pales_on_all_sides) {
  constexpr std::size_t kSteps = 10, kRed = 7;  // of the blush, before the plain skin in its palette
  const Pose laugh = make_pose(
      {{"corner.up", 1}, {"corner.out", 0.9}, {"chin.down", 0.5}, {"lid.lower", 0.95}, {"lips.upper", 0.5}});
  for (const Subject* subject : {&child(), &infant()}) {
    const Part& skin = subject->ink.model.parts.front();
    const Drawing drawing = draw(*subject, laugh, TurnKey{}, {kBeside_mm, {0, 0, 1}, 1});
    const std::vector<glm::vec3>& p = drawing.parts.front().positions;
    const std::vector<glm::vec3> faced =
        draw(*subject, laugh, TurnKey{}, {kBefore_mm, {0, 0, 1}, 1}).parts.front().positions;
    float back = 1e9f, front = -1e9f, red_back = 1e9f, red_front = -1e9f;
    float low = 1e9f, red_low = 1e9f, low_before = 1e9f, red_low_before = 1e9f;
    for (std::size_t i = 0; i < skin.rest.triangles.size(); ++i) {
      const std::size_t from_last = skin.palette.size() - 1 - skin.triangle_shade[i];
      if (from_last < 1 || from_last > kSteps) continue;
      for (int k = 0; k < 3; ++k) {
        const glm::vec3& at = p[skin.rest.triangles[i][k]];
        if (at.x < 0) continue;
        const float before = faced[skin.rest.triangles[i][k]].y;
        low = std::min(low, at.y);
        low_before = std::min(low_before, before);
        back = std::min(back, at.z);
        front = std::max(front, at.z);
        if (from_last < kRed) continue;
        red_low = std::min(red_low, at.y);
        red_low_before = std::min(red_low_before, before);
        red_back = std::min(red_back, at.z);
        red_front = std::max(red_front, at.z);
      }
    }
    EXPECT_GT(front - red_front, 0.5f * (red_back - back));
    // Nor is its lower edge flat, where the mouth is drawn to a wedge.
    EXPECT_GT(red_low - low, 0.5f * (red_low_before - low_before));
  }
}

TEST(ink_profile, an_open_mouth_ends_in_a_wedge) {
  const Pose open = make_pose({{"chin.down", 0.8}, {"corner.up", 0.6}});
  const auto measure_high_mm = [&](const glm::dvec3& camera_mm) {
    const Drawing drawing = draw(infant(), open, TurnKey{}, {camera_mm, {0, 0, 1}, 1});
    const auto find_y = [&](const char* name) {
      return drawing.parts.front().positions[find_point(infant().figure.head.cage, name)].y;
    };
    return find_y("M1_5") - find_y("M1_7");
  };
  EXPECT_LT(measure_high_mm(kBeside_mm), 0.5f * measure_high_mm(kBefore_mm));
}

// Else the cheek's pad would stand before the upper half of its blush.
TEST(ink_profile, cheeks_lie_farther_back_seen_from_below) {
  const auto draw_from = [](const glm::dvec3& camera_mm) {
    return draw(infant(), Pose{}, TurnKey{}, {camera_mm, {0, 0, 1}, 1}).parts.front().positions;
  };
  const std::vector<glm::vec3> before = draw_from(kBefore_mm), below = draw_from({0, -500, 800});
  float most_mm = 0;
  for (std::size_t v = 0; v < before.size(); ++v) {
    most_mm = std::max(most_mm, before[v].z - below[v].z);
    EXPECT_EQ(before[v].x, below[v].x);
  }
  EXPECT_NEAR(most_mm, 9 * infant().ink.eye_size, 1);
  const Cage& cage = infant().figure.head.cage;
  for (const char* name : {"E1_4", "E1_12", "p_tip", "M1_0", "M1_6", "M6_11"})
    EXPECT_NEAR(glm::distance(before[find_point(cage, name)], below[find_point(cage, name)]), 0, 0.3) << name;
}

// A sliver of it would stand between nose and lip.
TEST(ink_profile, a_far_cheek_lies_farther_back) {
  const auto draw_at = [](const Pose& pose, const glm::dvec3& camera_mm) {
    return draw(infant(), pose, TurnKey{}, {camera_mm, {0, 0, 1}, 1}).parts.front().positions;
  };
  const auto measure_mm = [&](const Pose& pose, bool is_far) {
    const std::vector<glm::vec3> before = draw_at(pose, kBefore_mm), turned = draw_at(pose, {-700, 0, 570});
    float most_mm = 0;
    for (std::size_t v = 0; v < before.size(); ++v)
      if ((before[v].x > 0) == is_far && infant().ink.lower_cheek[v] > 0)
        most_mm = std::max(most_mm, before[v].z - turned[v].z);
    return most_mm / infant().ink.eye_size;
  };
  EXPECT_NEAR(measure_mm({}, true), 9, 1);
  EXPECT_NEAR(measure_mm(make_pose({{"corner.up", 1}}), true), 4.5, 1.5);
  EXPECT_LT(measure_mm({}, false), 0.1);
}

// Its edge would cut the blush on the side of the shade, or leave a lobe of light about it.
TEST(ink_profile, from_below_cheeks_are_lit_and_what_looks_down_is_not) {
  constexpr float kShade = 0.12f;  // cosine at the border of the two tones
  const glm::dvec3 to_light = glm::normalize(glm::dvec3(-0.55, 0.55, 0.63));
  const Pose laugh =
      make_pose({{"corner.up", 1}, {"corner.out", 0.9}, {"chin.down", 0.5}, {"lid.lower", 0.95}});
  for (const Subject* subject : {&child(), &infant(), &comic()}) {
    const Drawing drawing = draw(*subject, laugh, TurnKey{}, {{0, -450, 780}, to_light, 1});
    const PartShape& skin = drawing.parts.front();
    const auto is_lit = [&](std::size_t v) {
      return glm::dot(skin.normals[v], glm::vec3(to_light)) > kShade;
    };
    const glm::vec3 cheek = skin.positions[find_point(subject->figure.head.cage, "q12_C4")];
    glm::ivec2 lit(0);  // and all
    for (std::size_t v = 0; v < subject->ink.folded.size(); ++v)
      if (glm::distance(skin.positions[v], cheek) < 22 * subject->ink.eye_size)
        lit += glm::ivec2(is_lit(v), 1);
    EXPECT_GT(lit.x, 0.9f * static_cast<float>(lit.y)) << lit.x << " of " << lit.y;
    EXPECT_GT(lit.y, 20);
    EXPECT_FALSE(is_lit(find_point(subject->figure.head.cage, "m12_N1")));
  }
}

// But a grown face keeps its shade.
TEST(ink_profile, from_before_a_blush_is_lit) {
  constexpr float kShade = 0.12f;  // cosine at the border of the two tones
  const glm::dvec3 to_light = glm::normalize(glm::dvec3(-0.55, 0.55, 0.63));
  const Pose smile = make_pose({{"corner.up", 1}, {"corner.out", 0.6}});
  const auto find_lit = [&](const Subject& subject, const auto& is_asked) {
    const Drawing drawing = draw(subject, smile, TurnKey{}, {kBefore_mm, to_light, 1});
    const PartShape& skin = drawing.parts.front();
    glm::ivec2 lit(0);  // and all
    for (std::size_t v = 0; v < subject.ink.folded.size(); ++v)
      if (is_asked(v, skin.positions))
        lit += glm::ivec2(glm::dot(skin.normals[v], glm::vec3(to_light)) > kShade, 1);
    return static_cast<float>(lit.x) / static_cast<float>(lit.y);
  };
  for (const Subject* subject : {&child(), &infant()})
    EXPECT_GT(
        find_lit(*subject, [&](std::size_t v, const auto&) { return subject->ink.flush_places[v].z > 0.5f; }),
        0.93f);
  const std::uint32_t tip = find_point(comic().figure.head.cage, "p_tip");
  EXPECT_LT(find_lit(comic(), [&](std::size_t v, const auto& p) { return glm::distance(p[v], p[tip]) < 18; }),
            0.96f);
}

// Scratches before the eye, a second line beside the brow's, a piece of a smile.
TEST(ink_profile, folds_are_of_the_front_but_the_forehead) {
  const Pose pose = make_pose(
      {{"lips.upper", 1}, {"brow.up", -1}, {"brow.out", -1}, {"corner.up", 1}, {"corner.out", 0.9}});
  for (const char* fold : {"nose", "frown", "cheek"}) {
    const auto measure_mm = [&](const glm::dvec3& camera_mm) {
      return measure_width(
          find_stroke(comic(), draw(comic(), pose, TurnKey{}, {camera_mm, {0, 0, 1}, 1}), fold));
    };
    EXPECT_GT(measure_mm(kBefore_mm), 0.3) << fold;
    EXPECT_LT(measure_mm(kBeside_mm), 0.05) << fold;
  }
}

// A cheek that laughs would stand before half of it, and the wedge of the mouth would square it.
TEST(ink_profile, a_blush_is_as_round_in_a_laugh_as_at_rest) {
  const auto measure = [](const Subject& subject, const Pose& pose) {
    const Drawing drawing = draw(subject, pose, TurnKey{}, {kBeside_mm, {0, 0, 1}, 1});
    const std::vector<glm::vec3>& p = drawing.parts.front().positions;
    glm::vec3 low(1e9f), high(-1e9f);
    for (std::size_t v = 0; v < subject.ink.flush_places.size(); ++v) {
      if (subject.ink.flush_places[v].z < 0.999f || p[v].x < 0) continue;
      low = glm::min(low, p[v]);
      high = glm::max(high, p[v]);
    }
    return high - low;
  };
  const Pose laugh = make_pose(
      {{"corner.up", 1}, {"corner.out", 0.9}, {"chin.down", 0.5}, {"lid.lower", 0.95}, {"lips.upper", 0.5}});
  for (const Subject* subject : {&child(), &infant()}) {
    const glm::vec3 rest = measure(*subject, {}), laughing = measure(*subject, laugh);
    EXPECT_NEAR(laughing.y / rest.y, 1, 0.05);
    EXPECT_NEAR(laughing.z / rest.z, 1, 0.05);
    EXPECT_GT(rest.z, 1.2f * rest.y);
  }
}

// Skin that goes back with a blush would lie behind the ball of the eye.
TEST(ink_profile, no_ball_comes_through_the_cheek) {
  const std::array faces{
      Pose{}, make_pose({{"corner.up", 1}, {"corner.out", 0.9}}),
      make_pose({{"corner.up", 1}, {"lips.upper", 1}, {"lid.lower", 1}}),
      make_pose({{"corner.up", 1}, {"corner.out", 0.9}, {"chin.down", 0.5}, {"lid.lower", 0.95}}),
      make_pose({{"lips.upper", 1}, {"brow.up", -1}, {"corner.up", -0.6}})};
  const auto turn = [](const glm::vec3& a, const glm::vec3& b, const glm::vec3& at) {
    return (b.z - a.z) * (at.y - a.y) - (b.y - a.y) * (at.z - a.z);
  };
  // Of the points of the ball that a triangle of the cheek stands before or behind: how many it does.
  const auto count = [&](const Subject& subject, const Pose& face) {
    const Drawing drawing = draw(subject, face, TurnKey{}, {kBeside_mm, {0, 0, 1}, 1});
    const std::vector<glm::vec3>&p = drawing.parts.front().positions,
          &ball = drawing.parts[subject.ink.whites[0]].positions;
    std::array<std::size_t, 2> found{};
    for (const Triangle& t : subject.figure.folds.skin.triangles) {
      const glm::vec3 &a = p[t[0]], &b = p[t[1]], &c = p[t[2]];
      if (subject.ink.flush_places[t[0]].z == 0 || a.x < 0) continue;
      for (const glm::vec3& at : ball) {
        const float u = turn(b, c, at), v = turn(c, a, at), w = turn(a, b, at), all = u + v + w;
        if (std::min({u * all, v * all, w * all}) > 0)
          ++found[at.x > (u * a.x + v * b.x + w * c.x) / all ? 1 : 0];
      }
    }
    return found;
  };
  for (const Subject* subject : {&child(), &infant()})
    for (std::size_t face = 0; face < faces.size(); ++face) {
      const auto [behind, before] = count(*subject, faces[face]);
      EXPECT_EQ(before, 0U) << face << ": " << behind << " behind";
      if (face > 0 && face < 4) {
        EXPECT_GT(behind, 10U) << face;
      }
    }
}

// A caret between the eyes.
TEST(ink_profile, a_button_of_a_nose_has_no_outline_from_below) {
  const InkView below{{0, -500, 800}, {0, 0.6, 0.8}, 1}, turned{{690, 0, 580}, {0, 0.6, 0.8}, 1};
  EXPECT_LT(measure_outline_mm(infant(), "p_tip", 12, below), 0.05);
  EXPECT_GT(measure_outline_mm(infant(), "p_tip", 12, turned), 0.3);
}

// The nose would cast a chip beside its nostril.
TEST(ink_profile, what_casts_lies_as_deep_from_below_as_in_profile) {
  const auto measure_mm = [](const glm::dvec3& camera_mm) {
    const Drawing drawing = draw(comic(), Pose{}, TurnKey{}, {camera_mm, {0, 0, 1}, 1});
    const std::uint32_t v = find_point(comic().figure.head.cage, "q12_C4");
    return glm::distance(drawing.parts[comic().ink.caster].positions[v], drawing.parts.front().positions[v]);
  };
  EXPECT_GT(measure_mm({0, -500, 800}), measure_mm(kBefore_mm) + 1);
}

// Its ends would turn up beside the chin, as those of a moustache.
TEST(ink_profile, a_chin_has_its_line_from_below_and_the_jaw_beside_it_none) {
  const auto measure_mm = [](const glm::dvec3& camera_mm) {
    const Box box = compute_bounds(
        find_stroke(comic(), draw(comic(), Pose{}, TurnKey{}, {camera_mm, {0, 0, 1}, 1}), "jaw"));
    return box.high.x - box.low.x;
  };
  const float below_mm = measure_mm({0, -500, 800}), before_mm = measure_mm(kBefore_mm);
  EXPECT_LT(below_mm, 0.75f * before_mm);
  EXPECT_GT(below_mm, 0.3f * before_mm);
}

// What is left of an iris would be lost between them.
TEST(ink_profile, lashes_of_an_eye_that_is_nearly_shut_are_thin) {
  const Pose narrow = make_pose({{"lid.upper", -0.5}, {"lid.lower", 0.5}});
  for (const char* lashes : {"upper_lashes", "lower_lashes"}) {
    const auto measure_mm = [&](const Pose& pose, const glm::dvec3& camera_mm) {
      return measure_width(
          find_stroke(child(), draw(child(), pose, TurnKey{}, {camera_mm, {0, 0, 1}, 1}), lashes));
    };
    EXPECT_LT(measure_mm(narrow, kBeside_mm), 0.75f * measure_mm(Pose{}, kBeside_mm)) << lashes;
    EXPECT_NEAR(measure_mm(narrow, kBefore_mm), measure_mm(Pose{}, kBefore_mm), 0.1) << lashes;
  }
}

TEST(ink_profile, an_eye_that_is_nearly_shut_opens_a_little_and_one_that_is_shut_does_not) {
  const auto measure_gap_mm = [](double upper, double lower, const glm::dvec3& camera_mm) {
    const Pose pose = make_pose({{"lid.upper", upper}, {"lid.lower", lower}});
    const Drawing drawing = draw(child(), pose, TurnKey{}, {camera_mm, {0, 0, 1}, 1});
    const auto [above, below] = child().ink.lids[0];
    const std::vector<glm::vec3>& p = drawing.parts.front().positions;
    return p[above].y - p[below].y;
  };
  EXPECT_GT(measure_gap_mm(-0.5, 0.5, kBeside_mm), measure_gap_mm(-0.5, 0.5, kBefore_mm) + 1.5f);
  for (const double upper : {-1.0, 0.0})
    EXPECT_NEAR(measure_gap_mm(upper, 0, kBeside_mm), measure_gap_mm(upper, 0, kBefore_mm), 0.1) << upper;
}

// It would hang between chin and ear, tied to neither.
TEST(ink_profile, the_jaw_has_no_line) {
  for (const double open : {0.0, 1.0}) {
    const Pose pose = make_pose({{"chin.down", open}});
    const auto measure_mm = [&](const glm::dvec3& camera_mm) {
      return measure_width(
          find_stroke(comic(), draw(comic(), pose, TurnKey{}, {camera_mm, {0, 0, 1}, 1}), "jaw"));
    };
    EXPECT_LT(measure_mm(kBeside_mm), 0.05) << open;
    EXPECT_GT(measure_mm(kBefore_mm), 0.3) << open;
  }
}

// It would be a stub above the corner, which is lifted.
TEST(ink_profile, the_fold_beside_the_nose_is_not_drawn_from_below_nor_behind_the_nose) {
  const Pose laugh = make_pose({{"corner.up", 1}, {"corner.out", 0.9}});
  const auto measure_mm = [&](const glm::dvec3& camera_mm) {
    return measure_width(
        find_stroke(comic(), draw(comic(), laugh, TurnKey{}, {camera_mm, {0, 0, 1}, 1}), "cheek"));
  };
  EXPECT_GT(measure_mm(kBefore_mm), 0.3);
  EXPECT_LT(measure_mm({0, -500, 800}), 0.05);
  EXPECT_GT(measure_mm({500, 0, 800}), 0.3);
  EXPECT_LT(measure_mm({-500, 0, 800}), 0.05);
}

}  // namespace
}  // namespace mien

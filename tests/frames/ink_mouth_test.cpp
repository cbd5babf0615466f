#include "frames/ink_mouth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawn_subject.hpp"
#include "frames/ink_parts.hpp"
#include "head/cage.hpp"

namespace mien {
namespace {

constexpr InkView kBefore{{0, 0, 900}, {0, 0, 1}, 1}, kBeside{{900, -40, 80}, {0, 0, 1}, 1};
constexpr InkView kQuarter{{600, 0, 700}, {0, 0, 1}, 1};  // from the head's left
constexpr InkView kFarther{{760, 0, 580}, {0, 0, 1}, 1};
constexpr InkView kBelow{{0, -500, 800}, {0, 0, 1}, 1};

const Subject& infant() {
  static const Subject subject = build_of_age("infant");
  return subject;
}

glm::vec3 find_place(const Subject& subject, const Drawing& drawing, const char* name, bool is_image) {
  const Cage& cage = subject.figure.head.cage;
  const std::uint32_t point = find_point(cage, name);
  return drawing.parts.front().positions[is_image ? cage.mirror[point] : point];
}

// Or it would be cut off square.
TEST(ink_mouth, the_far_corner_of_a_laugh_is_round) {
  const Pose laugh = make_pose({{"corner.up", 1}, {"corner.out", 0.9}, {"chin.down", 0.5}});
  const Drawing before = draw(infant(), laugh, TurnKey{}, kBefore),
                quarter = draw(infant(), laugh, TurnKey{}, kQuarter);
  const auto measure_high_mm = [&](const Drawing& drawing, bool is_right) {
    return find_place(infant(), drawing, "M1_5", is_right).y -
           find_place(infant(), drawing, "M1_8", is_right).y;
  };
  EXPECT_LT(measure_high_mm(quarter, true), 0.7f * measure_high_mm(before, true));
  EXPECT_EQ(measure_high_mm(quarter, false), measure_high_mm(before, false));
  EXPECT_LT(find_place(infant(), quarter, "M1_6", true).y, find_place(infant(), before, "M1_6", true).y - 1);
  for (const char* name : {"M1_0", "M1_12", "p_tip", "M4_0"})
    EXPECT_EQ(find_place(infant(), quarter, name, false), find_place(infant(), before, name, false)) << name;
}

// A cheek that came along would have a fold in its outline.
TEST(ink_mouth, cheeks_are_not_drawn_together_with_the_far_corner) {
  const Pose laugh = make_pose({{"corner.up", 1}, {"corner.out", 0.9}, {"chin.down", 0.5}});
  const std::vector<glm::vec3> before = draw(infant(), laugh, TurnKey{}, kBefore).parts.front().positions,
                               quarter = draw(infant(), laugh, TurnKey{}, kQuarter).parts.front().positions;
  const glm::vec3 corner = before[infant().ink.corners[1]];
  const Mesh& skin = infant().figure.head.skin;
  float least = 1;
  for (const Triangle& t : skin.triangles)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      const float high_mm = std::abs(before[a].y - before[b].y);
      if (std::max(before[a].x, before[b].x) > corner.x ||
          high_mm < 0.8f * glm::distance(before[a], before[b]))
        continue;
      if (std::min(before[a].y, before[b].y) < corner.y + 2) continue;
      least = std::min(least, std::abs(quarter[a].y - quarter[b].y) / high_mm);
    }
  EXPECT_GT(least, 0.9f);
}

TEST(ink_mouth, a_real_mouth_stays_as_it_is) {
  const Subject man = build_subject(HeadSpec{});
  const Pose laugh = make_pose({{"corner.up", 1}, {"corner.out", 0.9}, {"chin.down", 0.5}});
  const Drawing before = draw(man, laugh, TurnKey{}, kBefore);
  for (const InkView& view : {kQuarter, kBelow})
    EXPECT_TRUE(draw(man, laugh, TurnKey{}, view).parts.front().positions == before.parts.front().positions);
}

// As the camera sees the lips' edge: how far each of its points lies from the middle, of half its width and
// height.
std::vector<float> measure_edge(const Subject& subject, const Drawing& drawing, const InkView& view) {
  const std::vector<glm::vec3>& skin = drawing.parts.front().positions;
  const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), glm::vec3(view.camera_mm)));
  std::vector<glm::vec2> places;
  glm::vec2 low(1e9f), high(-1e9f);
  for (const std::uint32_t v : subject.ink.mouth_ring) {
    places.emplace_back(glm::dot(skin[v], right), skin[v].y);
    low = glm::min(low, places.back());
    high = glm::max(high, places.back());
  }
  std::vector<float> lengths;
  for (const glm::vec2& place : places)
    lengths.push_back(glm::length((place - 0.5f * (low + high)) / (0.5f * (high - low))));
  return lengths;
}

// Lips that go round the teeth would be a kite or a heart, seen aslant.
TEST(ink_mouth, a_round_mouth_stays_round) {
  const Pose round = make_pose({{"corner.out", -0.65}, {"chin.down", 1}});
  for (const Subject* subject : {&comic(), &infant()})
    for (const InkView& view : {kQuarter, kFarther}) {
      const std::vector<float> lengths = measure_edge(*subject, draw(*subject, round, TurnKey{}, view), view);
      EXPECT_GT(*std::min_element(lengths.begin(), lengths.end()), 0.88f) << view.camera_mm.x;
      EXPECT_LT(*std::max_element(lengths.begin(), lengths.end()), 1.12f) << view.camera_mm.x;
    }
  // Its far corner comes forward, or it would be a heart; farther round it would stand before the lips, but
  // it makes no nick in the outline. Rounding moves across the view alone.
  const auto measure_forth_mm = [&](const InkView& view) {
    const glm::vec3 way = find_place(comic(), draw(comic(), round, TurnKey{}, view), "M1_6", true) -
                          find_place(comic(), draw(comic(), round, TurnKey{}, kBefore), "M1_6", true);
    const glm::vec3 to_camera = glm::normalize(glm::vec3(view.camera_mm));
    return glm::dot(way, to_camera) / to_camera.z;
  };
  EXPECT_GT(measure_forth_mm(kQuarter), 3 * comic().ink.eye_size + 2);
  EXPECT_NEAR(measure_forth_mm(kFarther), 3 * comic().ink.eye_size, 0.3);
  // A smile is none.
  const std::vector<float> smile = measure_edge(
      comic(), draw(comic(), make_pose({{"corner.up", 0.8}, {"chin.down", 0.4}}), TurnKey{}, kQuarter),
      kQuarter);
  EXPECT_LT(*std::min_element(smile.begin(), smile.end()), 0.7f);
}

// Straight ones would be a beak.
TEST(ink_mouth, the_lower_lip_of_an_open_mouth_bows_in_profile) {
  const Drawing beside =
      draw(infant(), make_pose({{"chin.down", 0.8}, {"corner.out", -0.3}}), TurnKey{}, kBeside);
  const glm::vec3 middle = find_place(infant(), beside, "M1_12", false),
                  between = find_place(infant(), beside, "M1_9", false),
                  corner = find_place(infant(), beside, "M1_6", false);
  const float share = (between.z - middle.z) / (corner.z - middle.z);
  EXPECT_LT(between.y, glm::mix(middle.y, corner.y, share) - 0.2f);
}

// Or a smile would be a frown from below.
TEST(ink_mouth, the_corners_of_a_smile_are_lifted_from_below) {
  const Pose smile = make_pose({{"corner.up", 0.8}});
  const glm::vec3 up_of_view = glm::normalize(glm::cross(glm::vec3(kBelow.camera_mm), glm::vec3(1, 0, 0)));
  const auto measure_high_mm = [&](const Pose& pose, const InkView& view) {
    const Drawing drawing = draw(infant(), pose, TurnKey{}, view);
    const std::vector<glm::vec3>& p = drawing.parts.front().positions;
    const glm::vec3 lips = 0.5f * (p[infant().ink.lips[0]] + p[infant().ink.lips[1]]);
    EXPECT_NEAR(p[infant().ink.corners[0]].y, p[infant().ink.corners[1]].y, 1e-3);
    return glm::dot(p[infant().ink.corners[0]] - lips, up_of_view);
  };
  EXPECT_LT(measure_high_mm(smile, kBefore), -1);
  EXPECT_GT(measure_high_mm(smile, kBelow), 0);
  EXPECT_EQ(measure_high_mm(Pose{}, kBelow), measure_high_mm(Pose{}, kBefore));
}

// Else a strip of lip is seen inside the line of the far one.
TEST(ink_mouth, the_dark_comes_near_to_the_line_of_the_lips) {
  const Part& skin = infant().ink.model.parts.front();
  const std::vector<glm::vec3>& p = skin.rest.positions;
  const auto find_colour = [&](const glm::vec3& place) {
    const auto find_away = [&](std::size_t i) {
      const Triangle& t = skin.rest.triangles[i];
      return glm::distance(place, (p[t[0]] + p[t[1]] + p[t[2]]) / 3.0f);
    };
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < skin.rest.triangles.size(); ++i)
      if (find_away(i) < find_away(nearest)) nearest = i;
    return skin.palette[skin.triangle_shade[nearest]].srgb;
  };
  const auto mix = [&](const char* inner, const char* outer, float share) {
    const Cage& cage = infant().figure.head.cage;
    return glm::mix(p[find_point(cage, inner)], p[find_point(cage, outer)], share);
  };
  EXPECT_EQ(find_colour(mix("M0_3", "M1_3", 0.6f)), InkColours{}.cavity);
  EXPECT_EQ(find_colour(mix("M0_9", "M1_9", 0.6f)), InkColours{}.cavity);
  EXPECT_NE(find_colour(mix("M1_9", "M2_9", 0.6f)), InkColours{}.cavity);
}

// Fangs from below else; their ends are hidden behind the lip.
TEST(ink_mouth, the_row_of_teeth_comes_to_points) {
  std::vector<glm::vec3> row;  // an arch, as deep as half its width
  for (int i = -10; i <= 10; ++i) {
    const float z = -0.1f * static_cast<float>(i * i);
    row.insert(row.end(), {{i + 3, 5, z}, {i + 3, -4, z}});
  }
  std::vector<glm::vec3> hidden = row;
  constexpr float kOver_mm = 3;
  taper_row(glm::mat3(1), kOver_mm, hidden);
  taper_row(glm::mat3(1), 0, row);
  const auto measure_deep = [&](int i) { return 5 - row[2 * static_cast<std::size_t>(i + 10) + 1].y; };
  for (int i = 0; i <= 10; ++i) {
    EXPECT_EQ(row[2 * static_cast<std::size_t>(i + 10)].y, 5) << i;
    for (const std::size_t v :
         {2 * static_cast<std::size_t>(i + 10), 2 * static_cast<std::size_t>(i + 10) + 1})
      EXPECT_NEAR(hidden[v].y, row[v].y + kOver_mm * (1 - measure_deep(i) / 9), 1e-5) << i;
    EXPECT_FLOAT_EQ(measure_deep(i), measure_deep(-i)) << i;
    EXPECT_LE(measure_deep(i), measure_deep(std::max(i - 1, 0))) << i;
  }
  EXPECT_EQ(measure_deep(3), 9);
  EXPECT_LT(measure_deep(6), 7);
  EXPECT_EQ(measure_deep(8), 0);
  const Ink& ink = comic().ink;
  for (const std::size_t part : {ink.teeth, ink.gum}) {
    const Box box = compute_bounds(ink.model.parts[part].rest.positions);
    EXPECT_GT(box.high.y, ink.teeth_top_mm + 2) << part;
  }
}

// Or the dark would end on the ground; its front is bowed in, and teeth stand behind it.
TEST(ink_mouth, an_open_mouth_has_a_line_in_profile) {
  const Pose open = make_pose({{"chin.down", 0.6}, {"lips.upper", 0.4}});
  const auto find_edge = [&](const Pose& pose, const InkView& view) {
    return draw(comic(), pose, TurnKey{}, view).parts[comic().ink.mouth_edge].positions;
  };
  const std::vector<glm::vec3> edge = find_edge(open, kBeside);
  EXPECT_EQ(edge.size(), kStrokeVertices);
  EXPECT_GT(glm::distance(edge[0], edge[kStrokeSpokes / 2]), 0.5f);
  const glm::vec3 &first = edge.front(), &middle = edge[edge.size() / 2], &last = edge.back();
  EXPECT_LT(middle.z, 0.5f * (first.z + last.z) - 1);
  const auto measure_mm = [](const std::vector<glm::vec3>& points) {
    const Box box = compute_bounds(points);
    return glm::length(box.high - box.low);
  };
  EXPECT_GT(measure_mm(edge), 8);
  EXPECT_LT(measure_mm(find_edge(open, kBefore)), 0.01);
  EXPECT_LT(measure_mm(find_edge(make_pose({{"chin.down", 0.1}}), kBeside)), 5);
  const Drawing drawing = draw(comic(), open, TurnKey{}, kBeside);
  const std::vector<glm::vec3>& sheet = drawing.parts[comic().ink.sheet].positions;
  const std::vector<glm::vec3>& strip = drawing.parts[comic().ink.tooth_strip].positions;
  for (const glm::vec3& tooth : strip)
    for (std::size_t row = 0; row < kSheetRows; ++row)
      EXPECT_FALSE(std::abs(sheet[row].y - tooth.y) < 0.5f && tooth.z > sheet[row].z + 0.5f);
}

TEST(ink_mouth, a_mouth_that_opens_a_little_shows_no_tongue) {
  const auto measure_mm = [](double jaw) {
    const Pose pose = make_pose({{"chin.down", jaw}});
    DeformBuffers buffers;
    Drawing plain;
    deform_figure(comic().figure, pose, TurnKey{}, buffers, plain);
    const std::size_t tongue = find_part(comic().ink.model, "tongue");
    const auto find_top_mm = [](const PartShape& shape) {
      if (shape.positions.empty()) return shape.world_from_rest[3].y;
      return std::ranges::max_element(shape.positions, {}, &glm::vec3::y)->y;
    };
    return (find_top_mm(plain.parts[tongue]) -
            find_top_mm(draw(comic(), pose, TurnKey{}, {}).parts[tongue])) /
           comic().ink.teeth_high_mm;
  };
  EXPECT_GT(measure_mm(0.25), 0.6);
  EXPECT_LT(measure_mm(1), 0.5);
}

// It would be a strip of dark below the lip.
TEST(ink_mouth, what_closes_the_slit_is_gone_where_lips_part) {
  const auto measure_mm = [](double jaw) {
    const Drawing drawing = draw(comic(), make_pose({{"chin.down", jaw}}), TurnKey{}, kBefore);
    const Box box = compute_bounds(drawing.parts[comic().ink.veil].positions);
    return glm::length(box.high - box.low);
  };
  EXPECT_GT(measure_mm(0), 10);
  EXPECT_LT(measure_mm(0.7), 0.01);
}

// From before the row hangs where it is; from the side a strip is as low.
TEST(ink_mouth, teeth_are_a_strip) {
  const Pose open = make_pose({{"chin.down", 0.6}, {"lips.upper", 0.4}});
  const std::vector<glm::vec3>& rest = comic().ink.model.parts[comic().ink.teeth].rest.positions;
  const auto find_teeth = [&](const Drawing& drawing) {
    const PartShape& teeth = drawing.parts[comic().ink.teeth];
    std::vector<glm::vec3> places = teeth.positions;
    if (places.empty())
      for (const glm::vec3& p : rest) places.emplace_back(teeth.world_from_rest * glm::vec4(p, 1));
    return compute_bounds(places);
  };
  const Drawing before = draw(comic(), open, TurnKey{}, kBefore),
                beside = draw(comic(), open, TurnKey{}, kBeside);
  const std::vector<glm::vec3>& strip = beside.parts[comic().ink.tooth_strip].positions;
  EXPECT_NEAR(strip[strip.size() / 2].y, find_teeth(before).low.y, 0.5f);  // the lower one of the middle
  EXPECT_LT(glm::length(find_teeth(beside).high - find_teeth(beside).low), 2.0f);
  const std::vector<glm::vec3>& none = before.parts[comic().ink.tooth_strip].positions;
  for (std::size_t v = 0; v < none.size(); v += 2) EXPECT_EQ(none[v], none[v + 1]) << v;
}

// Its mouth would be an empty wedge.
TEST(ink_mouth, a_toothless_laugh_has_a_tongue_in_profile) {
  const Subject infant = build_of_age("infant");
  const auto measure_share = [&](const InkView& view, double jaw) {
    const Drawing drawing =
        draw(infant, make_pose({{"chin.down", jaw}, {"corner.up", 0.8}}), TurnKey{}, view);
    const std::vector<glm::vec3>& strip = drawing.parts[infant.ink.tooth_strip].positions;
    float high_mm = 0;
    for (std::size_t v = 0; v < strip.size(); v += 2)
      high_mm = std::max(high_mm, glm::distance(strip[v], strip[v + 1]));
    const std::vector<glm::vec3>& skin = drawing.parts.front().positions;
    return high_mm / glm::distance(skin[infant.ink.lips[0]], skin[infant.ink.lips[1]]);
  };
  EXPECT_NEAR(measure_share(kBeside, 0.9), 0.45f, 0.06f);
  EXPECT_LT(measure_share(kBeside, 0.2), 0.01f);
  EXPECT_EQ(measure_share(kBefore, 0.9), 0);
}

// Nor is it an empty hole from below and aslant: there the tongue is highest in the middle.
TEST(ink_mouth, a_toothless_laugh_has_a_tongue_from_below_and_aslant) {
  const Subject infant = build_of_age("infant");
  for (const glm::dvec3& camera_mm : {glm::dvec3(0, -450, 780), glm::dvec3(-516, 0, 737)}) {
    const Drawing drawing = draw(infant, make_pose({{"chin.down", 0.9}, {"corner.up", 0.8}}), TurnKey{},
                                 {camera_mm, {0, 0, 1}, 1});
    const std::vector<glm::vec3>& strip = drawing.parts[infant.ink.tooth_strip].positions;
    const std::vector<glm::vec3>& skin = drawing.parts.front().positions;
    const float gap_mm = glm::distance(skin[infant.ink.lips[0]], skin[infant.ink.lips[1]]);
    const auto measure_mm = [&](std::size_t place) {
      return glm::distance(strip[2 * place], strip[2 * place + 1]);
    };
    const std::size_t middle = infant.ink.strip_points.size() / 2;
    EXPECT_NEAR(measure_mm(middle) / gap_mm, 0.45f, 0.06f) << camera_mm.x;
    for (std::size_t place = 1; place <= middle; ++place)
      EXPECT_GE(measure_mm(place) + 1e-3f, measure_mm(place - 1)) << camera_mm.x << ' ' << place;
  }
}

// What shows of the lips before it would be crumbs; an open mouth's ends behind them.
TEST(ink_mouth, a_slit_is_dark_to_the_edge_of_the_lips) {
  const auto measure_mm = [](double jaw) {
    const Drawing drawing = draw(comic(), make_pose({{"chin.down", jaw}}), TurnKey{}, kBeside);
    const glm::vec3 lip = drawing.parts.front().positions[comic().ink.lips[0]];
    return glm::distance(drawing.parts[comic().ink.sheet].positions[0], lip);
  };
  EXPECT_LT(measure_mm(0.15), 0.5f);
  EXPECT_GT(measure_mm(0.8), 1.0f);
}

}  // namespace
}  // namespace mien

#include "frames/ink.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "core/conventions.hpp"
#include "drawn_subject.hpp"
#include "frames/drawn_gaze.hpp"
#include "frames/ink_strokes.hpp"
#include "head/cage.hpp"
#include "head/landmarks.hpp"
#include "poses.hpp"
#include "scene/povray.hpp"
#include "shipped.hpp"
#include "timeline/head_turn.hpp"

namespace mien {
namespace {

TEST(ink, regions_meet_on_crisp_borders) {
  HeadSpec spec = make_spec("comic");
  spec.hair = "crop";  // which hides no ears
  const Subject subject = build_subject(spec);
  const Ink& ink = subject.ink;
  const Part& skin = ink.model.parts.front();
  ASSERT_EQ(skin.triangle_shade.size(), skin.rest.triangles.size());
  EXPECT_GT(ink.cuts.size(), 200U);
  std::set<std::uint16_t> used(skin.triangle_shade.begin(), skin.triangle_shade.end());
  EXPECT_EQ(used.size(), 6U) << "all but a beard and a blush, which a grown comic has not";
  // Cutting leaves the surface whole: each edge of two triangles runs once each way.
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const Triangle& t : skin.rest.triangles)
    for (int i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
  std::size_t open = 0, open_before = 0;
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    open += edges.contains({edge.second, edge.first}) ? 0 : 1;
  }
  std::set<std::pair<std::uint32_t, std::uint32_t>> before;
  for (const Triangle& t : subject.figure.folds.skin.triangles)
    for (int i = 0; i < 3; ++i) before.insert({t[i], t[(i + 1) % 3]});
  for (const auto& edge : before) open_before += before.contains({edge.second, edge.first}) ? 0 : 1;
  EXPECT_EQ(open, open_before);
}

// How much of the skin has each colour of the palette, mm2; the plain skin's is the last one.
std::vector<double> measure_regions(const Ink& ink) {
  const Part& skin = ink.model.parts.front();
  std::vector<double> areas(skin.palette.size());
  for (std::size_t i = 0; i < skin.rest.triangles.size(); ++i) {
    const auto [a, b, c] = skin.rest.triangles[i];
    const std::vector<glm::vec3>& p = skin.rest.positions;
    areas[skin.triangle_shade[i]] +=
        0.5 * static_cast<double>(glm::length(glm::cross(p[b] - p[a], p[c] - p[a])));
  }
  return areas;
}

TEST(ink, hair_and_beard_that_are_painted_have_regions) {
  HeadSpec spec = make_spec("comic");
  spec.hair = "none";
  const std::vector<double> bald = measure_regions(build_subject(spec).ink);
  spec.hair = "buzz";
  spec.look.beard = "stubble";
  const std::vector<double> shorn = measure_regions(build_subject(spec).ink);
  std::vector<double> gained(shorn.size());
  for (std::size_t i = 0; i < shorn.size(); ++i) gained[i] = shorn[i] - bald[i];
  std::ranges::sort(gained, std::greater{});
  EXPECT_GT(gained[0], 20000) << "the scalp of a shorn head";
  EXPECT_GT(gained[1], 5000) << "jaw, chin and upper lip";
  EXPECT_LE(gained[2], 0);
}

// A beard grows on a grown man, however short a design makes his face.
TEST(ink, a_drawn_man_has_a_beard_and_a_drawn_child_has_none) {
  for (const char* design : {"real", "comic", "manga", "caricature"}) {
    HeadSpec spec = make_spec(design);
    spec.hair = "none";
    spec.look.beard = "short";
    const auto has_beard = [](const Figure& figure) {
      return std::ranges::any_of(figure.model.parts, [](const Part& part) { return part.name == "beard"; });
    };
    EXPECT_TRUE(has_beard(build_figure(shipped().heads, spec, FigureUse::ink))) << design;
    spec.age = {{"child", 1.0}};
    EXPECT_FALSE(has_beard(build_figure(shipped().heads, spec, FigureUse::ink))) << design;
  }
}

TEST(ink, the_iris_has_a_bright_lower_part_that_ends_on_straight_edges) {
  const Subject& subject = comic();
  const auto measure = [&](const char* part) {
    return compute_bounds(subject.ink.model.parts[find_part(subject.ink.model, part)].rest.positions);
  };
  const Box upper = measure("iris_left"), lower = measure("iris_low_left");
  const auto height = static_cast<double>(upper.high.y - lower.low.y);
  EXPECT_LT(static_cast<double>(lower.high.y), static_cast<double>(upper.low.y) + 0.15 * height);
  EXPECT_GT(static_cast<double>(lower.high.y - lower.low.y), 0.3 * height);
}

TEST(ink, landmarks_find_the_pupil_that_looks_about) {
  for (const char* design : {"real", "comic"}) {
    const Figure figure = build_figure(shipped().heads, make_spec(design), FigureUse::ink);
    const std::vector<Landmark> landmarks = find_landmarks(figure.head);
    DeformBuffers buffers;
    const auto find_pupil = [&](const Pose& pose) {
      Drawing drawing;
      deform_figure(figure, pose, TurnKey{}, buffers, drawing);
      return measure_landmarks(figure.head, landmarks, figure.model, drawing).at("pupil_l");
    };
    const glm::dvec3 rest = find_pupil(Pose{}), up = find_pupil(make_pose({{"eye.up", 1}}));
    EXPECT_GT(up.y - rest.y, 2) << design;
    EXPECT_NEAR(up.x, rest.x, 1) << design;
  }
}

TEST(ink, the_rest_is_drawn_as_it_stands) {
  for (const char* design : {"real", "comic"}) {
    const Figure figure = build_figure(shipped().heads, make_spec(design), FigureUse::ink);
    DeformBuffers buffers;
    buffers.has_folds = false;
    Drawing drawing;
    deform_figure(figure, Pose{}, TurnKey{}, buffers, drawing);
    for (std::size_t i = 0; i < figure.model.parts.size(); ++i) {
      const Part& part = figure.model.parts[i];
      if (part.is_rigid) continue;
      ASSERT_EQ(drawing.parts[i].positions.size(), part.rest.positions.size()) << part.name;
      for (std::size_t v = 0; v < part.rest.positions.size(); ++v)
        ASSERT_LT(glm::distance(drawing.parts[i].positions[v], part.rest.positions[v]), 1e-4f) << part.name;
    }
  }
}

TEST(ink, outlines_of_the_skin_are_what_faces_away) {
  const Subject& subject = comic();
  const InkView view{{300, 40, 850}, glm::normalize(glm::dvec3(-1, 1, 1)), 1};
  const Drawing drawing = draw(subject, make_pose({{"brow.up", 1}}), TurnKey{}, view);
  const PartShape& outline = drawing.parts[find_part(subject.ink.model, "skin_outline")];
  EXPECT_GT(outline.triangles.size(), 1000U);
  for (const Triangle& t : outline.triangles) {
    const glm::vec3 &a = outline.positions[t[0]], &b = outline.positions[t[1]], &c = outline.positions[t[2]];
    EXPECT_GT(glm::dot(a - glm::vec3(view.camera_mm), glm::cross(b - a, c - a)), 0);
  }
}

TEST(ink, outlines_of_hair_are_all_of_it_behind_it_and_a_line_larger) {
  const Subject& subject = comic();
  const InkView view{{300, 40, 850}, glm::normalize(glm::dvec3(-1, 1, 1)), 1.5};
  const Drawing drawing = draw(subject, make_pose({{"brow.up", 1}}), TurnKey{}, view);
  const std::size_t part = find_part(subject.ink.model, "hair_mass");
  const PartShape &hair = drawing.parts[part],
                  &outline = drawing.parts[find_part(subject.ink.model, "hair_mass_outline")];
  EXPECT_EQ(outline.triangles, subject.ink.model.parts[part].rest.triangles);
  ASSERT_EQ(outline.positions.size(), hair.positions.size());
  for (std::size_t v = 0; v < hair.positions.size(); v += 7) {
    const glm::vec3 way = glm::normalize(hair.positions[v] - glm::vec3(view.camera_mm)),
                    moved = outline.positions[v] - hair.positions[v];
    EXPECT_GT(glm::dot(moved, way), 12);
    EXPECT_NEAR(glm::length(moved - glm::dot(moved, way) * way), view.line_mm, 0.02);
  }
}

// Locks lie over each other: one shade goes over all of them.
TEST(ink, hair_is_as_light_as_it_is_high) {
  const Subject& subject = comic();
  const Drawing drawing = draw(subject, Pose{}, TurnKey{}, InkView{});
  const PartShape& hair = drawing.parts[find_part(subject.ink.model, "hair_mass")];
  std::vector<std::pair<float, float>> front;  // height, how far up it looks
  for (std::size_t v = 0; v < hair.positions.size(); ++v)
    if (std::abs(hair.positions[v].x) < 4 && hair.positions[v].z > 20)
      front.emplace_back(hair.positions[v].y, hair.normals[v].y);
  ASSERT_GT(front.size(), 20U);
  std::ranges::sort(front);
  for (std::size_t i = 1; i < front.size(); ++i)
    EXPECT_GT(front[i].second, front[i - 1].second - 0.03f) << front[i].first;
}

// POV-Ray turns a normal round that looks away: low locks would shine as the crown does.
TEST(ink, hair_looks_toward_the_camera_wherever_it_stands) {
  const Subject& subject = comic();
  const std::size_t part = find_part(subject.ink.model, "hair_mass");
  for (const glm::dvec3& camera : {glm::dvec3(0, 0, 900), {900, 50, 0}, {-600, -200, 600}}) {
    const Drawing drawing = draw(subject, Pose{}, TurnKey{}, {camera, {0, 0, 1}, 1});
    const PartShape& hair = drawing.parts[part];
    for (std::size_t v = 0; v < hair.positions.size(); ++v) {
      ASSERT_LT(glm::dot(hair.normals[v], hair.positions[v] - glm::vec3(camera)), 0) << v;
      ASSERT_NEAR(glm::length(hair.normals[v]), 1, 1e-4f) << v;
    }
  }
}

// Where a camera sees a point: aside and up against how far it is, and how far.
glm::vec3 see(const InkView& view, const glm::vec3& p) {
  const glm::vec3 arm = p - glm::vec3(view.camera_mm);
  return {arm.x / -arm.z, arm.y / -arm.z, glm::length(arm)};
}

// What brows do to the forehead is behind the fringe, where there is one: its skin, its lines and the brows.
TEST(ink, a_fringe_lies_before_the_forehead_and_its_lines) {
  constexpr float kNear = 0.0025f;  // 2 mm at the head
  for (const char* design : {"comic", "manga"})
    for (const char* age : {"child", "adult"}) {
      HeadSpec spec = make_spec(design);
      spec.age = {{age, 1.0}};
      const Subject subject = build_subject(spec);
      const InkView view{{0, 0, 900}, {0, 0, 1}, 1};
      const Drawing drawing = draw(subject, make_pose({{"brow.up", 1}}), TurnKey{}, view);
      const Part& mass = subject.ink.model.parts[find_part(subject.ink.model, "hair_mass")];
      std::vector<glm::vec3> fringe;
      for (std::size_t v = 0; v < mass.rest.positions.size(); ++v) {
        const glm::vec3& p = drawing.parts[find_part(subject.ink.model, "hair_mass")].positions[v];
        const glm::vec3& normal = mass.rest.normals[v];
        if (normal.z > 0.5f && std::abs(p.x) < 60 && p.z > 40) fringe.push_back(see(view, p));
      }
      ASSERT_GT(fringe.size(), 300u) << design << ' ' << age;
      std::size_t met = 0;
      for (const char* name : {"lines", "brow_strokes"})
        for (const glm::vec3& p : drawing.parts[find_part(subject.ink.model, name)].positions) {
          const glm::vec3 line = see(view, p);
          for (const glm::vec3& hair : fringe)
            if (std::hypot(hair.x - line.x, hair.y - line.y) < kNear) {
              ++met;
              EXPECT_LT(hair.z, line.z) << design << ' ' << age << ' ' << name;
            }
        }
      EXPECT_GT(met, 50u) << design << ' ' << age << ": lines run under it";
    }
}

// Whatever is drawn near to it, hair is seen where it is: the way to its own place is the way to its drawn
// one.
TEST(ink, a_fringe_is_seen_where_it_hangs) {
  const Subject& subject = comic();
  const InkView view{{250, 30, 850}, {0, 0, 1}, 1};
  DeformBuffers buffers;
  Drawing plain;
  deform_figure(subject.figure, Pose{}, TurnKey{}, buffers, plain);
  const std::size_t part = find_part(subject.ink.model, "hair_mass");
  const Drawing drawing = draw(subject, Pose{}, TurnKey{}, view);
  const float lip = plain.parts.front().positions[subject.ink.lips[1]].y;
  float most_mm = 0;
  for (std::size_t v = 0; v < plain.parts[part].positions.size(); ++v) {
    const glm::vec3& p = plain.parts[part].positions[v];
    if (p.y < lip && p.x < 0) continue;  // a far lock is tucked behind the chin
    const glm::vec3 before = see(view, plain.parts[part].positions[v]),
                    after = see(view, drawing.parts[part].positions[v]);
    ASSERT_NEAR(before.x, after.x, 1e-4f);
    ASSERT_NEAR(before.y, after.y, 1e-4f);
    most_mm = std::max(most_mm, before.z - after.z);
    ASSERT_GT(before.z - after.z, -0.01f);
  }
  EXPECT_NEAR(most_mm, 21, 1);
}

TEST(ink, a_fringe_stays_where_it_is_while_brows_rise) {
  const Subject subject = build_subject(make_spec("real"));  // which does not stretch
  const Drawing rest = draw(subject, Pose{}, TurnKey{}, InkView{}),
                raised = draw(subject, make_pose({{"brow.up", 1}}), TurnKey{}, InkView{});
  EXPECT_NE(rest.parts.front().positions, raised.parts.front().positions);
  const std::size_t part = find_part(subject.ink.model, "hair_mass");
  EXPECT_EQ(rest.parts[part].positions, raised.parts[part].positions);
}

// Hair that covers ears covers all of them: nothing of their skin, their outline or their lines is left.
TEST(ink, hair_over_ears_hides_them) {
  HeadSpec spec = make_spec("comic");
  const auto count = [](const Subject& subject, const char* name) {
    const Part& skin = subject.ink.model.parts.front();
    const glm::vec3 at = skin.rest.positions[find_point(subject.figure.head.cage, name)];
    return std::ranges::count_if(skin.rest.triangles, [&](const Triangle& t) {
      return glm::distance(skin.rest.positions[t[0]], at) < 2;
    });
  };
  const auto has_ear_lines = [](const Subject& subject) {
    return std::ranges::any_of(subject.ink.strokes, [](const InkStroke& stroke) {
      return std::string_view(stroke.rule.name).starts_with("ear_");
    });
  };
  EXPECT_EQ(count(comic(), "er7_4"), 0);
  EXPECT_FALSE(has_ear_lines(comic()));
  EXPECT_GT(count(comic(), "q12_C4"), 0);
  spec.hair = "crop";
  const Subject cropped = build_subject(spec);
  EXPECT_GT(count(cropped, "er7_4"), 0);
  EXPECT_TRUE(has_ear_lines(cropped));
}

// Lines on hair are as broad as the view says where they face it, and run out where hair turns away.
TEST(ink, lines_of_hair_are_seen_alike_and_run_out_where_it_turns_away) {
  const Subject& subject = comic();
  const std::size_t part = find_part(subject.ink.model, "hair_lines");
  const auto measure = [&](const InkView& view) {
    const Drawing drawing = draw(subject, Pose{}, TurnKey{}, view);
    const std::vector<glm::vec3>& p = drawing.parts[part].positions;
    EXPECT_EQ(p.size(), subject.ink.model.parts[part].rest.positions.size());
    std::vector<float> widths;
    for (std::size_t v = 0; v + 1 < p.size(); v += 2) widths.push_back(glm::distance(p[v], p[v + 1]));
    return widths;
  };
  const std::vector<float> one = measure({{0, 0, 900}, {0, 0, 1}, 0.5}),
                           other = measure({{0, 0, 900}, {0, 0, 1}, 1});
  float most = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_NEAR(other[i], 2 * one[i], 0.01f);
    most = std::max(most, other[i]);
  }
  EXPECT_GT(most, 1.2f);
  EXPECT_LT(most, 2.0f);
  EXPECT_GT(std::ranges::count_if(other, [](float w) { return w == 0; }), 100) << "those at the back";
}

TEST(ink, creases_lie_on_the_skin_all_their_way) {
  const Subject& subject = comic();
  const Mesh& skin = subject.figure.model.parts.front().rest;
  std::size_t count = 0;
  for (const InkStroke& stroke : subject.ink.strokes) {
    if (!stroke.fold) continue;
    for (const StrokePoint& point : stroke.points) {
      EXPECT_NEAR(point.shares.x + point.shares.y + point.shares.z, 1, 1e-5);
      EXPECT_GE(std::min({point.shares.x, point.shares.y, point.shares.z}), -1e-5f);
      for (int i = 0; i < 3; ++i) ASSERT_LT(point.vertices[i], skin.positions.size());
      ++count;
    }
    for (std::size_t i = 1; i < stroke.points.size(); ++i) {
      const auto find_place = [&](const StrokePoint& point) {
        glm::vec3 sum(0);
        for (int k = 0; k < 3; ++k) sum += point.shares[k] * skin.positions[point.vertices[k]];
        return sum;
      };
      EXPECT_LT(glm::distance(find_place(stroke.points[i - 1]), find_place(stroke.points[i])), 8)
          << stroke.rule.name << ": no step to another fold of the skin";
    }
  }
  EXPECT_GT(count, 200U);
}

TEST(ink, lines_are_as_wide_as_the_view_says) {
  const Subject& subject = comic();
  const InkView thin{{0, 0, 900}, {0, 0, 1}, 0.5};
  InkView thick = thin;
  thick.line_mm = 2;
  const std::size_t lines = find_part(subject.ink.model, "lines"),
                    brows = find_part(subject.ink.model, "brow_strokes");
  const Drawing one = draw(subject, Pose{}, TurnKey{}, thin), other = draw(subject, Pose{}, TurnKey{}, thick);
  const auto measure = [&](const Drawing& drawing,
                           std::size_t part) {  // across the middle of the first stroke
    const std::vector<glm::vec3>& p = drawing.parts[part].positions;
    const std::size_t ring = kStrokeSteps / 2 * kStrokeSpokes;
    return glm::distance(p[ring], p[ring + kStrokeSpokes / 2]);
  };
  EXPECT_NEAR(measure(other, lines), 4 * measure(one, lines), 0.01);
  EXPECT_NEAR(measure(other, brows), measure(one, brows), 1e-5);  // brows are as thick as they are
}

// How broad a stroke of the lines is in its middle.
double measure_middle(const Subject& subject, const Drawing& drawing, std::string_view name) {
  const std::vector<glm::vec3> stroke = find_stroke(subject, drawing, name);
  constexpr std::size_t kRing = kStrokeSteps / 2 * kStrokeSpokes;
  return glm::distance(stroke[kRing], stroke[kRing + kStrokeSpokes / 2]);
}

TEST(ink, the_line_of_the_jaw_gives_way_to_the_outline) {
  const Subject& subject = comic();
  const InkView before{{0, 0, 900}, {0, 0, 1}, 1}, above{{0, 900, 300}, {0, 0, 1}, 1};
  EXPECT_GT(measure_middle(subject, draw(subject, Pose{}, TurnKey{}, before), "jaw"), 0.6);
  EXPECT_LT(measure_middle(subject, draw(subject, Pose{}, TurnKey{}, above), "jaw"), 0.05);
}

// In profile a line that stands before the lips would leave a strip of the ground between.
TEST(ink, lines_of_the_lips_lie_on_them_in_profile) {
  const Subject& subject = comic();
  const auto measure_way = [&](const glm::dvec3& camera_mm,
                               int lip) {  // from the middle of the lip to its line's middle
    const Drawing drawing =
        draw(subject, make_pose({{"chin.down", 0.6}}), TurnKey{}, {camera_mm, {0, 0, 1}, 1});
    const std::vector<glm::vec3> stroke = find_stroke(subject, drawing, lip == 0 ? "upper_lip" : "lower_lip");
    glm::vec3 middle(0);
    for (std::size_t v = 0; v < std::size_t{2} * kStrokeSpokes; ++v)
      middle += stroke[(kStrokeSteps / 2 - 1) * kStrokeSpokes + v] / (2.0f * kStrokeSpokes);
    return middle - drawing.parts.front().positions[subject.ink.lips[lip]];
  };
  const glm::dvec3 beside_mm(900, -60, 80);
  EXPECT_LT(glm::length(measure_way(beside_mm, 1)), 0.5 * glm::length(measure_way({0, 0, 900}, 1)));
  const glm::vec3 way = measure_way(beside_mm, 0), toward = glm::normalize(glm::vec3(beside_mm));
  EXPECT_LT(glm::length(way - glm::dot(way, toward) * toward), 0.3);  // it lies off toward the camera alone
}

// From the side the bag below the eye has no outline, which would look like a tear; from elsewhere it has.
TEST(ink, no_line_runs_down_from_the_eye_in_profile) {
  const auto measure = [](const glm::dvec3& camera_mm) {
    return measure_outline_mm(comic(), "E4_15", 6, {camera_mm, {0, 0, 1}, 1});
  };
  EXPECT_LT(measure({900, -40, 80}), 0.15);
  EXPECT_GT(measure({-600, -40, 650}), 0.3);
  for (const char* name : {"E2_1", "E2_2", "E2_3", "E3_3", "E3_4"})
    EXPECT_LT(measure_outline_mm(comic(), name, 3, {{900, -40, 80}, {0, 0, 1}, 1}), 0.11) << name;
}

TEST(ink, an_open_mouth_is_dark_in_profile) {
  const Subject& subject = comic();
  const auto measure_mm = [&](const glm::dvec3& camera_mm) {
    const Drawing drawing =
        draw(subject, make_pose({{"chin.down", 0.7}}), TurnKey{}, {camera_mm, {0, 0, 1}, 1});
    const Box box = compute_bounds(drawing.parts[subject.ink.sheet].positions);
    EXPECT_LT(box.high.x - box.low.x, 0.1) << "in the middle of the face";
    return glm::vec2(box.high.y - box.low.y, box.high.z - box.low.z);
  };
  EXPECT_GT(measure_mm({900, -60, 80}).x, 8);
  EXPECT_GT(measure_mm({900, -60, 80}).y, 20);
  EXPECT_EQ(measure_mm({0, 0, 900}), glm::vec2(0));
}

TEST(ink, hair_beside_a_face_leaves_large_eyes_free) {
  HeadSpec spec = make_spec("comic");
  spec.hair = "long";
  const Subject drawn = build_subject(spec);
  const float corner_mm = drawn.figure.head.skin.positions[find_point(drawn.figure.head.cage, "E1_8")].z;
  const float middle_mm = drawn.figure.head.skin.positions[find_point(drawn.figure.head.cage, "E1_8")].y;
  float front_mm = -1e9f;
  for (const glm::vec3& p : drawn.ink.model.parts[find_part(drawn.ink.model, "hair_mass")].rest.positions)
    if (std::abs(p.y - middle_mm) < 6) front_mm = std::max(front_mm, p.z);
  EXPECT_LT(front_mm, corner_mm);
}

TEST(ink, is_the_same_on_both_sides_and_in_every_turn) {
  const Subject& subject = comic();
  const InkView view{{0, 0, 900}, {0, 0.6, 0.8}, 1};
  const Drawing drawing = draw(subject, make_pose({{"corner.up", 0.7}}), TurnKey{}, view);
  const std::vector<glm::vec3>& lines = drawing.parts[find_part(subject.ink.model, "lines")].positions;
  for (std::size_t v = 0; v < kStrokeVertices; v += kStrokeSpokes) {  // the middles of both upper lashes
    glm::vec3 left(0), right(0);
    for (int k = 0; k < kStrokeSpokes; ++k) {
      left += lines[v + static_cast<std::size_t>(k)];
      right += lines[kStrokeVertices + v + static_cast<std::size_t>(k)];
    }
    EXPECT_LT(glm::length(left * glm::vec3(-1, 1, 1) - right), 0.05f) << v;
  }
}

// The tones' border is calm: what tells them turns little between neighbours, however sharp the skin is
// there.
TEST(ink, tones_turn_less_than_the_skin_and_the_shadow_is_cast_from_below_it) {
  const Subject& subject = comic();
  DeformBuffers deform;
  Drawing plain;
  const Pose pose = make_pose({{"corner.up", 1}});
  deform_figure(subject.figure, pose, TurnKey{}, deform, plain);
  const Drawing drawing = draw(subject, pose, TurnKey{}, InkView{});
  const PartShape &skin = drawing.parts.front(), &before = plain.parts.front();
  const auto measure_turn = [&](const std::vector<glm::vec3>& normals) {
    double sum = 0;
    for (const Triangle& t : subject.figure.folds.skin.triangles)
      for (int i = 0; i < 3; ++i)
        sum += static_cast<double>(glm::distance(normals[t[i]], normals[t[(i + 1) % 3]]));
    return sum;
  };
  EXPECT_LT(measure_turn(skin.normals), 0.6 * measure_turn(before.normals));
  for (const glm::vec3& tone : skin.normals) ASSERT_NEAR(glm::length(tone), 1, 1e-4);
  const std::vector<glm::vec3>& caster = drawing.parts[find_part(subject.ink.model, "shadow")].positions;
  ASSERT_EQ(caster.size(), subject.figure.head.skin.positions.size());
  std::size_t below = 0;
  for (std::size_t v = 0; v < caster.size(); ++v)
    below += glm::dot(skin.positions[v] - caster[v], before.normals[v]) > 0 ? 1 : 0;
  EXPECT_GT(static_cast<double>(below), 0.85 * static_cast<double>(caster.size()));
}

// A cheek that bulges in a smile would have patches of shade, and dots that it casts on itself.
TEST(ink, cheeks_above_the_jaw_have_no_islands_of_shade) {
  const Subject child = build_of_age("child");
  const Drawing rest = draw(child, Pose{}, TurnKey{}, InkView{}),
                smile = draw(child, make_pose({{"corner.up", 1}, {"corner.out", 0.9}}), TurnKey{}, InkView{});
  for (const char* name : {"q12_C8", "q11_C7", "q10_C7", "s1_C8"}) {
    const std::uint32_t v = find_point(child.figure.head.cage, name);
    EXPECT_LT(glm::distance(rest.parts.front().normals[v], smile.parts.front().normals[v]), 0.15) << name;
    EXPECT_GT(child.ink.below_mm[v], 3 * child.ink.eye_size) << name;
  }
}

// Nor chips of light below a far eye, which would look up by itself.
TEST(ink, cheeks_below_a_far_eye_have_no_islands_of_light) {
  const InkView view{{-300, 0, 850}, {0, 0, 1}, 1};
  for (const char* age : {"infant", "adult"}) {
    const Subject subject = build_of_age(age);
    const Drawing smile = draw(subject, make_pose({{"corner.up", 1}, {"lid.lower", 0.6}}), TurnKey{}, view);
    const auto find_tone = [&](const char* name) {
      return smile.parts.front().normals[find_point(subject.figure.head.cage, name)];
    };
    for (const char* name : {"E5_12", "q12_C1"})
      EXPECT_LT(find_tone(name).y - find_tone("q12_C4").y, 0.24) << age << ' ' << name;
  }
  const glm::vec3 to_light = glm::normalize(glm::vec3(-0.55f, 0.55f, 0.63f));
  const Drawing smile = draw(comic(), make_pose({{"corner.up", 1}, {"lid.lower", 0.6}}), TurnKey{}, view);
  const auto find_light = [&](const char* name) {
    return glm::dot(smile.parts.front().normals[find_point(comic().figure.head.cage, name)], to_light);
  };
  for (const char* name : {"q13_C2", "q12_C2", "q12_C3"})
    EXPECT_LT(find_light(name) - find_light("q11_C3"), 0.16f) << name;
  const Subject real = build_subject(HeadSpec{});
  EXPECT_TRUE(draw(real, Pose{}, TurnKey{}, view).parts.front().normals ==
              draw(real, Pose{}, TurnKey{}, InkView{}).parts.front().normals);
}

TEST(ink, lips_cast_no_shadow_and_a_nose_does_unless_it_is_a_button) {
  const Subject& subject = comic();
  const Part& caster = subject.ink.model.parts[find_part(subject.ink.model, "shadow")];
  const std::vector<glm::vec3>& skin = subject.figure.model.parts.front().rest.positions;
  const auto is_in = [&](const char* name) {
    const std::uint32_t point = find_point(subject.figure.head.cage, name);
    return std::ranges::any_of(caster.rest.triangles, [&](const Triangle& t) {
      return glm::distance((skin[t[0]] + skin[t[1]] + skin[t[2]]) / 3.0f, skin[point]) < 2;
    });
  };
  for (const char* name : {"M1_0", "M1_6", "M1_12", "M2_5", "q12_C1"}) EXPECT_FALSE(is_in(name)) << name;
  for (const char* name : {"p_b1", "c2_s"}) EXPECT_FALSE(is_in(name)) << name;
  for (const char* name : {"p_tip", "q12_C4", "m12_D1"}) EXPECT_TRUE(is_in(name)) << name;
}

// The rims of nostrils would cast crumbs; without any skin there a nose's shadow would end as its triangles
// do.
TEST(ink, what_casts_lies_deep_in_the_skin_at_the_nostrils) {
  const Subject& subject = comic();
  const Drawing drawing = draw(subject, Pose{}, TurnKey{}, {});
  const std::vector<glm::vec3>& caster = drawing.parts[subject.ink.caster].positions;
  const auto measure_mm = [&](const char* name) {  // on an adult's head
    const std::uint32_t point = find_point(subject.figure.head.cage, name);
    return glm::distance(caster[point], drawing.parts.front().positions[point]) / subject.ink.eye_size;
  };
  const auto find_z = [&](const char* name) {
    return subject.figure.model.parts.front().rest.positions[find_point(subject.figure.head.cage, name)].z;
  };
  const float deep_mm = 0.7f * (find_z("p_tip") - find_z("M5_0")) / subject.ink.eye_size;
  EXPECT_GT(deep_mm, 3);
  for (const char* name : {"nr_0", "nr_4", "ni_2"}) EXPECT_NEAR(measure_mm(name), deep_mm, 0.01) << name;
  for (const char* name : {"q12_C4", "m12_D1", "p_F2"}) EXPECT_NEAR(measure_mm(name), 3.5, 0.01) << name;
  EXPECT_EQ(subject.ink.below_mm.size(), caster.size());
  EXPECT_EQ(subject.ink.hull_faced.size(), subject.figure.folds.skin.vertex_count());
  EXPECT_EQ(subject.ink.hull_beside.size(), subject.ink.hull_faced.size());
}

// Where the skin between the eyes is dark: nowhere, whatever a face does. The nose has one shade below it.
TEST(ink, a_nose_has_no_shade_between_the_eyes) {
  const Subject& subject = comic();
  const glm::dvec3 to_light = glm::normalize(glm::dvec3(-0.49, 0.6, 0.63));
  constexpr double kTerminator = 0.12;  // as materials_drawn.inc has it: cosine
  for (const Pose& pose : {Pose{}, make_pose({{"brow.up", 1}}), make_pose({{"brow.up", -1}}),
                           make_pose({{"corner.up", 1}, {"lid.lower", 1}})}) {
    const Drawing drawing = draw(subject, pose, TurnKey{}, InkView{{0, 0, 900}, to_light, 1});
    for (const char* name : {"c1_n", "c2_n", "c1_s", "c2_s", "c1_b1", "c2_b1", "E4_14", "E3_14", "E5_15"}) {
      const glm::dvec3 tone(drawing.parts.front().normals[find_point(subject.figure.head.cage, name)]);
      EXPECT_GT(glm::dot(tone, to_light), kTerminator) << name;
    }
  }
}

// A blush is broader than high, its outer end is the higher one, and it ends in no edge.
TEST(ink, a_blush_lies_along_the_cheek_and_has_no_edge) {
  HeadSpec spec = make_spec("manga");
  spec.age = {{"child", 1.0}};
  const Subject subject = build_subject(spec);
  const Part& skin = subject.ink.model.parts.front();
  const glm::vec3 plain = skin.palette.back().srgb;
  const std::size_t first = skin.palette.size() - 11;
  for (std::size_t step = first; step + 1 < skin.palette.size(); ++step)
    EXPECT_LT(glm::distance(skin.palette[step].srgb, skin.palette[step + 1].srgb), 0.06f) << step;
  EXPECT_LT(glm::distance(skin.palette[skin.palette.size() - 2].srgb, plain), 0.02f);
  Box box{glm::vec3(1e9f), glm::vec3(-1e9f)};
  std::vector<glm::vec3> places;
  for (std::size_t i = 0; i < skin.rest.triangles.size(); ++i) {
    if (skin.triangle_shade[i] < first || skin.triangle_shade[i] + 1u >= skin.palette.size()) continue;
    const auto& [a, b, c] = skin.rest.triangles[i];
    const glm::vec3 place = (skin.rest.positions[a] + skin.rest.positions[b] + skin.rest.positions[c]) / 3.0f;
    if (place.x < 0) continue;
    places.push_back(place);
    box.low = glm::min(box.low, place);
    box.high = glm::max(box.high, place);
  }
  ASSERT_GT(places.size(), 100u);
  const float middle = 0.5f * (box.low.x + box.high.x);
  glm::dvec2 inner(0), outer(0);  // sums of heights, and how many
  for (const glm::vec3& place : places) (place.x < middle ? inner : outer) += glm::dvec2(place.y, 1);
  EXPECT_GT(outer.x / outer.y, inner.x / inner.y + 1);
  EXPECT_GT(box.high.x - box.low.x, box.high.y - box.low.y);
  // Below the eye's pupil or little farther out, where the edge of the shade leaves it whole.
  const auto find_x = [&](const char* name) {
    return skin.rest.positions[find_point(subject.figure.head.cage, name)].x;
  };
  EXPECT_GT(middle, find_x("E1_4"));
  EXPECT_LT(middle, 0.5f * (find_x("E1_4") + find_x("E1_8")));
}

// How thick the thickest stroke of folds is that stands on the skin, in lines.
double measure_creases(const Subject& subject, const Pose& pose) {
  const Drawing drawing = draw(subject, pose, TurnKey{}, InkView{});
  const std::vector<glm::vec3>& lines = drawing.parts[find_part(subject.ink.model, "lines")].positions;
  const PartShape& skin = drawing.parts.front();
  double most = 0;
  std::size_t first = 0;
  for (const InkStroke& stroke : subject.ink.strokes) {
    if (stroke.rule.is_brow || stroke.rule.is_on_hair) continue;
    for (std::size_t ring = first; ring < first + kStrokeVertices; ring += kStrokeSpokes) {
      const glm::vec3 middle = 0.5f * (lines[ring] + lines[ring + kStrokeSpokes / 2]);
      if (!stroke.fold) continue;
      std::size_t nearest = 0;
      for (std::size_t v = 0; v < subject.figure.head.skin.positions.size(); ++v)
        if (glm::distance(skin.positions[v], middle) < glm::distance(skin.positions[nearest], middle))
          nearest = v;
      if (glm::dot(middle - skin.positions[nearest], skin.normals[nearest]) > -0.4f)
        most =
            std::max(most, static_cast<double>(glm::distance(lines[ring], lines[ring + kStrokeSpokes / 2])));
    }
    first += kStrokeVertices;
  }
  return most;
}

TEST(ink, creases_come_with_the_move_and_stay_with_age) {
  const Pose frown = make_pose({{"brow.out", -1}, {"brow.up", -1}});
  EXPECT_LT(measure_creases(comic(), Pose{}), 0.3) << "an adult at rest has no line";
  EXPECT_GT(measure_creases(comic(), frown), 0.9);
  HeadSpec old = make_spec("comic"), infant = old;
  old.age = {{"old", 1.0}};
  infant.age = {{"infant", 1.0}};
  EXPECT_GT(measure_creases(build_subject(old), Pose{}), 0.4);
  EXPECT_LT(measure_creases(build_subject(infant), frown), 0.3);
}

TEST(ink, upper_teeth_are_white_where_they_look_out_and_lower_ones_never) {
  const Ink& ink = comic().ink;
  const Part& lower = ink.model.parts[find_part(ink.model, "teeth_lower")];
  EXPECT_EQ(lower.palette.size(), 1u);
  EXPECT_LT(lower.palette[0].srgb.g, 0.2f) << "as dark as the mouth";
  const Part& teeth = ink.model.parts[find_part(ink.model, "teeth_upper")];
  ASSERT_EQ(teeth.triangle_shade.size(), teeth.rest.triangles.size());
  const float back_mm = compute_bounds(teeth.rest.positions).low.z;
  std::size_t white = 0;
  for (std::size_t t = 0; t < teeth.rest.triangles.size(); ++t) {
    if (teeth.triangle_shade[t] != 0) continue;
    ++white;
    const auto& [a, b, c] = teeth.rest.triangles[t];
    const std::vector<glm::vec3>& p = teeth.rest.positions;
    const glm::vec3 middle = (p[a] + p[b] + p[c]) / 3.0f;
    EXPECT_GT(glm::dot(glm::cross(p[b] - p[a], p[c] - p[a]), {middle.x, 0, middle.z - back_mm}), 0);
  }
  EXPECT_GT(4 * white, teeth.rest.triangles.size());
  EXPECT_LT(4 * white, 3 * teeth.rest.triangles.size());
}

TEST(ink, freckles_are_a_few_dots_that_stay_on_the_skin) {
  EXPECT_TRUE(std::ranges::none_of(comic().ink.model.parts, [](const Part& p) { return p.name == "spots"; }));
  HeadSpec spec = make_spec("comic");
  spec.look.freckles = 0.7;
  const Subject subject = build_subject(spec);
  const std::size_t index = find_part(subject.ink.model, "spots");
  const Part& part = subject.ink.model.parts[index];
  EXPECT_EQ(part.material, "ink_spot");
  constexpr std::size_t kOfOne = 19;  // vertices: the middle and two rings of nine
  const std::size_t count = part.rest.positions.size() / kOfOne;
  EXPECT_GT(count, 12U);
  EXPECT_LT(count, 60U);
  std::set<std::uint16_t> strengths(part.shade.begin(), part.shade.end());
  EXPECT_EQ(strengths.size(), 1U) << "all alike";
  const Drawing drawing =
      draw(subject, make_pose({{"corner.up", 1}, {"chin.down", 0.5}}), TurnKey{}, InkView{});
  const PartShape& skin = drawing.parts.front();
  for (std::size_t v = 0; v < drawing.parts[index].positions.size(); v += kOfOne) {
    float nearest = 1e9f;
    for (const glm::vec3& p : skin.positions)
      nearest = std::min(nearest, glm::distance(p, drawing.parts[index].positions[v]));
    EXPECT_LT(nearest, 2.5f) << v;
  }
}

TEST(ink, upper_teeth_are_one_closed_band_and_an_infant_has_none) {
  const auto measure_high = [](const Mix& age) {
    HeadSpec spec = make_spec("real");  // whose teeth no lens bends
    spec.age = age;
    const Figure figure = build_figure(shipped().heads, spec, FigureUse::ink);
    const Mesh& teeth = figure.model.parts[find_part(figure.model, "teeth_upper")].rest;
    EXPECT_EQ(count_open_edges(teeth.triangles), 0u) << age.begin()->first;
    const Box box = compute_bounds(teeth.positions);
    EXPECT_EQ(box.low.x, -box.high.x) << age.begin()->first;
    // Over the front its edge is level.
    float low = box.high.y;
    for (const glm::vec3& p : teeth.positions)
      if (std::abs(p.x) < 0.3f * box.high.x) low = std::min(low, p.y);
    EXPECT_NEAR(low, box.low.y, 0.1f) << age.begin()->first;
    return box.high.y - box.low.y;
  };
  const float child = measure_high({{"child", 1}});
  EXPECT_LT(measure_high({{"infant", 1}}), 0.4f * child);
  EXPECT_GT(measure_high({{"adult", 1}}), 5);
  for (const double older : {0.3, 0.5, 0.65, 0.75, 0.8, 0.9})  // while milk teeth are shed
    EXPECT_GT(measure_high({{"child", 1 - older}, {"teenager", older}}), 0.8f * child) << older;
}

TEST(ink, lips_that_part_a_little_show_no_teeth) {
  const Subject& subject = comic();
  const std::size_t teeth = find_part(subject.ink.model, "teeth_upper");
  const auto measure_rise = [&](double jaw) {
    const Pose pose = make_pose({{"chin.down", jaw}});
    DeformBuffers buffers;
    Drawing plain;
    deform_figure(subject.figure, pose, TurnKey{}, buffers, plain);
    const glm::mat4 drawn = draw(subject, pose, TurnKey{}, {}).parts[teeth].world_from_rest;
    const Box box = compute_bounds(subject.ink.model.parts[teeth].rest.positions);
    const glm::vec4 edge(0, box.low.y, 0, 1);
    const glm::vec4 top(0, subject.ink.teeth_top_mm, 0, 1);
    EXPECT_NEAR((drawn * top).y, (plain.parts[teeth].world_from_rest * top).y, 0.01);
    return (drawn * edge).y - (plain.parts[teeth].world_from_rest * edge).y;
  };
  EXPECT_GT(measure_rise(0), 2);
  EXPECT_EQ(measure_rise(1), 0);
}

TEST(ink, is_in_the_colours_that_are_asked_for) {
  HeadSpec spec = make_spec("comic");
  InkColours colours;
  colours.line = {0, 0, 1};
  colours.cavity = {0.1f, 0.2f, 0.3f};
  colours.flesh = {0.9f, 0.5f, 0};
  colours.bone = {1, 1, 0};
  colours.blush = {0, 1, 0};
  const Ink ink = build_ink(comic().figure, spec, colours);
  const auto find_colour = [&](const char* part) {
    return ink.model.parts[find_part(ink.model, part)].palette.front().srgb;
  };
  for (const char* part : {"lines", "skin_outline", "hair_mass_outline"})
    EXPECT_EQ(find_colour(part), colours.line);
  EXPECT_NE(find_colour("brow_strokes"), colours.line);
  EXPECT_EQ(find_colour("teeth_upper"), colours.bone);
  EXPECT_EQ(find_colour("teeth_lower"), colours.cavity);
  EXPECT_EQ(find_colour("tongue"), colours.flesh);
  const auto has = [](const Part& part, const glm::vec3& srgb) {
    return std::ranges::any_of(part.palette, [&](const Shade& shade) { return shade.srgb == srgb; });
  };
  const Part& skin = ink.model.parts.front();
  EXPECT_TRUE(has(skin, colours.cavity));
  EXPECT_TRUE(has(skin, *colours.blush));
  EXPECT_FALSE(has(comic().ink.model.parts.front(), *colours.blush));
}

TEST(ink, a_scene_takes_all_of_it) {
  const Subject& subject = comic();
  RenderSpec render;
  render.style = Style::ink;
  render.background = "dots";
  const Templates& templates = shipped().stock.templates;
  const std::string include = build_povray_include(subject.ink.model, render, templates);
  for (const char* part : {"#macro light_ink(", "#macro background_dots(", "#macro surface_of_skin_outline()",
                           "ink_skin_texture"})
    EXPECT_NE(include.find(part), std::string::npos) << part;
  std::string frame;
  const Drawing drawing = draw(subject, make_pose({{"chin.down", 0.6}}), TurnKey{}, InkView{});
  append_povray_frame(frame, subject.ink.model, drawing, CameraView{});
  EXPECT_NE(frame.find("surface_of_lines()"), std::string::npos);
}

TEST(redraw, an_open_jaw_draws_the_head_out_and_low_brows_squash_it) {
  const Figure& figure = comic().figure;
  const Redraw& redraw = figure.redraw;
  EXPECT_EQ(compute_stretch(redraw, Pose{}), 0);
  EXPECT_GT(compute_stretch(redraw, make_pose({{"chin.down", 1}})), 0.04);
  EXPECT_LT(compute_stretch(redraw, make_pose({{"brow.up", -1}})), -0.03);
  EXPECT_LE(compute_stretch(redraw, make_pose({{"chin.down", 2}, {"brow.up", 2}})), 0.055);
  DeformBuffers buffers;
  Drawing rest, open;
  deform_figure(figure, Pose{}, TurnKey{}, buffers, rest);
  deform_figure(figure, make_pose({{"chin.down", 1}}), TurnKey{}, buffers, open);
  const auto top = [](const Drawing& drawing) {
    return compute_bounds(drawing.parts.front().positions).high.y;
  };
  const double height = top(rest) - redraw.floor_mm;
  EXPECT_NEAR((top(open) - redraw.floor_mm) / height,
              1 + compute_stretch(redraw, make_pose({{"chin.down", 1}})), 1e-3);
}

// How far a lid's margin is open in the middle of the left eye, mm.
double measure_opening(const Figure& figure, const Pose& pose) {
  DeformBuffers buffers;
  Drawing drawing;
  deform_figure(figure, pose, TurnKey{}, buffers, drawing);
  const auto height = [&](const char* point) {
    return static_cast<double>(drawing.parts.front().positions[find_point(figure.head.cage, point)].y);
  };
  return height("E1_4") - height("E1_12");
}

TEST(redraw, low_and_angry_brows_take_the_lids_along) {
  const Figure& figure = comic().figure;
  const auto measure = [&](double up, double turn, double lid) {
    return measure_opening(figure, make_pose({{"brow.up", up}, {"brow.turn", turn}, {"lid.upper", lid}}));
  };
  EXPECT_LT(measure(-0.6, -1, 0.25), 0.85 * measure(0, 0, 0)) << "anger";
  EXPECT_NEAR(measure(-0.6, 0.6, 0), measure(0, 0, 0), 1.5) << "grief: brows alone";
  EXPECT_NEAR(measure(-1, -1, -1), measure(0, 0, -1), 0.3) << "shut is shut";
  EXPECT_EQ(redraw_pose(Redraw{}, make_pose({{"brow.up", -1}})), make_pose({{"brow.up", -1}}));
}

TEST(redraw, half_a_feeling_is_told_more_clearly_and_a_whole_one_is_what_it_was) {
  Redraw redraw;
  redraw.early = 0.6;
  const auto measure = [&](const char* move, double value) {
    const Pose pose = redraw_pose(redraw, make_pose({{move, value}}));
    const std::string text = move;
    const std::string area = text.substr(0, text.find('.')), name = text.substr(text.find('.') + 1);
    for (const Side side : {Side::none, Side::left})
      if (const auto found = find_move(area, side, name)) return pose.values[*found];
    return -9.0;
  };
  for (const char* move : {"brow.up", "brow.turn", "lid.lower", "corner.up"}) {
    for (const double same : {0.0, 1.0, -1.0, 1.4}) EXPECT_EQ(measure(move, same), same) << move;
    EXPECT_NEAR(measure(move, 0.5), 0.65, 1e-9) << move;
    EXPECT_NEAR(measure(move, -0.5), -0.65, 1e-9) << move;
    for (double value = -1; value < 1; value += 0.05)
      EXPECT_GT(measure(move, value + 0.05), measure(move, value)) << move;
  }
  for (const char* move : {"chin.down", "lips.upper", "lips.press", "eye.side"})
    EXPECT_EQ(measure(move, 0.5), 0.5) << move << ": speech and gaze are what they are";
}

TEST(redraw, disgust_goes_over_the_face_on_its_side_and_a_shout_does_not) {
  Redraw redraw;
  redraw.early = 0.6;
  const auto value = [](const Pose& pose, const char* area, Side side, const char* move) {
    return pose.values[*find_move(area, side, move)];
  };
  const Pose disgust = redraw_pose(redraw, make_pose({{"lips.upper", 1}, {"brow.up", -1}}));
  for (const Side side : {Side::left, Side::right}) {
    EXPECT_LT(value(disgust, "brow", side, "turn"), -0.3);
    EXPECT_GT(value(disgust, "lid", side, "lower"), 0.2);
    EXPECT_LT(value(disgust, "corner", side, "up"), -0.2);
  }
  EXPECT_GT(value(disgust, "lips", Side::none, "upper"), 1);
  Pose one = make_pose({{"lips.upper", 1}});
  one.values[*find_move("brow", Side::left, "up")] = -1;
  EXPECT_LT(value(redraw_pose(redraw, one), "brow", Side::left, "turn"), -0.3);
  EXPECT_EQ(value(redraw_pose(redraw, one), "brow", Side::right, "turn"), 0);
  for (const Pose& other :
       {make_pose({{"lips.upper", 1}, {"brow.up", -1}, {"chin.down", 1}}), make_pose({{"lips.upper", 1}}),
        make_pose({{"brow.up", -1}}), make_pose({{"lips.upper", 1}, {"brow.up", 1}})})
    EXPECT_EQ(redraw_pose(redraw, other), other);
}

TEST(drawn_gaze, goes_to_a_camera_at_the_side_and_to_no_other) {
  const Figure& figure = comic().figure;
  const std::size_t left = *find_move(Area::eye, Side::left, "side"),
                    right = *find_move(Area::eye, Side::right, "side");
  const auto turn = [&](const Pose& pose, double angle_deg) {
    const double angle = angle_deg * kRadiansPerDegree;
    return turn_gaze_to_camera(figure, pose, glm::dmat4(1),
                               {900 * std::sin(angle), 0, 900 * std::cos(angle)});
  };
  for (const double angle_deg : {0.0, 20.0, -40.0}) EXPECT_EQ(turn(Pose{}, angle_deg), Pose{}) << angle_deg;
  EXPECT_GT(turn(Pose{}, 90).values[left], 0.6);
  EXPECT_LT(turn(Pose{}, -90).values[right], -0.6);
  EXPECT_GT(turn(make_pose({{"eye.side", -1}}), 90).values[left], -1) << "who looks away does so less";
  EXPECT_LE(turn(make_pose({{"eye.side", 0.8}}), 100).values[left], 1) << "no eye goes further than it can";
  double before = 0;
  for (double angle_deg = 45; angle_deg <= 90; angle_deg += 2) {
    const double now = turn(Pose{}, angle_deg).values[left];
    EXPECT_GE(now, before);
    EXPECT_LT(now - before, 0.12) << "no jump";
    before = now;
  }
}

TEST(redraw, a_print_has_one_height) {
  const Figure figure = build_figure(shipped().heads, make_spec("comic"), FigureUse::print);
  EXPECT_FALSE(figure.redraw.lens.is_on());  // the print goes through it when all is carved
  EXPECT_EQ(compute_stretch(figure.redraw, make_pose({{"chin.down", 1}, {"brow.up", 1}})), 0);
  const Pose pose = make_pose({{"lips.upper", 0.5}, {"brow.up", -0.5}});
  EXPECT_EQ(redraw_pose(figure.redraw, pose), pose) << "its sliders are its areas";
}

// A turned head is the posed one turned: the lens goes with it.
TEST(redraw, turns_as_one_piece_above_the_neck) {
  const Figure& figure = comic().figure;
  TurnKey turn;
  turn.turn_deg = 35;
  turn.nod_deg = -12;
  DeformBuffers buffers;
  Drawing straight, turned;
  const Pose pose = make_pose({{"brow.turn", -1}, {"eye.side", 0.5}, {"chin.down", 0.4}});
  deform_figure(figure, pose, TurnKey{}, buffers, straight);
  deform_figure(figure, pose, turn, buffers, turned);
  const glm::mat4 world(compute_turn(figure.face.turn_pivot, turn, 1));
  for (std::size_t i = 0; i < figure.model.parts.size(); ++i) {
    if (figure.model.parts[i].is_rigid) continue;
    const auto &before = straight.parts[i].positions, &after = turned.parts[i].positions;
    for (std::size_t v = 0; v < before.size(); v += 37) {
      if (before[v].y <= figure.redraw.chin_mm + 10) continue;
      const std::vector<float>& shares = figure.redraw.turn_shares;
      if (i == 0 && (v >= shares.size() || shares[v] < 1)) continue;  // the nape goes part of the way
      EXPECT_LT(glm::distance(glm::vec3(world * glm::vec4(before[v], 1)), after[v]), 0.02f)
          << figure.model.parts[i].name << ' ' << v;
    }
  }
}

}  // namespace
}  // namespace mien

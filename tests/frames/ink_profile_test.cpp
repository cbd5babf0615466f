#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "drawn_subject.hpp"
#include "head/cage.hpp"
#include "head/hair_lines.hpp"

namespace mien {
namespace {

constexpr glm::dvec3 kBeside_mm{900, -40, 80}, kBefore_mm{0, 0, 900};

const Subject& child() {
  static const Subject subject = [] {
    HeadSpec spec = make_spec("comic");
    spec.age = {{"child", 1.0}};
    return build_subject(spec);
  }();
  return subject;
}

// The vertices of a stroke among the lines.
std::vector<glm::vec3> find_stroke(const Subject& subject, const Drawing& drawing, std::string_view name) {
  std::size_t first = 0;
  for (const InkStroke& stroke : subject.ink.strokes) {
    if (stroke.rule.name == name) break;
    if (!stroke.rule.is_brow) first += kStrokeVertices;
  }
  const std::vector<glm::vec3>& p = drawing.parts[find_part(subject.ink.model, "lines")].positions;
  const auto begin = p.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + kStrokeVertices};
}

double measure_width(const std::vector<glm::vec3>& stroke) {
  double most = 0;
  for (std::size_t ring = 0; ring < stroke.size(); ring += kStrokeSpokes)
    most = std::max(most, static_cast<double>(glm::distance(stroke[ring], stroke[ring + kStrokeSpokes / 2])));
  return most;
}

// How far the outline stands off the skin at a point: what it moved along the normal there.
double measure_outline_mm(const Subject& subject, const char* name, const glm::dvec3& camera_mm) {
  const Drawing drawing = draw(subject, Pose{}, TurnKey{}, {camera_mm, {0, 0.6, 0.8}, 1});
  const glm::vec3 at = drawing.parts.front().positions[find_point(subject.figure.head.cage, name)];
  double off = 0;
  for (const glm::vec3& p : drawing.parts[subject.ink.first_outline].positions) {
    if (glm::distance(p, at) > 3) continue;
    float nearest = 1e9f;
    for (const glm::vec3& v : drawing.parts.front().positions)
      nearest = std::min(nearest, glm::distance(v, p));
    off = std::max(off, static_cast<double>(nearest));
  }
  return off;
}

TEST(ink_profile, lips_and_the_bridge_of_the_nose_have_an_outline) {
  for (const char* name : {"M3_0", "M3_12", "p_b1"}) {
    EXPECT_GT(measure_outline_mm(child(), name, kBeside_mm), 0.4) << name;
    EXPECT_GT(measure_outline_mm(comic(), name, kBeside_mm), 0.4) << name;
  }
  for (const char* name : {"M3_0", "M3_12"}) EXPECT_LT(measure_outline_mm(comic(), name, kBefore_mm), 0.2);
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
  HeadSpec spec = make_spec("comic");
  spec.age = {{"old", 1.0}};
  const Subject old = build_subject(spec);
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

TEST(ink_profile, a_mouth_that_opens_a_little_shows_no_tongue) {
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

TEST(ink_profile, a_button_of_a_nose_casts_no_shadow) {
  const auto casts = [](const Subject& subject) {
    const Part& caster = subject.ink.model.parts[find_part(subject.ink.model, "shadow")];
    const std::vector<glm::vec3>& skin = subject.figure.model.parts.front().rest.positions;
    const glm::vec3 tip = skin[find_point(subject.figure.head.cage, "p_tip")];
    return std::ranges::any_of(caster.rest.triangles,
                               [&](const Triangle& t) { return glm::distance(skin[t[0]], tip) < 4; });
  };
  EXPECT_TRUE(casts(comic()));
  EXPECT_FALSE(casts(child()));
}

// Places of a line on the hair's mass.
std::vector<glm::vec3> find_places(const HairLine& line, const Mesh& mass) {
  std::vector<glm::vec3> places;
  for (const MeshPlace& place : line.places) {
    glm::vec3& at = places.emplace_back(0);
    for (int i = 0; i < 3; ++i) at += place.shares[i] * mass.positions[place.vertices[i]];
  }
  return places;
}

struct HairSubject {
  Subject subject;
  const Mesh* mass;
  std::vector<HairLine> lines;
};

HairSubject build_hair(const char* cut) {
  HeadSpec spec = make_spec("comic");
  spec.hair = cut;
  HairSubject hair{build_subject(spec), nullptr, {}};
  const Model& model = hair.subject.figure.model;
  hair.mass = &model.parts[find_part(model, "hair_mass")].rest;
  hair.lines = list_hair_lines(hair.subject.figure.head, cut, *hair.mass);
  return hair;
}

// Over a free ear hair ends: a line from before it to behind it would lie across the ear.
TEST(hair_lines, lie_on_the_hair_all_their_way) {
  for (const char* cut : {"side_part", "crop"}) {
    const HairSubject hair = build_hair(cut);
    ASSERT_FALSE(hair.lines.empty());
    for (const HairLine& line : hair.lines) {
      const std::vector<glm::vec3> places = find_places(line, *hair.mass);
      for (std::size_t i = 1; i < places.size(); ++i) {
        const glm::vec3 middle = 0.5f * (places[i - 1] + places[i]);
        float nearest = 1e9f;
        for (const glm::vec3& v : hair.mass->positions) nearest = std::min(nearest, glm::distance(v, middle));
        EXPECT_LT(nearest, 10) << cut;
      }
    }
  }
}

// Where locks part the line begins in the corner between them.
TEST(hair_lines, begin_where_locks_part) {
  const HairSubject hair = build_hair("bob");
  std::size_t partings = 0;
  for (const HairLine& line : hair.lines) {
    if (line.begins != 0.7) continue;
    const MeshPlace& first = line.places.front();
    EXPECT_EQ(first.vertices[0], first.vertices[1]);
    EXPECT_EQ(first.shares.x, 1);
    EXPECT_EQ(line.places[1].vertices[0] + 1, first.vertices[0]) << "up the column of the corner";
    ++partings;
  }
  EXPECT_GT(partings, 5U);
}

TEST(hair_lines, mark_the_edge_where_it_meets_the_skin) {
  const HairSubject hair = build_hair("side_part");
  const std::vector<glm::vec3>& skin = hair.subject.figure.model.parts.front().rest.positions;
  std::size_t edges = 0, places = 0, on_skin = 0;
  for (const HairLine& line : hair.lines) {
    if (line.begins != line.width || line.width != line.ends) continue;
    for (const glm::vec3& place : find_places(line, *hair.mass)) {
      float nearest = 1e9f;
      for (const glm::vec3& v : skin) nearest = std::min(nearest, glm::distance(v, place));
      ++places;
      on_skin += nearest < 3.5f ? 1 : 0;  // over an ear there is none below it
    }
    ++edges;
  }
  EXPECT_GT(edges, 6U);
  EXPECT_GT(static_cast<double>(on_skin), 0.9 * static_cast<double>(places));
}

// A tuft would stand off it as two stubs.
TEST(hair_lines, hair_that_is_combed_has_no_tuft) {
  const auto count_bodies = [](const char* cut) {
    const HairSubject hair = build_hair(cut);
    std::vector<std::uint32_t> body(hair.mass->positions.size());
    for (std::uint32_t v = 0; v < body.size(); ++v) body[v] = v;
    const auto find = [&](std::uint32_t v) {
      while (body[v] != v) v = body[v] = body[body[v]];
      return v;
    };
    for (const Triangle& t : hair.mass->triangles)
      for (int i = 0; i < 3; ++i) body[find(t[i])] = find(t[(i + 1) % 3]);
    std::size_t count = 0;
    for (std::uint32_t v = 0; v < body.size(); ++v) count += find(v) == v ? 1 : 0;
    return count;
  };
  EXPECT_EQ(count_bodies("side_part"), 1U);
  EXPECT_EQ(count_bodies("crop"), 3U);
}

}  // namespace
}  // namespace mien

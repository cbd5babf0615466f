#include "head/hair_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_subject.hpp"

namespace mien {
namespace {

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

HairSubject build_hair_subject(const char* cut) {
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
    const HairSubject hair = build_hair_subject(cut);
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
  const HairSubject hair = build_hair_subject("bob");
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
  const HairSubject hair = build_hair_subject("side_part");
  const std::vector<glm::vec3>& skin = hair.subject.figure.model.parts.front().rest.positions;
  std::size_t edges = 0, places = 0, on_skin = 0;
  double away_mm = 0;
  for (const HairLine& line : hair.lines) {
    if (line.begins != line.width || line.width != line.ends) continue;
    for (const glm::vec3& place : find_places(line, *hair.mass)) {
      float nearest = 1e9f;
      for (const glm::vec3& v : skin) nearest = std::min(nearest, glm::distance(v, place));
      ++places;
      away_mm += nearest;
      on_skin += nearest < 3.5f ? 1 : 0;  // over an ear there is none below it
    }
    ++edges;
  }
  EXPECT_GT(edges, 6U);
  EXPECT_GT(static_cast<double>(on_skin), 0.9 * static_cast<double>(places));
  EXPECT_LT(away_mm, 1.65 * static_cast<double>(places));  // of vertices that are 3 mm apart
}

// A tuft would stand off it as two stubs.
TEST(hair_lines, hair_that_is_combed_has_no_tuft) {
  const auto count_bodies = [](const char* cut) {
    const HairSubject hair = build_hair_subject(cut);
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

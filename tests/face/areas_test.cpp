// Each area alone, on the skin as it is drawn: it goes as far as its limit says, on its own side, and leaves
// the back of the head and the neck alone.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "core/data.hpp"
#include "frames/figure.hpp"
#include "head/random_heads.hpp"
#include "head/soundness.hpp"
#include "head/surface.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

struct Subject {
  std::string name;
  NeutralHead head;
  Face face;
};

Subject build(const std::string& name, const HeadSpec& spec) {
  Subject subject{name, build_neutral_head(shipped().heads, spec), {}};
  subject.face = build_face(subject.head);
  return subject;
}

HeadSpec spec_of(const std::string& age, const std::string& skull) {
  HeadSpec spec;
  spec.age = {{age, 1.0}};
  spec.skull = {{skull, 1.0}};
  return spec;
}

const std::vector<Subject>& subjects() {
  static const std::vector<Subject> all = [] {
    std::vector<Subject> built;
    built.push_back(build("adult", HeadSpec{}));
    built.push_back(build("infant", spec_of("infant", "average")));
    built.push_back(build("square", spec_of("adult", "square")));
    built.push_back(build("random", build_random_spec(7, shipped().stock.head->shapes.heads)));
    return built;
  }();
  return all;
}

std::vector<glm::vec3> draw_skin(const Subject& s, const Pose& pose) {
  std::vector<glm::dvec3> points;
  std::vector<Float4> packed;
  std::vector<glm::vec3> skin;
  pose_cage(s.head, s.face, pose, points);
  pack_points(points, packed);
  deform_surface(*s.head.surface, packed, skin);
  return skin;
}

// One way of one move at its limit.
struct Way {
  std::string name;
  std::size_t move;
  Pose pose;
};

std::vector<Way> list_ways() {
  std::vector<Way> ways;
  for (std::size_t i = 0; i < kMoveCount; ++i)
    for (const double value : {kMoves[i].low, kMoves[i].high}) {
      if (value == 0) continue;
      Way way{fmt::format("{}.{} {:+.0f}", kMoves[i].area, kMoves[i].move, value), i, {}};
      way.pose.values[i] = value;
      ways.push_back(way);
    }
  return ways;
}

// Toward the match level the lips meet before their limit.
bool is_contact(const Limit& limit) { return limit.name->thesis == "LIPS_MATCH_LEVEL"; }

TEST(areas, go_as_far_as_their_limits_say_on_every_head) {
  for (const Subject& s : subjects()) {
    for (const Limit& limit : measure_limits(s.head, s.face, {})) {
      if (limit.axis < 0 || is_contact(limit) || limit.point == kTonguePlace) continue;
      Pose pose;
      pose.values[limit.name->move] = limit.name->sign;
      std::vector<glm::dvec3> points;
      pose_cage(s.head, s.face, pose, points);
      const std::uint32_t i = s.head.cage.index.find(limit.point)->second;
      const double way = (points[i] - s.head.cage.points[i])[limit.axis];
      EXPECT_NEAR(std::abs(way), limit.mm, 0.01 * limit.mm) << s.name << " " << limit.name->name;
    }
  }
}

TEST(areas, turn_the_margins_of_the_lids_by_their_limits_on_the_skin) {
  for (const Subject& s : subjects())
    for (const auto& [move, point, angle] :
         {std::tuple{"upper", "E1_4", s.face.lids.wide_rad}, {"lower", "E1_12", s.face.lids.raised_rad}}) {
      Pose pose;
      pose.values[*find_move(Area::lid, Side::left, move)] = 1;
      const std::uint32_t i = s.head.cage.index.find(point)->second;
      // Turned about the lids' own axis: along it nothing moves.
      const auto height = [&](const std::vector<glm::vec3>& skin) {
        const glm::dvec3 arm = glm::dvec3(skin[i]) - s.head.eye.centre;
        return std::atan2(glm::dot(arm, glm::cross(glm::dvec3(0, 0, 1), s.face.lids.axis)), arm.z);
      };
      const double turned = height(draw_skin(s, pose)) - height(s.head.skin.positions);
      EXPECT_NEAR(turned, angle, 0.01 * angle) << s.name << " " << move;
    }
}

TEST(areas, of_one_side_leave_the_other_side_alone) {
  for (const Subject& s : subjects())
    for (const Way& way : list_ways()) {
      if (kMoves[way.move].side != Side::left) continue;
      const std::vector<glm::vec3> skin = draw_skin(s, way.pose);
      for (std::uint32_t v = 0; v < skin.size(); ++v) {
        const glm::vec3& rest = s.head.skin.positions[v];
        if (rest.x > -30) continue;
        ASSERT_LT(glm::distance(skin[v], rest), 0.01) << s.name << " " << way.name;
      }
    }
}

TEST(areas, leave_the_back_of_the_head_and_the_neck_alone) {
  for (const Subject& s : subjects())
    for (const Way& way : list_ways()) {
      const std::vector<glm::vec3> skin = draw_skin(s, way.pose);
      for (std::uint32_t v = 0; v < skin.size(); ++v) {
        const glm::vec3& rest = s.head.skin.positions[v];
        const std::string& name = s.head.cage.names[v < s.head.cage.names.size() ? v : 0];
        const bool is_neck = name.ends_with("_N5") || name.ends_with("_N6");
        if (rest.z > -60 && !is_neck) continue;
        ASSERT_LT(glm::distance(skin[v], rest), 0.01) << s.name << " " << way.name << " " << rest.y;
      }
    }
}

TEST(areas, close_the_characters_own_left_eye_when_told_left) {
  for (const Subject& s : subjects()) {
    Pose wink;
    wink.values[*find_move(Area::lid, Side::left, "upper")] = -1;
    const std::vector<glm::vec3> skin = draw_skin(s, wink);
    const auto opening = [&](const char* side) {  // x > 0 is the character's left
      const auto at = [&](const char* name) {
        return skin[s.head.cage.index.find(std::string(side) + name)->second];
      };
      return at("E1_4").y - at("E1_12").y;
    };
    EXPECT_GT(s.head.cage.points[s.head.cage.index.find("E1_4")->second].x, 0);
    EXPECT_LT(opening(""), 0.3) << s.name;
    EXPECT_GT(opening("R:"), 6) << s.name;
  }
}

// Each control alone, in a random pose: a vertex's pace never exceeds the lids' and the jaw's, which go 40 mm
// and less at their limits. A pop would be a pace of a thousand.
TEST(areas, move_no_vertex_faster_than_a_bound) {
  constexpr double kStep = 0.005, kFastest_mm = 70;
  for (const Subject& s : {subjects().front(), subjects()[1]}) {
    std::mt19937 random(3);
    for (int round = 0; round < 3; ++round) {
      Pose pose;
      for (std::size_t i = 0; i < kMoveCount; ++i)
        pose.values[i] =
            std::uniform_real_distribution<double>(kMoves[i].low, kMoves[i].high - kStep)(random);
      const std::vector<glm::vec3> here = draw_skin(s, pose);
      for (std::size_t i = 0; i < kMoveCount; ++i) {
        Pose nudged = pose;
        nudged.values[i] += kStep;
        const std::vector<glm::vec3> there = draw_skin(s, nudged);
        double pace_mm = 0;
        for (std::size_t v = 0; v < here.size(); ++v)
          pace_mm = std::max(pace_mm, glm::distance(here[v], there[v]) / kStep);
        EXPECT_LT(pace_mm, kFastest_mm) << s.name << " " << kMoves[i].area << "." << kMoves[i].move;
        EXPECT_TRUE(pace_mm > 0 || kMoves[i].area == "eye" || kMoves[i].area == "lips" ||
                    kMoves[i].of == Area::tongue)
            << s.name << " " << i;
      }
    }
  }
}

// Along straight ways between random poses: a kink, where lids or lips begin to touch, changes a vertex's
// pace within one step; a pop would show as millimetres.
TEST(areas, move_every_vertex_without_pops) {
  constexpr int kSteps = 100;
  const Subject& s = subjects().front();
  double worst = 0;
  std::string place;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    std::mt19937 random(seed);
    Pose from, to;
    const auto draw = [&](std::size_t i) {
      std::uniform_real_distribution<double> value(kMoves[i].low, kMoves[i].high);
      from.values[i] = value(random);
      to.values[i] = value(random);
    };
    // What came later comes last, so that the others' ways are what they were without it.
    const auto is_late = [](std::size_t i) {
      constexpr std::array<std::string_view, 6> kLate{"roll_upper", "roll_lower", "dimple",
                                                      "lift",       "bare",       "squint"};
      return std::ranges::find(kLate, kMoves[i].move) != kLate.end() ||
             (kMoves[i].of == Area::lid && kMoves[i].move == "out");
    };
    const auto is_latest = [](std::size_t i) {
      return kMoves[i].move == "pucker" || kMoves[i].move.starts_with("shrug_");
    };
    const std::size_t shut = *find_move(Area::lips, Side::none, "shut");
    for (std::size_t i = 0; i < kMoveCount; ++i)
      if (i != shut && !is_late(i) && !is_latest(i)) draw(i);
    draw(shut);
    for (std::size_t i = 0; i < kMoveCount; ++i)
      if (is_late(i)) draw(i);
    for (std::size_t i = 0; i < kMoveCount; ++i)
      if (is_latest(i)) draw(i);
    std::array<std::vector<glm::vec3>, 3> skins;
    for (int step = 0; step <= kSteps; ++step) {
      Pose pose;
      for (std::size_t i = 0; i < kMoveCount; ++i)
        pose.values[i] = glm::mix(from.values[i], to.values[i], static_cast<double>(step) / kSteps);
      skins[step % 3] = draw_skin(s, pose);
      if (step < 2) continue;
      const auto &a = skins[(step - 2) % 3], &b = skins[(step - 1) % 3], &c = skins[step % 3];
      for (std::uint32_t v = 0; v < a.size(); ++v) {
        const double second = glm::length(a[v] - 2.0f * b[v] + c[v]);
        if (second <= worst) continue;
        worst = second;
        place = fmt::format("seed {}, step {}, {}", seed, step, find_nearest_name(s.head, v));
      }
    }
  }
  RecordProperty("largest second difference, mm", std::to_string(worst));
  EXPECT_LT(worst, 0.15) << place;  // of ways up to 30 mm in 100 steps
}

}  // namespace
}  // namespace mien

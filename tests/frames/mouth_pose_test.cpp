// The mouth in expressions: lips keep off the teeth, and shut lips show none.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "config/expressions.hpp"
#include "config/load_spec.hpp"
#include "frames/figure.hpp"
#include "head/binding.hpp"
#include "head/cage.hpp"
#include "places.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

struct NamedFigure {
  std::string name;
  Figure figure;
};

const std::vector<NamedFigure>& figures() {
  static const std::vector<NamedFigure> list = [] {
    std::vector<NamedFigure> made;
    const auto add = [&](const std::string& name, const HeadSpec& spec) {
      made.push_back({name, build_figure(shipped().heads, spec)});
    };
    for (const char* age : {"adult", "infant", "child"}) {
      HeadSpec spec;
      spec.age = {{age, 1.0}};
      add(age, spec);
    }
    HeadSpec square;
    square.skull = {{"square", 1.0}};
    add("square", square);
    for (const double character : {-1.0, 1.0}) {
      HeadSpec spec;
      spec.character = character;
      add(character < 0 ? "female" : "male", spec);
    }
    return made;
  }();
  return list;
}

const std::vector<Expression>& expressions() {
  static const auto libraries =
      load_expression_libraries(std::filesystem::path(source_folder()) / "configs/expressions");
  return libraries;
}

double find_scale(const Figure& figure) {
  return figure.head.skin.positions[find_point(figure.head.cage, "M1_6")].x /
         shipped().stock.head->parts.mouth.corner_mm;
}

constexpr double kPressed_mm =
    0.2;  // nearer than at rest is allowed: a laugh draws the lips back against the teeth
constexpr double kBare_mm2 = 0.5;  // between shut lips 50 mm long: a hundredth of a millimetre of them
constexpr float kBare_mm = 3;      // beyond the inner edge of a lip; past it gum and flesh are one

// The least way from a tooth's front to the skin of the lips before it, mm; negative: the tooth is through
// it.
double find_clearance_mm(const Figure& figure, const Pose& pose) {
  DeformBuffers buffers;
  Drawing drawing;
  deform_figure(figure, pose, TurnKey{}, buffers, drawing);
  Mesh skin{drawing.parts[0].positions, drawing.parts[0].normals, figure.head.skin.triangles};
  const auto at = [&](const char* name) { return skin.positions[find_point(figure.head.cage, name)]; };
  const auto scale = static_cast<float>(find_scale(figure));
  const glm::vec3 reach(26 * scale, 14 * scale, 16 * scale);
  const glm::vec3 middle = 0.5f * (at("M0_0") + at("M0_12"));
  SkinPatch patch = build_skin_patch(skin, {glm::vec3(-reach.x, at("M0_12").y - reach.y, middle.z - reach.z),
                                            glm::vec3(reach.x, at("M0_0").y + reach.y, middle.z + reach.z)});
  double least = 1e9;
  for (std::size_t i = 0; i < figure.parts.size(); ++i) {
    const Part& part = figure.model.parts[i];
    if (!part.name.starts_with("teeth")) continue;
    for (std::size_t v = 0; v < part.rest.positions.size(); ++v) {
      // Fronts of bare teeth; in the cheeks and under the fold behind the lips, gum and flesh are one.
      if (part.rest.normals[v].z < 0.2f) continue;
      const glm::vec3 p(drawing.parts[i].world_from_rest * glm::vec4(part.rest.positions[v], 1));
      if (std::abs(p.x) > 15 * scale) continue;
      if (p.y > at("M0_0").y + kBare_mm * scale || p.y < at("M0_12").y - kBare_mm * scale) continue;
      const SkinPlace place = find_nearest_place(patch, p);
      least = std::min<double>(least, glm::dot(p - place.point, place.normal));
    }
  }
  return least;
}

TEST(mouth_pose, keeps_the_lips_off_the_teeth) {
  const MouthNumbers numbers = shipped().stock.head->parts.mouth;
  for (const auto& [name, figure] : figures())
    for (const Expression& expression : expressions()) {
      const bool is_asked =
          expression.library == "emfacs" ||
          (expression.library == "mien" &&
           (expression.name == "laugh" || expression.name == "smile" || expression.name == "shout"));
      if (!is_asked) continue;
      const double clearance = find_clearance_mm(figure, expression.pose) / find_scale(figure);
      EXPECT_GE(clearance, numbers.clearance_mm - kPressed_mm)
          << name << ", " << expression.library << "/" << expression.name;
    }
}

// Triangles of a part as they are drawn, before the camera.
struct Screen {
  static constexpr float kStep_mm = 0.1f;
  float left = 0, low = 0;
  int wide = 0, high = 0;
  std::vector<float> depth;
  std::vector<char> is_tooth;
};

void draw(Screen& screen, const std::vector<glm::vec3>& p, const std::vector<Triangle>& triangles,
          bool is_tooth) {
  for (const auto& [ia, ib, ic] : triangles) {
    const glm::vec3 &a = p[ia], &b = p[ib], &c = p[ic];
    const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (std::abs(area) < 1e-9f) continue;
    const auto cell = [](float from, float at) {
      return static_cast<int>(std::floor((at - from) / Screen::kStep_mm));
    };
    const int x0 = std::max(0, cell(screen.left, std::min({a.x, b.x, c.x})));
    const int x1 = std::min(screen.wide - 1, cell(screen.left, std::max({a.x, b.x, c.x})));
    const int y0 = std::max(0, cell(screen.low, std::min({a.y, b.y, c.y})));
    const int y1 = std::min(screen.high - 1, cell(screen.low, std::max({a.y, b.y, c.y})));
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        const float px = screen.left + (static_cast<float>(x) + 0.5f) * Screen::kStep_mm;
        const float py = screen.low + (static_cast<float>(y) + 0.5f) * Screen::kStep_mm;
        const float u = ((b.x - px) * (c.y - py) - (b.y - py) * (c.x - px)) / area;
        const float v = ((c.x - px) * (a.y - py) - (c.y - py) * (a.x - px)) / area;
        if (u < 0 || v < 0 || u + v > 1) continue;
        const float z = u * a.z + v * b.z + (1 - u - v) * c.z;
        const auto i = static_cast<std::size_t>(y * screen.wide + x);
        if (z <= screen.depth[i]) continue;
        screen.depth[i] = z;
        screen.is_tooth[i] = is_tooth;
      }
  }
}

// Square millimetres of teeth that a far camera sees between the lips from a height.
double find_bare_mm2(const Figure& figure, const Pose& pose, float height_deg) {
  DeformBuffers buffers;
  Drawing drawing;
  TurnKey turn;
  turn.nod_deg = height_deg;
  deform_figure(figure, pose, turn, buffers, drawing);
  const glm::vec3 middle = drawing.parts[0].positions[find_point(figure.head.cage, "M1_0")];
  Screen screen;
  screen.wide = 600;
  screen.high = 200;
  screen.left = -0.5f * 600 * Screen::kStep_mm;
  screen.low = middle.y - 0.5f * 200 * Screen::kStep_mm;
  screen.depth.assign(static_cast<std::size_t>(screen.wide * screen.high), -1e9f);
  screen.is_tooth.assign(screen.depth.size(), 0);
  for (std::size_t i = 0; i < figure.parts.size(); ++i) {
    const Part& part = figure.model.parts[i];
    std::vector<glm::vec3> positions = drawing.parts[i].positions;
    if (is_carried(part, drawing.parts[i]))
      for (const glm::vec3& p : part.rest.positions)
        positions.emplace_back(drawing.parts[i].world_from_rest * glm::vec4(p, 1));
    draw(screen, positions, part.rest.triangles, part.name.starts_with("teeth"));
  }
  return Screen::kStep_mm * Screen::kStep_mm *
         static_cast<double>(std::count(screen.is_tooth.begin(), screen.is_tooth.end(), 1));
}

TEST(mouth_pose, shut_lips_show_no_teeth) {
  for (const auto& [name, figure] : figures())
    for (const Expression& expression : expressions()) {
      const bool is_shut =
          expression.library == "mien" &&
          (expression.name == "neutral" || expression.name == "anger" || expression.name == "sadness");
      if (!is_shut) continue;
      for (const float height_deg : {-10.0f, 0.0f, 10.0f}) {
        const double bare = find_bare_mm2(figure, expression.pose, height_deg);
        EXPECT_LE(bare, kBare_mm2) << name << ", " << expression.name << ", seen at " << height_deg
                                   << " degrees";
      }
    }
}

TEST(mouth_pose, a_smile_shows_teeth) {
  for (const Expression& expression : expressions())
    if (expression.library == "mien" && expression.name == "smile") {
      EXPECT_GT(find_bare_mm2(figures()[0].figure, expression.pose, 0), 80);
    }
}

}  // namespace
}  // namespace mien

#include "head/ink_eyes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "config/part_numbers.hpp"
#include "core/conventions.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

constexpr int kSpokes = 72;
constexpr double kRim = 0.88;  // of the iris' angle: from there on it is dark

// A place on the ball: an angle off its axis, and one about it.
glm::vec3 find_on_ball(double radius, double off, double turn) {
  return glm::vec3(radius * std::sin(off) * std::cos(turn), radius * std::sin(off) * std::sin(turn),
                   radius * std::cos(off));
}

struct Eyeball {
  glm::dvec3 centre{0};
  double radius_mm = 1, outward_rad = 0;
};

HeadPart make_part(const std::string& name, const char* material, const glm::vec3& srgb) {
  HeadPart part;
  part.part.name = name;
  part.part.material = material;
  part.part.palette = {{srgb, 0}};
  part.part.is_rigid = true;
  part.part.is_printed = false;
  part.mount = Mount::eye_left;
  return part;
}

// Rings of the ball from one angle to another, about a middle that lies `aside` of its axis; a disc if they
// begin at 0.
void append_zone(Mesh& mesh, const Eyeball& ball, double from, double to, int rings,
                 const glm::dvec2& aside = {}) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const double turn = ball.outward_rad;
  for (int r = 0; r <= rings; ++r)
    for (int k = 0; k < kSpokes; ++k) {
      glm::dvec3 p(
          find_on_ball(ball.radius_mm, from + (to - from) * r / rings, 2 * std::numbers::pi * k / kSpokes));
      const auto tip = [](double& a, double& b, double angle) {  // turns b toward a
        const double s = std::sin(angle), c = std::cos(angle), was = a;
        a = a * c + b * s;
        b = b * c - was * s;
      };
      tip(p.x, p.z, aside.x + turn);
      tip(p.y, p.z, aside.y);
      mesh.normals.push_back(glm::vec3(glm::normalize(p)));
      mesh.positions.push_back(glm::vec3(ball.centre + p));
    }
  for (int r = 0; r < rings; ++r)
    for (int k = 0; k < kSpokes; ++k) {
      const auto at = [&](int ring, int spoke) {
        return first + static_cast<std::uint32_t>(ring * kSpokes + spoke % kSpokes);
      };
      if (r > 0 || from > 0) mesh.triangles.push_back({at(r, k), at(r + 1, k), at(r, k + 1)});
      mesh.triangles.push_back({at(r, k + 1), at(r + 1, k), at(r + 1, k + 1)});
    }
}

// An iris is two flat tones of a purer colour than a real one's: the upper half lies in the lid's shade.
glm::vec3 purify(const glm::vec3& srgb) {
  const float grey = glm::dot(srgb, glm::vec3(0.30f, 0.59f, 0.11f));
  return glm::clamp((glm::vec3(grey) + 1.9f * (srgb - grey)) * 1.15f, 0.0f, 1.0f);
}

}  // namespace

std::vector<HeadPart> build_ink_eyes(const NeutralHead& head, const Look& look) {
  const double iris = head.design.iris_deg * kRadiansPerDegree,
               pupil = head.design.pupil_deg * kRadiansPerDegree;
  // Drawn eyes look straight ahead: what is drawn so large would squint otherwise.
  Eyeball ball{head.eye.centre, head.eye.radius_mm, 0};
  const glm::vec3 colour = purify(look.iris);
  std::vector<HeadPart> parts;
  const auto add = [&](const char* name, const char* material, const glm::vec3& srgb) -> Mesh& {
    parts.push_back(make_part(fmt::format("{}_left", name), material, srgb));
    return parts.back().part.rest;
  };
  append_zone(add("eye", "ink_white", {1, 0.99f, 0.97f}), ball, iris, 0.75 * std::numbers::pi, 20);
  append_zone(add("eye_rim", "ink_flat", 0.28f * colour), ball, kRim * iris, iris, 3);
  // The lower part is the brighter one.
  Mesh& upper = add("iris", "ink_flat", 0.78f * colour);
  append_zone(upper, ball, pupil, kRim * iris, 8);
  Mesh lower = upper;
  std::erase_if(upper.triangles, [&](const Triangle& t) {
    return (upper.positions[t[0]].y + upper.positions[t[1]].y + upper.positions[t[2]].y) / 3 <
           head.eye.centre.y - 0.06 * head.eye.radius_mm;
  });
  std::erase_if(lower.triangles, [&](const Triangle& t) {
    return (lower.positions[t[0]].y + lower.positions[t[1]].y + lower.positions[t[2]].y) / 3 >=
           head.eye.centre.y - 0.06 * head.eye.radius_mm;
  });
  add("iris_low", "ink_flat", glm::clamp(1.3f * colour + 0.06f, 0.0f, 1.0f)) = std::move(lower);
  append_zone(add("pupil", "ink_flat", {0.06f, 0.04f, 0.06f}), ball, 0, pupil, 4);
  const double size = iris / 0.6;
  Eyeball glass = ball;
  glass.radius_mm *= 1.02;
  Mesh& lights = add("eye_light", "ink_flat", {1, 1, 1});
  append_zone(lights, glass, 0, 0.155 * size, 3, {-0.23 * size, 0.24 * size});
  append_zone(lights, glass, 0, 0.075 * size, 2, {0.20 * size, -0.22 * size});
  const std::size_t count = parts.size();
  for (std::size_t i = 0; i < count; ++i) {
    HeadPart right = parts[i];
    right.mount = Mount::eye_right;
    right.part.name.replace(right.part.name.size() - 4, 4, "right");
    const bool is_light = right.part.name.starts_with("eye_light");
    for (glm::vec3& p : right.part.rest.positions)
      p.x = is_light ? p.x - 2 * static_cast<float>(head.eye.centre.x) : -p.x;  // one lamp lights both
    if (!is_light) {
      for (glm::vec3& n : right.part.rest.normals) n.x = -n.x;
      for (Triangle& t : right.part.rest.triangles) std::swap(t[1], t[2]);
    }
    parts.push_back(std::move(right));
  }
  return parts;
}

}  // namespace mien

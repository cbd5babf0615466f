#include "head/ink_eyes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "config/part_numbers.hpp"
#include "core/conventions.hpp"
#include "head/ink_colours.hpp"
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
  double radius_mm = 1;
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

// Of a zone: all about it, or the part between two of the spokes that it is made of.
struct Sector {
  int first = 0, count = kSpokes;
};

// Rings of the ball from one angle to another, about a middle that lies `aside` of its axis; a disc if they
// begin at 0.
void append_zone(Mesh& mesh, const Eyeball& ball, double from, double to, int rings,
                 const glm::dvec2& aside = {}, const Sector& sector = {}) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const int columns = sector.count == kSpokes ? kSpokes : sector.count + 1;
  for (int r = 0; r <= rings; ++r)
    for (int k = 0; k < columns; ++k) {
      glm::dvec3 p(find_on_ball(ball.radius_mm, from + (to - from) * r / rings,
                                2 * std::numbers::pi * (sector.first + k) / kSpokes));
      const auto tip = [](double& a, double& b, double angle) {  // turns b toward a
        const double s = std::sin(angle), c = std::cos(angle), was = a;
        a = a * c + b * s;
        b = b * c - was * s;
      };
      tip(p.x, p.z, aside.x);
      tip(p.y, p.z, aside.y);
      mesh.normals.push_back(glm::vec3(glm::normalize(p)));
      mesh.positions.push_back(glm::vec3(ball.centre + p));
    }
  for (int r = 0; r < rings; ++r)
    for (int k = 0; k < sector.count; ++k) {
      const auto at = [&](int ring, int spoke) {
        return first + static_cast<std::uint32_t>(ring * columns + spoke % columns);
      };
      if (r > 0 || from > 0) mesh.triangles.push_back({at(r, k), at(r + 1, k), at(r, k + 1)});
      mesh.triangles.push_back({at(r, k + 1), at(r + 1, k), at(r + 1, k + 1)});
    }
}

}  // namespace

std::vector<HeadPart> build_ink_eyes(const NeutralHead& head, const Look& look) {
  const double iris = head.design.iris_deg * kRadiansPerDegree,
               pupil = head.design.pupil_deg * kRadiansPerDegree;
  // Drawn eyes look straight ahead: what is drawn so large would squint otherwise.
  const Eyeball ball{head.eye.centre, head.eye.radius_mm};
  const glm::vec3 colour = purify(look.iris, 1.9f, 1.15f);
  std::vector<HeadPart> parts;
  const auto add = [&](const char* name, const char* material, const glm::vec3& srgb) -> Mesh& {
    parts.push_back(make_part(fmt::format("{}_left", name), material, srgb));
    return parts.back().part.rest;
  };
  append_zone(add("eye", "ink_white", {1, 0.99f, 0.97f}), ball, iris, 0.75 * std::numbers::pi, 20);
  append_zone(add("eye_rim", "ink_flat", 0.28f * colour), ball, kRim * iris, iris, 3);
  // The lower part is the brighter one; it begins a little below the middle.
  constexpr Sector kLower{kSpokes / 2 + 1, kSpokes / 2 - 2}, kUpper{-1, kSpokes / 2 + 2};
  append_zone(add("iris", "ink_flat", 0.78f * colour), ball, pupil, kRim * iris, 8, {}, kUpper);
  append_zone(add("iris_low", "ink_flat", glm::clamp(1.3f * colour + 0.06f, 0.0f, 1.0f)), ball, pupil,
              kRim * iris, 8, {}, kLower);
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

#include "frames/ink_hair.hpp"

#include <algorithm>
#include <cmath>

#include "core/smooth.hpp"
#include "head/hair_lines.hpp"
#include "head/tubes.hpp"

namespace mien {

std::vector<float> measure_before(const std::vector<glm::vec3>& hair) {
  constexpr float kFront_deg = 50, kSide_deg = 78;
  constexpr float kForehead = 0.4f, kCrown = 0.75f;  // of the way up the crown's ball
  const Box box = compute_bounds(hair);
  const float middle = 0.5f * (box.low.z + box.high.z), radius = 0.5f * (box.high.x - box.low.x);
  std::vector<float> before;
  for (const glm::vec3& p : hair) {
    const float aside_deg = glm::degrees(std::atan2(std::abs(p.x), p.z - middle)),
                up = 1 - (box.high.y - p.y) / radius;
    before.push_back((1 - smooth_step(kFront_deg, kSide_deg, aside_deg)) *
                     (1 - smooth_step(kForehead, kCrown, up)));
  }
  return before;
}

void round_hair(const Box& ball, const glm::vec3& camera, const std::vector<glm::vec3>& positions,
                std::vector<glm::vec3>& normals) {
  constexpr float kOwn = 0;
  const glm::vec3 middle = 0.5f * (ball.low + ball.high);
  const float radius = 0.5f * (ball.high.x - ball.low.x);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const glm::vec3 way = (positions[v] - middle) / radius;
    const glm::vec2 level(way.x, way.z);
    const glm::vec2 around = level / std::max(glm::length(level), 1e-6f);
    const float up = std::clamp(way.y, -1.0f, 1.0f);
    const float flat = std::sqrt(1 - up * up);
    const glm::vec3 out(flat * around.x, up, flat * around.y);
    // POV-Ray turns round what looks away.
    constexpr float kToward = 0.02f;
    const glm::vec3 seen = glm::normalize(positions[v] - camera);
    const glm::vec3 normal = kOwn * normals[v] + (1 - kOwn) * out;
    normals[v] = glm::normalize(normal - std::max(0.0f, glm::dot(normal, seen) + kToward) * seen);
  }
}

void tuck_far_lock(const Ink& ink, const InkSight& sight, const Drawing& drawing,
                   std::vector<glm::vec3>& hair) {
  constexpr float kFront = 0.2f, kTurned = 0.45f;  // sines of the camera's way round the head
  constexpr float kBack_mm = 45, kMiddle_mm = 8, kFar_mm = 28, kLow_mm = 22, kFore_mm = 60, kHind_mm = 140;
  const float turned = smooth_step(kFront, kTurned, std::abs(sight.aside)) * (1 - sight.beside);
  if (turned == 0 || !ink.hides_ears || !ink.redraw.lens.is_on()) return;
  const glm::mat4& skull = drawing.parts[ink.teeth].world_from_rest;
  const glm::vec3 right = glm::normalize(glm::vec3(skull[0])), up = glm::normalize(glm::vec3(skull[1])),
                  back = -glm::normalize(glm::vec3(skull[2]));
  const glm::vec3 lip = drawing.parts.front().positions[ink.lips[1]];
  const float size = ink.eye_size, far = sight.aside > 0 ? -1.0f : 1.0f;
  for (glm::vec3& p : hair) {
    const float low = smooth_step(0.0f, kLow_mm * size, glm::dot(lip - p, up)),
                aside = smooth_step(kMiddle_mm * size, kFar_mm * size, far * glm::dot(p - lip, right)),
                fore = 1 - smooth_step(kFore_mm * size, kHind_mm * size, glm::dot(p - lip, back));
    p += turned * low * aside * fore * kBack_mm * size * back;
  }
}

std::vector<InkStroke> list_hair_strokes(const NeutralHead& head, const std::string& cut, const Mesh& mass) {
  constexpr double kWidest = 0.3;  // of its way: where it is
  std::vector<InkStroke> strokes;
  for (const HairLine& line : list_hair_lines(head, cut, mass)) {
    InkStroke& stroke = strokes.emplace_back();
    stroke.rule.name = "hair";
    stroke.rule.is_on_hair = true;
    stroke.rule.widths = {{0, line.begins}, {kWidest, line.width}, {1, line.ends}};
    for (const MeshPlace& place : line.places) stroke.points.push_back({place.vertices, place.shares});
  }
  return strokes;
}

std::vector<Triangle> list_hair_line_triangles(std::uint32_t first) {
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i + 1 < kHairLineSteps; ++i) {
    const std::uint32_t at = first + 2 * i;
    triangles.push_back({at, at + 1, at + 3});
    triangles.push_back({at, at + 3, at + 2});
  }
  return triangles;
}

void append_hair_line(const InkStroke& stroke, const StrokeGround& ground, const glm::vec3& middle,
                      std::vector<glm::vec3>& vertices) {
  constexpr float kLift_mm = 2.4f;                // toward the camera: facets bulge between its places
  constexpr float kAside = 0.12f, kFaced = 0.4f;  // cosines of its normal to the view
  constexpr float kDived_mm = 4;
  constexpr float kThin = 0.16f, kDrawn = 0.26f;  // half its width, in lines: thinner, it would be dots
  std::vector<glm::vec3> way;
  for (const StrokePoint& place : stroke.points) {
    glm::vec3 at(0);
    for (int i = 0; i < 3; ++i) at += place.shares[i] * ground.positions[place.vertices[i]];
    way.push_back(at);
  }
  const auto last = static_cast<double>(way.size() - 1);
  for (int i = 0; i < kHairLineSteps; ++i) {
    constexpr double kReach = 0.02;
    const double at = static_cast<double>(i) / (kHairLineSteps - 1);
    glm::vec3 centre = sample_curve(way, at * last);
    const glm::vec3 along = sample_curve(way, std::min(1.0, at + kReach) * last) -
                            sample_curve(way, std::max(0.0, at - kReach) * last);
    const glm::vec3 toward = glm::normalize(glm::vec3(ground.camera_mm) - centre),
                    up = glm::normalize(centre - middle);
    const glm::vec3 across = glm::cross(along, toward);
    const float length = glm::length(across), shown = smooth_step(kAside, kFaced, glm::dot(up, toward));
    const glm::vec3 aside = length > 1e-6f ? across / length : glm::vec3(1, 0, 0);
    const float wide = static_cast<float>(find_stroke_width(stroke.rule.widths, at)) * shown;
    const float half = static_cast<float>(ground.line_mm) * wide;
    centre += (kLift_mm - kDived_mm * (1 - smooth_step(kThin, kDrawn, wide))) * toward;
    vertices.push_back(centre - half * aside);
    vertices.push_back(centre + half * aside);
  }
}

}  // namespace mien

#include "sketch/overlay.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "core/conventions.hpp"

namespace mien {

namespace {

constexpr std::size_t kSides = 10;  // of a line's section

// Two directions across one, of length 1.
std::array<glm::vec3, 2> find_across(const glm::vec3& along) {
  const glm::vec3 aside = std::abs(along.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 one = glm::normalize(glm::cross(aside, along));
  return {one, glm::cross(along, one)};
}

// A rod from one place to another, each end with a point beyond it; a radius of 0 is a tip.
void append_rod(Mesh& mesh, const glm::vec3& from, const glm::vec3& to, float radius, float far_radius) {
  const glm::vec3 way = to - from;
  const float length = glm::length(way);
  const glm::vec3 along = length > 0 ? way / length : glm::vec3(0, 0, 1);
  const auto [one, other] = find_across(along);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::size_t i = 0; i < kSides; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / kSides;
    const glm::vec3 out = std::cos(angle) * one + std::sin(angle) * other;
    mesh.positions.push_back(from + radius * out);
    mesh.positions.push_back(to + far_radius * out);
  }
  mesh.positions.push_back(from - radius * along);
  mesh.positions.push_back(to + far_radius * along);
  constexpr std::uint32_t kAround = 2 * kSides;
  const std::uint32_t back = first + kAround, front = back + 1;
  for (std::uint32_t i = 0; i < kAround; i += 2) {
    const std::uint32_t a = first + i, b = first + (i + 2) % kAround;
    mesh.triangles.insert(mesh.triangles.end(),
                          {{a, b, b + 1}, {a, b + 1, a + 1}, {back, b, a}, {front, a + 1, b + 1}});
  }
}

void append_words(Mesh& mesh, const OverlayWords& words, const CameraView& view, const Letters& letters) {
  constexpr double kAnyWidth_mm = 1e6;
  const Label label = set_label(letters, words.words, words.size_mm * 0.72, 0, kAnyWidth_mm);
  const double angle = view.angle_deg * kRadiansPerDegree;
  const glm::vec3 right(std::cos(angle), 0, -std::sin(angle));
  const auto radius = static_cast<float>(0.045 * words.size_mm);
  const auto place = [&](const glm::dvec2& p) {
    return words.at + static_cast<float>(p.x + (0.5 - words.align) * label.width_mm) * right +
           glm::vec3(0, static_cast<float>(p.y), 0);
  };
  for (const Stroke& stroke : label.strokes)
    for (std::size_t i = 0; i + 1 < stroke.size(); ++i)
      append_rod(mesh, place(stroke[i]), place(stroke[i + 1]), radius, radius);
}

void append_part(SketchOverlay& overlay, Mesh mesh, const glm::vec3& srgb) {
  if (mesh.triangles.empty()) return;
  Part part;
  part.name = "overlay" + std::to_string(overlay.model.parts.size());
  part.palette = {{srgb, 0}};
  part.rest = std::move(mesh);
  SketchTexture texture;
  for (int i = 0; i < 3; ++i)
    texture.pigment.colour.rgb[i] =
        srgb[i] <= 0.04045f ? srgb[i] / 12.92f : std::pow((srgb[i] + 0.055f) / 1.055f, 2.4f);
  texture.finish.emission = glm::vec3(1);
  SketchPart look;
  look.textures = {texture};
  look.has_shadow = false;
  overlay.look.parts.push_back(std::move(look));
  PartShape shape;
  shape.positions = part.rest.positions;
  overlay.drawing.parts.push_back(std::move(shape));
  overlay.model.parts.push_back(std::move(part));
}

}  // namespace

SketchOverlay build_sketch_overlay(const Overlay& overlay, const CameraView& view, const Letters& letters) {
  SketchOverlay built;
  for (const OverlayLine& line : overlay.lines) {
    Mesh mesh;
    const auto radius = static_cast<float>(line.radius_mm);
    for (const auto& [from, to] : line.segments) append_rod(mesh, from, to, radius, radius);
    for (const auto& [from, to] : line.tips)
      append_rod(mesh, from, to, static_cast<float>(kTipWidth) * radius, 0);
    append_part(built, std::move(mesh), line.srgb);
  }
  for (const OverlayWords& words : overlay.words) {
    Mesh mesh;
    append_words(mesh, words, view, letters);
    append_part(built, std::move(mesh), words.srgb);
  }
  return built;
}

SketchFigure find_figure(const SketchOverlay& overlay) {
  return {&overlay.model, &overlay.look, &overlay.drawing};
}

}  // namespace mien

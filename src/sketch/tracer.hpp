// The triangles of one picture, and where rays meet them.
#pragma once

#include <embree3/rtcore.h>

#include <array>
#include <cstdint>
#include <vector>

#include "sketch/light.hpp"
#include "sketch/sketch.hpp"

namespace mien {

struct SketchRay {
  glm::vec3 from{0}, direction{0};  // of length 1
  float near = 0;                   // mm: what is nearer is not met
};

struct SketchHit {
  static constexpr std::uint32_t kNone = RTC_INVALID_GEOMETRY_ID;
  std::uint32_t part = kNone, triangle = 0;
  float u = 0, v = 0, along_mm = 0;

  bool operator==(const SketchHit&) const = default;
};

// One pixel of the first pass: what it meets, and behind all clear things what stops it.
struct SketchPixel {
  SketchHit hit, base;
  glm::vec3 normal{0};  // of the base, toward the eye
};

struct TracedPart {
  const Part* part = nullptr;
  const SketchPart* look = nullptr;
  const std::vector<Triangle>* triangles = nullptr;
  std::vector<glm::vec3> positions, normals;  // POV-Ray's space; positions have one more, which is none
};

struct SketchTracer {
  SketchTracer();
  SketchTracer(const SketchTracer&) = delete;
  SketchTracer& operator=(const SketchTracer&) = delete;
  ~SketchTracer();

  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<TracedPart> parts;  // of all figures, one after the other
  std::vector<float> seen;        // of each lamp, by one surface at a time: 0 hidden .. 1
  // Of each pixel of one picture:
  std::vector<SketchPixel> pixels;
  std::vector<std::vector<std::uint8_t>> hidden;  // of each lamp with shadows: 1 hidden, 0 seen, 2 not asked
  std::vector<std::vector<float>> visible;        // of the same: 0 hidden .. 1
  std::vector<glm::vec4> light;                   // linear, and how much of a pixel something covers
};

// Makes the scene anew.
void set_figures(SketchTracer& tracer, const std::vector<SketchFigure>& figures);

SketchHit find_hit(const SketchTracer& tracer, const SketchRay& ray);

// kPacket at once; their directions should be near each other.
void find_hits(const SketchTracer& tracer, const SketchRay* rays, SketchHit* hits);

// Whether something stands between a surface and a place.
bool is_hidden(const SketchTracer& tracer, const SketchSurface& surface, const glm::vec3& place);

// The same of eight neighbours at once, those that are asked for.
constexpr std::size_t kPacket = 16;
struct SketchShadows {
  std::array<bool, kPacket> is_asked{}, is_hidden{};
  std::array<glm::vec3, kPacket> at, normal, place;  // of a surface, and of a lamp
};
void find_hidden(const SketchTracer& tracer, SketchShadows& shadows);

// Place and normal alone, and all of it.
SketchSurface find_shape(const SketchTracer& tracer, const SketchRay& ray, const SketchHit& hit);
SketchSurface find_surface(const SketchTracer& tracer, const SketchRay& ray, const SketchHit& hit);

}  // namespace mien

// Embree 3.13: API documentation, "Geometry Objects" and "Ray Masks"; vertices are read in sixteens of bytes,
// so that their buffer is one longer than they are.
#include "sketch/tracer.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"

namespace mien {

namespace {

constexpr unsigned kSeen = 1, kThrowsShadow = 2;
// A shadow's ray begins so far above the surface: less and it meets its own triangle.
constexpr float kAbove_mm = 0.03f;

glm::vec3 to_povray(const glm::vec3& v) { return {v.x, v.y, -v.z}; }

void place_part(const PartShape& shape, const SketchFigure& figure, std::size_t index, TracedPart& traced) {
  const Part& part = figure.model->parts[index];
  traced.part = &part;
  traced.look = &figure.look->parts[index];
  traced.triangles = part.is_outline ? &shape.triangles : &part.rest.triangles;
  traced.positions.clear();
  traced.normals.clear();
  if (is_carried(part, shape)) {
    const glm::mat3 turn(shape.world_from_rest);
    for (const glm::vec3& p : part.rest.positions)
      traced.positions.push_back(to_povray(glm::vec3(shape.world_from_rest * glm::vec4(p, 1))));
    for (const glm::vec3& n : part.rest.normals) traced.normals.push_back(to_povray(turn * n));
  } else {
    for (const glm::vec3& p : shape.positions) traced.positions.push_back(to_povray(p));
    for (const glm::vec3& n : shape.normals) traced.normals.push_back(to_povray(n));
  }
  const std::size_t count = traced.positions.size();
  if ((!part.is_outline && count != part.rest.positions.size()) ||
      (!traced.normals.empty() && traced.normals.size() != count))
    throw RunError(fmt::format("internal: part '{}' is drawn with another number of vertices", part.name));
  traced.positions.emplace_back(0);
}

void attach_part(SketchTracer& tracer, const TracedPart& part, unsigned id) {
  if (part.triangles->empty()) return;
  RTCGeometry geometry = rtcNewGeometry(tracer.device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, part.positions.data(), 0,
                             sizeof(glm::vec3), part.positions.size() - 1);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, part.triangles->data(), 0,
                             sizeof(Triangle), part.triangles->size());
  rtcSetGeometryMask(geometry,
                     (part.look->is_seen ? kSeen : 0) | (part.look->has_shadow ? kThrowsShadow : 0));
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(tracer.scene, geometry, id);
  rtcReleaseGeometry(geometry);
}

// The weights of a triangle's corners where it was hit.
std::array<float, 3> find_weights(const SketchHit& hit) { return {1 - hit.u - hit.v, hit.u, hit.v}; }

void add_finish(SketchFinish& sum, const SketchFinish& finish, float share) {
  sum.diffuse += share * finish.diffuse;
  sum.brilliance += share * finish.brilliance;
  sum.specular += share * finish.specular;
  sum.roughness += share * finish.roughness;
  sum.phong += share * finish.phong;
  sum.phong_size += share * finish.phong_size;
  sum.metallic += share * finish.metallic;
  sum.reflection += share * finish.reflection;
  sum.emission += share * finish.emission;
}

}  // namespace

SketchTracer::SketchTracer() : device(rtcNewDevice(nullptr)) {
  if (!device) throw RunError("Embree cannot be started");
}

SketchTracer::~SketchTracer() {
  if (scene) rtcReleaseScene(scene);
  rtcReleaseDevice(device);
}

void set_figures(SketchTracer& tracer, const std::vector<SketchFigure>& figures) {
  if (tracer.scene) rtcReleaseScene(tracer.scene);
  tracer.scene = rtcNewScene(tracer.device);
  rtcSetSceneBuildQuality(tracer.scene, RTC_BUILD_QUALITY_MEDIUM);
  std::size_t count = 0;
  for (const SketchFigure& figure : figures) count += figure.model->parts.size();
  tracer.parts.resize(count);
  unsigned id = 0;
  for (const SketchFigure& figure : figures) {
    if (figure.drawing->parts.size() != figure.model->parts.size())
      throw RunError("internal: a drawing has not the model's parts");
    for (std::size_t i = 0; i < figure.model->parts.size(); ++i, ++id) {
      place_part(figure.drawing->parts[i], figure, i, tracer.parts[id]);
      attach_part(tracer, tracer.parts[id], id);
    }
  }
  rtcCommitScene(tracer.scene);
  if (const RTCError error = rtcGetDeviceError(tracer.device); error != RTC_ERROR_NONE)
    throw RunError(fmt::format("Embree failed with error {}", static_cast<int>(error)));
}

SketchHit find_hit(const SketchTracer& tracer, const SketchRay& ray) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit both{};
  both.ray.org_x = ray.from.x;
  both.ray.org_y = ray.from.y;
  both.ray.org_z = ray.from.z;
  both.ray.dir_x = ray.direction.x;
  both.ray.dir_y = ray.direction.y;
  both.ray.dir_z = ray.direction.z;
  both.ray.tnear = ray.near;
  both.ray.tfar = 1e30f;
  both.ray.mask = kSeen;
  both.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(tracer.scene, &context, &both);
  return {both.hit.geomID, both.hit.primID, both.hit.u, both.hit.v, both.ray.tfar};
}

void find_hits(const SketchTracer& tracer, const SketchRay* rays, SketchHit* hits) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  alignas(64) std::array<int, kPacket> valid;
  RTCRayHit16 both{};
  for (std::size_t i = 0; i < kPacket; ++i) {
    valid[i] = -1;
    both.ray.org_x[i] = rays[i].from.x;
    both.ray.org_y[i] = rays[i].from.y;
    both.ray.org_z[i] = rays[i].from.z;
    both.ray.dir_x[i] = rays[i].direction.x;
    both.ray.dir_y[i] = rays[i].direction.y;
    both.ray.dir_z[i] = rays[i].direction.z;
    both.ray.tnear[i] = rays[i].near;
    both.ray.tfar[i] = 1e30f;
    both.ray.mask[i] = kSeen;
    both.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
  }
  rtcIntersect16(valid.data(), tracer.scene, &context, &both);
  for (std::size_t i = 0; i < kPacket; ++i)
    hits[i] = {both.hit.geomID[i], both.hit.primID[i], both.hit.u[i], both.hit.v[i], both.ray.tfar[i]};
}

bool is_hidden(const SketchTracer& tracer, const SketchSurface& surface, const glm::vec3& place) {
  const glm::vec3 from = surface.at + kAbove_mm * surface.normal, way = place - from;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray{};
  ray.org_x = from.x;
  ray.org_y = from.y;
  ray.org_z = from.z;
  ray.dir_x = way.x;
  ray.dir_y = way.y;
  ray.dir_z = way.z;
  ray.tnear = 0;
  ray.tfar = 1;
  ray.mask = kThrowsShadow;
  rtcOccluded1(tracer.scene, &context, &ray);
  return ray.tfar < 0;
}

void find_hidden(const SketchTracer& tracer, SketchShadows& shadows) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  alignas(64) std::array<int, kPacket> valid;
  RTCRay16 rays{};
  for (std::size_t i = 0; i < kPacket; ++i) {
    valid[i] = shadows.is_asked[i] ? -1 : 0;
    if (!shadows.is_asked[i]) continue;
    const glm::vec3 from = shadows.at[i] + kAbove_mm * shadows.normal[i], way = shadows.place[i] - from;
    rays.org_x[i] = from.x;
    rays.org_y[i] = from.y;
    rays.org_z[i] = from.z;
    rays.dir_x[i] = way.x;
    rays.dir_y[i] = way.y;
    rays.dir_z[i] = way.z;
    rays.tfar[i] = 1;
    rays.mask[i] = kThrowsShadow;
  }
  rtcOccluded16(valid.data(), tracer.scene, &context, &rays);
  for (std::size_t i = 0; i < kPacket; ++i) shadows.is_hidden[i] = rays.tfar[i] < 0;
}

SketchSurface find_shape(const SketchTracer& tracer, const SketchRay& ray, const SketchHit& hit) {
  const TracedPart& part = tracer.parts[hit.part];
  const Triangle& corners = (*part.triangles)[hit.triangle];
  const std::array<float, 3> weights = find_weights(hit);
  SketchSurface surface;
  surface.at = ray.from + hit.along_mm * ray.direction;
  if (part.normals.empty()) {
    const glm::vec3& a = part.positions[corners[0]];
    surface.normal = glm::cross(part.positions[corners[1]] - a, part.positions[corners[2]] - a);
  } else {
    for (std::size_t i = 0; i < 3; ++i) surface.normal += weights[i] * part.normals[corners[i]];
  }
  const float length = glm::length(surface.normal);
  surface.normal = length > 0 ? surface.normal / length : -ray.direction;
  return surface;
}

SketchSurface find_surface(const SketchTracer& tracer, const SketchRay& ray, const SketchHit& hit) {
  SketchSurface surface = find_shape(tracer, ray, hit);
  const TracedPart& traced = tracer.parts[hit.part];
  const Part& part = *traced.part;
  const Triangle& corners = (*traced.triangles)[hit.triangle];
  const std::array<float, 3> weights = find_weights(hit);
  SketchPlace place{surface.at, {}, surface.normal};
  if (!part.grain.empty())
    for (std::size_t i = 0; i < 3; ++i) place.grain += weights[i] * part.grain[corners[i]];
  if (glm::dot(surface.normal, ray.direction) > 0) surface.normal = -surface.normal;

  const std::vector<SketchTexture>& textures = traced.look->textures;
  const auto take = [&](std::size_t index) {
    const SketchTexture& texture = find_texture(textures[index], place);
    surface.colour = sample_pigment(texture.pigment, place);
    surface.finish = texture.finish;
    if (texture.bumps.depth != 0) {
      SketchPlace turned = place;
      turned.normal = surface.normal;
      surface.normal = bend_normal(texture.bumps, turned);
    }
  };
  if (!part.triangle_shade.empty()) {
    take(part.triangle_shade[hit.triangle]);
    return surface;
  }
  if (part.shade.empty()) {
    take(0);
    return surface;
  }
  const std::array<std::size_t, 3> shades{part.shade[corners[0]], part.shade[corners[1]],
                                          part.shade[corners[2]]};
  if (shades[0] == shades[1] && shades[1] == shades[2]) {
    take(shades[0]);
    return surface;
  }
  SketchFinish finish{0, 0, 0, 0, 0, 0, 0, 0, glm::vec3(0)};
  SketchColour colour;
  const glm::vec3 normal = surface.normal;
  for (std::size_t i = 0; i < 3; ++i) {
    surface.normal = normal;
    take(shades[i]);
    add_finish(finish, surface.finish, weights[i]);
    colour.rgb += weights[i] * surface.colour.rgb;
    colour.filter += weights[i] * surface.colour.filter;
    colour.transmit += weights[i] * surface.colour.transmit;
  }
  surface.finish = finish;
  surface.colour = colour;
  return surface;
}

}  // namespace mien

#include "sketch/casters.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace mien {

namespace {

constexpr std::size_t kFewest = 2000;  // triangles of a part that is looked at
constexpr std::size_t kMostLamps = 32;
// A triangle faces a lamp if it does so by more than this (the cosine), from every corner of the lamp's
// cloth; likewise away.
constexpr float kClearly = 0.02f;
constexpr float kBelow_mm = 0.05f, kDeep_mm = 1;  // how far below the skin a caster lies
constexpr double kMostOpen = 0.004;  // of a closed part's edges: a bust is open below and behind its lids

// A lamp that throws shadows: its place, or the corners of its cloth. In mien's space.
using LampCorners = std::vector<glm::vec3>;

glm::vec3 from_povray(const glm::vec3& v) { return {v.x, v.y, -v.z}; }

std::vector<LampCorners> list_lamps(const SketchStage& stage) {
  std::vector<LampCorners> lamps;
  for (const SketchLamp& lamp : stage.lamps) {
    if (!lamp.has_shadow || lamp.colour == glm::vec3(0)) continue;
    LampCorners& corners = lamps.emplace_back();
    if (lamp.side == glm::vec3(0)) {
      corners = {from_povray(lamp.at)};
      continue;
    }
    for (const float u : {-0.5f, 0.5f})
      for (const float v : {-0.5f, 0.5f})
        corners.push_back(from_povray(lamp.at + u * lamp.side + v * lamp.other_side));
  }
  return lamps;
}

bool throws_shadow(const Part& part, const SketchStage& stage) {
  const std::string macro = part.material + "_object";
  if (!stage.names.macros.contains(macro)) return true;
  SdlNames names = stage.names;
  return !has_word(read_sdl(macro + "()\n", part.material, names), "no_shadow");
}

// 1: a triangle faces all of a lamp, -1: it is turned away from all of it, 0: neither, or it has no side.
int find_side(const PartShape& shape, const Triangle& triangle, const LampCorners& lamp) {
  const glm::vec3 &a = shape.positions[triangle[0]], &b = shape.positions[triangle[1]],
                  &c = shape.positions[triangle[2]];
  const glm::vec3 normal = glm::cross(b - a, c - a), middle = (a + b + c) / 3.0f;
  int facing = 0, away = 0;
  for (const glm::vec3& corner : lamp) {
    const glm::vec3 way = corner - middle;
    const float along = glm::dot(normal, way);
    if (along * along <= kClearly * kClearly * glm::dot(normal, normal) * glm::dot(way, way)) continue;
    (along > 0 ? facing : away) += 1;
  }
  const int all = static_cast<int>(lamp.size());
  return facing == all ? 1 : away == all ? -1 : 0;
}

constexpr std::uint32_t kNoKind = ~std::uint32_t{0};

// By triangle: a bit for each lamp that it faces; kNoKind if a lamp sees it from the side.
std::vector<std::uint32_t> find_kinds(const Part& part, const PartShape& shape,
                                      const std::vector<LampCorners>& lamps) {
  const std::vector<Triangle>& triangles = part.rest.triangles;
  std::vector<std::uint32_t> kinds(triangles.size(), 0);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t lamp = 0; lamp < lamps.size() && kinds[i] != kNoKind; ++lamp) {
      const int side = find_side(shape, triangles[i], lamps[lamp]);
      if (side == 0)
        kinds[i] = kNoKind;
      else if (side > 0)
        kinds[i] |= std::uint32_t{1} << lamp;
    }
  return kinds;
}

// The most frequent kind that faces a lamp; kNoKind if there is none.
std::uint32_t find_largest_kind(const std::vector<std::uint32_t>& kinds) {
  std::map<std::uint32_t, std::size_t> counts;
  for (const std::uint32_t kind : kinds)
    if (kind != kNoKind && kind != 0) ++counts[kind];
  if (counts.empty()) return kNoKind;
  return std::ranges::max_element(counts, {}, [](const auto& count) { return count.second; })->first;
}

bool faces_all(const PartShape& shape, const Triangle& triangle, const std::vector<LampCorners>& lamps,
               std::uint32_t kind) {
  for (std::size_t lamp = 0; lamp < lamps.size(); ++lamp)
    if ((kind >> lamp & 1) != 0 && find_side(shape, triangle, lamps[lamp]) <= 0) return false;
  return true;
}

// The triangles of the largest kind go. Those that face its lamps and stay, for another lamp's sake, lie deep
// enough that no place of the skin is in their shadow.
Mesh build_caster(const Part& part, const PartShape& shape, const std::vector<LampCorners>& lamps) {
  Mesh caster;
  const std::vector<std::uint32_t> kinds = find_kinds(part, shape, lamps);
  const std::uint32_t largest = find_largest_kind(kinds);
  if (largest == kNoKind) return caster;
  constexpr std::uint32_t kNowhere = ~std::uint32_t{0};
  std::array<std::vector<std::uint32_t>, 2>
      places;  // of a vertex in the caster; the second of one that lies deep
  for (auto& place : places) place.assign(shape.positions.size(), kNowhere);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (kinds[i] == largest) continue;
    Triangle triangle = part.rest.triangles[i];
    const bool is_deep = faces_all(shape, triangle, lamps, largest);
    for (std::uint32_t& v : triangle) {
      std::uint32_t& at = places[is_deep ? 1 : 0][v];
      if (at == kNowhere) {
        at = static_cast<std::uint32_t>(caster.positions.size());
        caster.positions.push_back(shape.positions[v] - (is_deep ? kDeep_mm : kBelow_mm) * shape.normals[v]);
      }
      v = at;
    }
    caster.triangles.push_back(triangle);
  }
  return caster;
}

}  // namespace

std::vector<bool> list_castable(const Model& model) {
  std::vector<bool> castable;
  for (const Part& part : model.parts) {
    const std::vector<Triangle>& triangles = part.rest.triangles;
    const double edges = 1.5 * static_cast<double>(triangles.size());
    castable.push_back(!part.is_rigid && !part.is_outline && triangles.size() >= kFewest &&
                       static_cast<double>(count_open_edges(triangles)) < kMostOpen * edges);
  }
  return castable;
}

std::vector<Mesh> build_casters(const SketchStage& stage, const Model& model, const Drawing& drawing,
                                const std::vector<bool>& castable) {
  std::vector<Mesh> casters(model.parts.size());
  const std::vector<LampCorners> lamps = list_lamps(stage);
  if (lamps.empty() || lamps.size() >= kMostLamps) return casters;
  for (std::size_t i = 0; i < casters.size(); ++i)
    if (castable[i] && drawing.parts[i].normals.size() == drawing.parts[i].positions.size() &&
        throws_shadow(model.parts[i], stage))
      casters[i] = build_caster(model.parts[i], drawing.parts[i], lamps);
  return casters;
}

}  // namespace mien

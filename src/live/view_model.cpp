#include "live/view_model.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/pool.hpp"
#include "live/coarse.hpp"

namespace mien {

namespace {

std::uint8_t to_byte(float share) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0f, 1.0f)));
}

glm::u8vec4 pack_colour(const SketchColour& colour) {
  const glm::vec3 root = glm::sqrt(glm::max(colour.rgb, glm::vec3(0)));
  // Filters tint what lies behind; here they let the same of each colour through.
  const float through = std::clamp(
      colour.transmit + colour.filter * (colour.rgb.r + colour.rgb.g + colour.rgb.b) / 3, 0.0f, 1.0f);
  return {to_byte(root.r), to_byte(root.g), to_byte(root.b), to_byte(through)};
}

ViewFinish take_finish(const SketchFinish& finish) {
  return {finish.diffuse,    finish.brilliance, finish.specular,   finish.roughness, finish.phong,
          finish.phong_size, finish.metallic,   finish.reflection, finish.emission};
}

// The colour that a vertex has of one of the part's shades, at rest.
SketchColour sample_vertex(const Part& part, const SketchPart& look, std::uint32_t vertex,
                           std::size_t shade) {
  SketchPlace place;
  const glm::vec3 at = part.rest.positions[vertex];
  place.at = {at.x, at.y, -at.z};
  if (!part.rest.normals.empty()) {
    const glm::vec3 n = part.rest.normals[vertex];
    place.normal = {n.x, n.y, -n.z};
  }
  if (!part.grain.empty()) place.grain = part.grain[vertex];
  return sample_pigment(find_texture(look.textures[shade], place).pigment, place);
}

std::size_t find_shade(const Part& part, std::size_t triangle, std::uint32_t vertex) {
  if (!part.triangle_shade.empty()) return part.triangle_shade[triangle];
  return part.shade.empty() ? 0 : part.shade[vertex];
}

ViewPart build_view_part(const Part& part, const SketchPart& look) {
  ViewPart view;
  view.name = part.name;
  view.material = part.material;
  view.is_clear = look.is_clear;
  view.is_seen = look.is_seen;
  view.has_shadow = look.has_shadow;
  view.is_rigid = part.is_rigid && !part.may_bend;
  if (part.may_bend) view.unbent = {part.rest.positions, part.rest.normals, {}};
  view.is_outline = part.is_outline;
  view.finish = take_finish(look.textures.front().finish);
  if (part.is_outline) {
    view.colours.push_back(pack_colour(look.textures.front().pigment.colour));
    return view;
  }
  constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> first(part.rest.positions.size(), kNone);  // of a vertex in its first shade
  std::vector<std::size_t> first_shade(first.size());
  std::map<std::pair<std::uint32_t, std::size_t>, std::uint32_t> others;
  const auto add = [&](std::uint32_t vertex, std::size_t shade) {
    view.vertices.push_back(vertex);
    view.colours.push_back(pack_colour(sample_vertex(part, look, vertex, shade)));
    return static_cast<std::uint32_t>(view.vertices.size() - 1);
  };
  for (std::size_t t = 0; t < part.rest.triangles.size(); ++t) {
    Triangle corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t vertex = part.rest.triangles[t][i];
      const std::size_t shade = find_shade(part, t, vertex);
      if (first[vertex] == kNone) {
        first[vertex] = add(vertex, shade);
        first_shade[vertex] = shade;
      }
      if (first_shade[vertex] == shade) {
        corners[i] = first[vertex];
        continue;
      }
      const auto [entry, is_new] = others.try_emplace({vertex, shade}, 0u);
      if (is_new) entry->second = add(vertex, shade);
      corners[i] = entry->second;
    }
    view.triangles.push_back(corners);
  }
  view.pieces = take_pieces(view);
  return view;
}

void append_bytes(std::string& bytes, const void* data, std::size_t size) {
  bytes.append(static_cast<const char*>(data), size);
}

std::int16_t to_step(float mm) {
  return static_cast<std::int16_t>(std::lround(std::clamp(mm / kViewStep_mm, -32767.0f, 32767.0f)));
}

// Places first, then normals: a page takes both as they come.
void append_vertices(std::string& bytes, const std::vector<std::uint32_t>& vertices,
                     const std::vector<glm::vec3>& positions, const std::vector<glm::vec3>& normals) {
  std::vector<std::array<std::int16_t, 4>> places;
  std::vector<std::array<std::int8_t, 4>> ways;
  places.reserve(vertices.size());
  ways.reserve(vertices.size());
  const auto part = [](float x) { return static_cast<std::int8_t>(std::lround(127 * x)); };
  for (const std::uint32_t vertex : vertices) {
    const glm::vec3& p = positions[vertex];
    const glm::vec3 n = normals.empty() ? glm::vec3(0, 0, 1) : normals[vertex];
    places.push_back({to_step(p.x), to_step(p.y), to_step(p.z), 0});
    ways.push_back({part(n.x), part(n.y), part(n.z), 0});
  }
  append_bytes(bytes, places.data(), places.size() * sizeof places[0]);
  append_bytes(bytes, ways.data(), ways.size() * sizeof ways[0]);
}

Mesh place_unbent(const Mesh& rest, const glm::mat4& world_from_rest) {
  Mesh placed;
  const glm::mat3 turn(world_from_rest);
  for (const glm::vec3& p : rest.positions) placed.positions.emplace_back(world_from_rest * glm::vec4(p, 1));
  for (const glm::vec3& n : rest.normals) placed.normals.push_back(turn * n);
  return placed;
}

}  // namespace

ViewModel build_view_model(const Model& model, const SketchLook& look) {
  ViewModel view;
  for (std::size_t i = 0; i < model.parts.size(); ++i)
    if (look.parts[i].is_seen || look.parts[i].has_shadow) view.of.push_back(i);
  view.parts.resize(view.of.size());
  for_each_index(view.of.size(), count_workers(), [&](std::size_t i, int) {
    view.parts[i] = build_view_part(model.parts[view.of[i]], look.parts[view.of[i]]);
  });
  return view;
}

void append_shape(std::string& bytes, const ViewPart& part, const PartShape& shape) {
  if (part.is_rigid) {
    append_bytes(bytes, &shape.world_from_rest, sizeof shape.world_from_rest);
  } else if (part.is_outline) {
    std::vector<std::uint32_t> all(shape.positions.size());
    std::iota(all.begin(), all.end(), 0u);
    append_vertices(bytes, all, shape.positions, shape.normals);
    append_bytes(bytes, shape.triangles.data(), shape.triangles.size() * sizeof(Triangle));
  } else if (shape.positions.empty() && !part.unbent.positions.empty()) {
    const Mesh placed = place_unbent(part.unbent, shape.world_from_rest);
    append_vertices(bytes, part.vertices, placed.positions, placed.normals);
  } else {
    append_vertices(bytes, part.vertices, shape.positions, shape.normals);
  }
}

void append_model(std::string& bytes, const ViewPart& part, const Mesh& rest) {
  append_bytes(bytes, part.colours.data(), part.colours.size() * sizeof(glm::u8vec4));
  append_bytes(bytes, part.triangles.data(), part.triangles.size() * sizeof(Triangle));
  append_bytes(bytes, part.pieces.data(), part.pieces.size() * sizeof(Triangle));
  if (part.is_rigid) append_vertices(bytes, part.vertices, rest.positions, rest.normals);
}

}  // namespace mien

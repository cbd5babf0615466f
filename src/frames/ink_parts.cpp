#include "frames/ink_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/smooth.hpp"
#include "head/beard.hpp"
#include "head/cage.hpp"
#include "head/hair_chart.hpp"
#include "head/ink_colours.hpp"

namespace mien {

namespace {

template <typename Keeps>
void keep_triangles(Part& part, const Keeps& keeps) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < part.rest.triangles.size(); ++i) {
    if (!keeps(part.rest.triangles[i])) continue;
    part.rest.triangles[kept] = part.rest.triangles[i];
    if (!part.triangle_shade.empty()) part.triangle_shade[kept] = part.triangle_shade[i];
    ++kept;
  }
  part.rest.triangles.resize(kept);
  if (!part.triangle_shade.empty()) part.triangle_shade.resize(kept);
}

// Of a band between pairs of points, upper and lower in turn.
void append_band(std::size_t points, std::vector<Triangle>& triangles) {
  for (std::uint32_t v = 0; v + 3 < points; v += 2) {
    triangles.push_back({v, v + 1, v + 3});
    triangles.push_back({v, v + 3, v + 2});
  }
}

// Seen from below, the backs of the upper teeth and the palate are mouth: white is what looks outward from
// the arch, and of the gum what lies at the teeth's outside.
void darken_backs(const InkColours& colours, const Ink& ink, Part& part) {
  constexpr float kLeast = 0.6f;  // cosine; lower, and cusps are specks in the dark
  constexpr float kBeside = 0.99f, kInside_mm = 3.5f;
  constexpr float kRow = 0.55f;  // of the arch's depth: teeth behind it would be hooks at the row's ends
  const Mesh& teeth = ink.model.parts[find_model_part(ink.model, "teeth_upper")].rest;
  const Box box = compute_bounds(teeth.positions);
  const float back_mm = box.low.z, row_mm = std::lerp(box.high.z, box.low.z, kRow);
  const auto find_way = [&](const glm::vec3& p) { return glm::vec2(p.x, p.z - back_mm); };
  const auto is_outside = [&](const glm::vec3& p) {
    const glm::vec2 way = find_way(p);
    float outside_mm = 0;
    for (const glm::vec3& tooth : teeth.positions) {
      const glm::vec2 other = find_way(tooth);
      if (glm::dot(way, other) > kBeside * glm::length(way) * glm::length(other))
        outside_mm = std::max(outside_mm, glm::length(other));
    }
    return glm::length(way) > outside_mm - kInside_mm * ink.eye_size;
  };
  part.palette.push_back({colours.cavity, 0});
  for (const Triangle& t : part.rest.triangles) {
    const glm::vec3 &a = part.rest.positions[t[0]], &b = part.rest.positions[t[1]],
                    &c = part.rest.positions[t[2]];
    const glm::vec2 way = find_way((a + b + c) / 3.0f);
    const glm::vec3 normal = glm::cross(b - a, c - a);
    const bool looks_out =
        glm::dot(glm::vec2(normal.x, normal.z), way) >= kLeast * glm::length(normal) * glm::length(way);
    const bool is_outer = part.name == "gum_upper" && is_outside(a) && is_outside(b) && is_outside(c);
    const bool is_in_row = std::max({a.z, b.z, c.z}) > row_mm;
    part.triangle_shade.push_back((looks_out || is_outer) && is_in_row ? 0 : 1);
  }
}

// Teeth that have come through as far as their row: the edges of an infant's first ones would be dots.
bool has_teeth(const Ink& ink) {
  constexpr float kThrough_mm = 1;
  const auto find_edge = [&](const char* name) {
    return compute_bounds(ink.model.parts[find_model_part(ink.model, name)].rest.positions).low.y;
  };
  return find_edge("gum_upper") - find_edge("teeth_upper") > kThrough_mm * ink.eye_size;
}

// What the parts of a real head become; their own tones where nothing is said. Teeth and their gum are one
// white band: the gum's scallops would leave it in pieces.
void set_material(const Look& look, const InkColours& colours, const Ink& ink, bool has_row, Part& part) {
  const auto flat = [&](const glm::vec3& srgb) {
    part.material = "ink_flat";
    part.palette = {{srgb, 0}};
    part.shade.clear();
  };
  if (part.name == "teeth_upper" || part.name == "gum_upper") {
    flat(has_row ? colours.bone : colours.cavity);
    darken_backs(colours, ink, part);
  }
  if (part.name == "teeth_lower" || part.name == "gum_lower" || part.name == "lip_veil")
    flat(colours.cavity);  // what shows of lower teeth beside a tongue is crumbs
  if (part.name == "tongue") flat(colours.flesh);
  const bool is_beard = part.name.starts_with("beard");
  if (!part.name.starts_with("hair") && !is_beard) return;
  const glm::vec3 srgb = find_ink_hair(is_beard ? compute_beard_colour(look) : look.hair);
  part.palette = {{srgb, 0}};
  if (!part.triangle_shade.empty()) part.palette.push_back({srgb, 1});  // the ring of light
  part.material = "ink_hair";
  part.shade.clear();
  part.grain.clear();
  part.wear = 0;
}

}  // namespace

Part make_flat_part(std::string name, const char* material, const glm::vec3& srgb) {
  Part part;
  part.name = std::move(name);
  part.material = material;
  part.palette = {{srgb, 0}};
  part.is_printed = false;
  return part;
}

std::size_t find_model_part(const Model& model, std::string_view name) {
  const auto found = std::ranges::find(model.parts, name, &Part::name);
  if (found == model.parts.end()) throw RunError(fmt::format("internal: a drawn head without {}", name));
  return static_cast<std::size_t>(found - model.parts.begin());
}

void set_materials(const Look& look, const InkColours& colours, Ink& ink) {
  const bool has_row = has_teeth(ink);
  for (Part& part : ink.model.parts) set_material(look, colours, ink, has_row, part);
}

void hide_ears(const Figure& figure, Ink& ink) {
  const auto cut = figure.head.data->hair.cuts.find(figure.hair);
  if (cut == figure.head.data->hair.cuts.end() || !cut->second.covers_ears) return;
  ink.hides_ears = true;
  std::vector<bool> is_ear;
  for (const HairGround ground : list_hair_grounds(figure.head)) is_ear.push_back(ground == HairGround::ear);
  for (const auto& [a, b] : figure.folds.skin.parents) is_ear.push_back(is_ear[a] && is_ear[b]);
  for (const auto& [from, to, share] : ink.cuts) is_ear.push_back(is_ear[from] && is_ear[to]);
  const auto is_hidden = [&](const Triangle& t) { return is_ear[t[0]] || is_ear[t[1]] || is_ear[t[2]]; };
  keep_triangles(ink.model.parts.front(), [&](const Triangle& t) { return !is_hidden(t); });
  std::erase_if(ink.hull_triangles, is_hidden);
}

std::vector<glm::vec3> list_ear_bowls(const NeutralHead& head) {
  std::vector<glm::vec3> bowls;
  for (std::size_t i = 0; i < head.cage.names.size(); ++i)
    for (const char* ring : {"er9_", "er10_", "er11_"})
      if (has_prefix(head.cage.names[i], ring)) bowls.push_back(head.skin.positions[i]);
  return bowls;
}

bool is_in_ear(const std::vector<glm::vec3>& bowls, const glm::vec3& place, float eye_size) {
  constexpr float kBowl_mm = 5;
  return std::ranges::any_of(
      bowls, [&](const glm::vec3& bowl) { return glm::distance(bowl, place) < kBowl_mm * eye_size; });
}

void clear_ears(const Figure& figure, Ink& ink) {
  const auto mass = std::ranges::find(ink.model.parts, "hair_mass", &Part::name);
  if (mass == ink.model.parts.end()) return;
  const std::vector<glm::vec3> bowls = list_ear_bowls(figure.head);
  std::vector<bool> is_in_bowl;
  for (const glm::vec3& p : mass->rest.positions) is_in_bowl.push_back(is_in_ear(bowls, p, ink.eye_size));
  keep_triangles(
      *mass, [&](const Triangle& t) { return !is_in_bowl[t[0]] && !is_in_bowl[t[1]] && !is_in_bowl[t[2]]; });
}

void taper_row(const glm::mat3& axes, float over_mm, std::vector<glm::vec3>& positions) {
  constexpr float kWhole = 0.6f, kNone = 1.1f;           // of half the row's width
  constexpr float kBackWhole = 0.12f, kBackNone = 0.6f;  // of its depth
  const glm::mat3 into_axes = glm::transpose(axes);
  Box box{glm::vec3(INFINITY), glm::vec3(-INFINITY)};
  for (const glm::vec3& p : positions) {
    box.low = glm::min(box.low, into_axes * p);
    box.high = glm::max(box.high, into_axes * p);
  }
  const glm::vec3 middle = 0.5f * (box.low + box.high), size = box.high - box.low;
  for (glm::vec3& p : positions) {
    const glm::vec3 at = into_axes * p;
    const float out = 2 * std::abs(at.x - middle.x) / std::max(size.x, 1e-3f),
                behind = (box.high.z - at.z) / std::max(size.z, 1e-3f);
    const float share = std::max(smooth_step(kWhole, kNone, out), smooth_step(kBackWhole, kBackNone, behind));
    p += share * (box.high.y + over_mm - at.y) * axes[1];
  }
}

Part make_mouth_sheet(const Figure& figure, const InkColours& colours, Ink& ink) {
  for (const char* ring : {"M0", "MB1", "MB2"})
    for (const int column : {0, 12})
      ink.sheet_points.push_back(find_point(figure.head.cage, fmt::format("{}_{}", ring, column)));
  Part part = make_flat_part("mouth_sheet", "ink_flat", colours.cavity);
  const auto rings = static_cast<std::uint32_t>(ink.sheet_points.size() / 2);
  part.rest.positions.resize(std::size_t{rings} * kSheetRows);
  for (std::uint32_t ring = 0; ring + 1 < rings; ++ring)
    for (std::uint32_t row = 0; row + 1 < kSheetRows; ++row) {
      const std::uint32_t v = ring * kSheetRows + row;
      part.rest.triangles.push_back({v, v + 1, v + kSheetRows + 1});
      part.rest.triangles.push_back({v, v + kSheetRows + 1, v + kSheetRows});
    }
  return part;
}

Part make_mouth_edge(const InkColours& colours) {
  Part part = make_flat_part("mouth_edge", "ink_line", colours.line);
  part.rest.positions.resize(kStrokeVertices);
  part.rest.triangles = list_stroke_triangles(0);
  return part;
}

Part make_tooth_strip(const Figure& figure, const InkColours& colours, Ink& ink) {
  const Cage& cage = figure.head.cage;
  constexpr int kCorner = 6;
  ink.is_toothless = !has_teeth(ink);
  for (int column = -kCorner; column <= kCorner; ++column) {
    const int place = ink.is_toothless ? 2 * kCorner - std::abs(column) : std::abs(column);
    const std::uint32_t left = find_point(cage, fmt::format("M0_{}", place));
    ink.strip_points.push_back(column < 0 ? cage.mirror[left] : left);
  }
  Part part = make_flat_part("tooth_strip", "ink_flat", ink.is_toothless ? colours.flesh : colours.bone);
  part.rest.positions.resize(2 * ink.strip_points.size());
  append_band(part.rest.positions.size(), part.rest.triangles);
  return part;
}

}  // namespace mien

#include "head/beard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/smooth.hpp"
#include "core/text.hpp"
#include "head/cage.hpp"
#include "head/lids.hpp"
#include "head/strands.hpp"
#include "head/surface.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

constexpr std::uint32_t kSeries = 61;  // of scatter()
enum Channel : std::uint32_t { kAcross, kAlong, kLength, kTurn, kRise, kShade };

// Eye to chin: boys have none, men all of it.
constexpr double kBoy_mm = 94, kMan_mm = 106;

const Beard& find_beard(const NeutralHead& head, const std::string& name) {
  const auto& beards = head.data->hair.beards.beards;
  const auto found = beards.find(name);
  if (found == beards.end()) throw RunError(fmt::format("templates/head/hair.yaml has no beard '{}'", name));
  return found->second;
}

double compute_growth(const NeutralHead& head) {
  return smooth_step(kBoy_mm, kMan_mm, compute_eye_to_chin_mm(head));
}

// Density of one area at each vertex of the skin.
std::vector<float> spread_area(const NeutralHead& head, const BeardArea& area) {
  std::vector<double> values(head.cage.points.size(), 0.0);
  for (const auto& [name, density] : area.density) {
    const std::uint32_t point = find_point(head.cage, name);
    values[point] = values[head.cage.mirror[point]] = density;
  }
  return spread_over_surface(*head.surface, values);
}

struct BeardField {
  std::vector<float> density;  // a vertex of the skin
  std::vector<glm::vec3> way;  // not normalized, of the left half
};

BeardField build_field(const NeutralHead& head, const Beard& beard) {
  const std::size_t count = head.skin.positions.size();
  BeardField field{std::vector<float>(count), std::vector<glm::vec3>(count)};
  for (const auto& [name, share] : beard.shares) {
    const BeardArea& area = head.data->hair.beards.areas.at(name);
    const std::vector<float> values = spread_area(head, area);
    for (std::size_t v = 0; v < count && v < values.size(); ++v) {
      const float value = static_cast<float>(share) * values[v];
      field.density[v] = std::max(field.density[v], value);
      field.way[v] += value * glm::vec3(area.way);
    }
  }
  return field;
}

// Triangles of the left half by how many hairs each has: the running sum.
struct Meadow {
  std::vector<std::uint32_t> triangles;
  std::vector<double> sums;
};

Meadow compute_meadow(const NeutralHead& head, const BeardField& field) {
  constexpr float kLeast = 0.04f;  // of the density: single hairs far out look like dirt
  Meadow meadow;
  double sum = 0;
  for (std::uint32_t t = 0; t < head.skin.triangles.size(); ++t) {
    const auto& [a, b, c] = head.skin.triangles[t];
    const auto& p = head.skin.positions;
    if (p[a].x + p[b].x + p[c].x <= 0) continue;
    const float density = (field.density[a] + field.density[b] + field.density[c]) / 3;
    if (density < kLeast) continue;
    sum += static_cast<double>(density * glm::length(glm::cross(p[b] - p[a], p[c] - p[a])));
    meadow.triangles.push_back(t);
    meadow.sums.push_back(sum);
  }
  return meadow;
}

template <typename T>
T blend(const std::vector<T>& values, const Triangle& t, const glm::vec3& at) {
  return values[t[0]] * at.x + values[t[1]] * at.y + values[t[2]] * at.z;
}

void append_beard_hair(HeadPart& part, const NeutralHead& head, const BeardField& field, const Beard& beard,
                       double growth, std::uint32_t triangle, std::uint32_t index) {
  const Triangle& t = head.skin.triangles[triangle];
  float u = static_cast<float>(scatter(kSeries, index, kAcross)),
        v = static_cast<float>(scatter(kSeries, index, kAlong));
  if (u + v > 1) u = 1 - u, v = 1 - v;
  const glm::vec3 at(1 - u - v, u, v);
  const glm::vec3 root = blend(head.skin.positions, t, at);
  if (root.x <= 0) return;
  const glm::vec3 normal = glm::normalize(blend(head.skin.normals, t, at));
  const float density = blend(field.density, t, at);
  glm::vec3 way = blend(field.way, t, at);
  way -= normal * glm::dot(way, normal);
  if (glm::dot(way, way) < 1e-8f) return;
  way = glm::normalize(way);
  const glm::vec3 across = glm::cross(normal, way);
  const float lean = 1.1f * (static_cast<float>(scatter(kSeries, index, kTurn)) - 0.5f);
  way = glm::normalize(way + lean * across);
  const double size = head.eye.centre.x / Eye{}.centre.x;
  const auto length = static_cast<float>(growth * size * beard.length_mm * (0.35 + 0.65 * density) *
                                         (0.6 + 0.8 * scatter(kSeries, index, kLength)));
  const auto stand = static_cast<float>(beard.stand * (0.5 + scatter(kSeries, index, kRise)));
  const glm::vec3 middle = root + 0.5f * length * glm::normalize(way + stand * normal);
  const glm::vec3 tip = middle + 0.5f * length * glm::normalize(way + 0.3f * stand * normal);
  const glm::vec3 side = static_cast<float>(size * beard.radius_mm) * glm::normalize(glm::cross(normal, way));
  const glm::vec3 foot = root - 0.2f * normal;
  Mesh& mesh = part.part.rest;
  const std::uint32_t first =
      append_blade({foot - side, foot + side, middle - 0.7f * side, middle + 0.7f * side, tip}, normal, mesh);
  part.part.shade.resize(mesh.positions.size(),
                         static_cast<std::uint16_t>(scatter(kSeries, index, kShade) * kHairShades));
  part.bindings.push_back({triangle, at, first, 5});
}

}  // namespace

std::vector<float> paint_beard(const NeutralHead& head, const std::string& name) {
  if (name == "none") return {};
  const auto growth = static_cast<float>(compute_growth(head));
  std::vector<float> covers = build_field(head, find_beard(head, name)).density;
  for (float& cover : covers) cover *= growth;
  return covers;
}

double compute_beard_paint(const NeutralHead& head, const std::string& name) {
  return name == "none" ? 0 : find_beard(head, name).paint;
}

glm::vec3 compute_beard_colour(const Look& look) { return glm::mix(look.brow, look.hair, 0.5f); }

std::vector<HeadPart> build_beard(const NeutralHead& head, const Look& look) {
  if (look.beard == "none") return {};
  const Beard& beard = find_beard(head, look.beard);
  const double growth = compute_growth(head);
  if (growth <= 0) return {};
  const BeardField field = build_field(head, beard);
  const Meadow meadow = compute_meadow(head, field);
  HeadPart part = make_hair_part("beard");
  part.part.is_printed = false;
  part.part.palette = make_hair_palette(compute_beard_colour(look), 0.35f, 0.2f);
  const int half = beard.count / 2;  // a side
  const auto count = static_cast<std::uint32_t>(half * std::sqrt(growth));
  for (std::uint32_t i = 0; i < count; ++i) {
    // Each hair has its own piece of the meadow: even, and the same whatever the count.
    const double sum = meadow.sums.back() * (i + 0.5) / count;
    const auto at = std::lower_bound(meadow.sums.begin(), meadow.sums.end(), sum) - meadow.sums.begin();
    append_beard_hair(part, head, field, beard, growth, meadow.triangles[static_cast<std::size_t>(at)], i);
  }
  if (part.bindings.empty()) return {};
  add_mirror_image(part, head.skin);
  std::vector<HeadPart> parts;
  parts.push_back(std::move(part));
  return parts;
}

}  // namespace mien

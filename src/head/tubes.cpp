#include "head/tubes.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "core/smooth.hpp"

namespace mien {

glm::vec3 sample_curve(const std::vector<glm::vec3>& points, double t, bool is_closed) {
  assert(points.size() >= 2);
  const auto count = static_cast<std::ptrdiff_t>(points.size());
  auto i = static_cast<std::ptrdiff_t>(std::floor(t));
  if (!is_closed) i = std::clamp<std::ptrdiff_t>(i, 0, count - 2);
  const auto at = [&](std::ptrdiff_t k) {
    if (is_closed) return points[static_cast<std::size_t>(((k % count) + count) % count)];
    if (k < 0) return 2.0f * points[0] - points[1];
    if (k >= count) return 2.0f * points[points.size() - 1] - points[points.size() - 2];
    return points[static_cast<std::size_t>(k)];
  };
  const float f = static_cast<float>(t - static_cast<double>(i));
  const glm::vec3 a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
  if (f < 0) return b + f * (c - a) * 0.5f;
  if (f > 1) return c + (f - 1) * (d - b) * 0.5f;
  return 0.5f * (2.0f * b + (c - a) * f + (2.0f * a - 5.0f * b + 4.0f * c - d) * (f * f) +
                 (3.0f * (b - c) + d - a) * (f * f * f));
}

double sample_stations(const std::vector<double>& knots, const std::vector<double>& values, double at) {
  assert(!knots.empty() && knots.size() == values.size());
  if (at <= knots.front()) return values.front();
  if (at >= knots.back()) return values.back();
  const auto next =
      static_cast<std::size_t>(std::upper_bound(knots.begin(), knots.end(), at) - knots.begin());
  const double share = (at - knots[next - 1]) / (knots[next] - knots[next - 1]);
  const double eased = 0.5 - 0.5 * std::cos(std::numbers::pi * share);
  // Half eased, half straight: flat enough at the stations, no stairs between them.
  return values[next - 1] + (values[next] - values[next - 1]) * 0.5 * (share + eased);
}

glm::vec3 compute_middle(const Ring& ring) {
  glm::vec3 sum(0);
  for (const glm::vec3& p : ring) sum += p;
  return sum / static_cast<float>(ring.size());
}

void append_loft(Mesh& mesh, const glm::vec3& start, const std::vector<Ring>& rings, const glm::vec3& end) {
  assert(!rings.empty() && rings.front().size() >= 3);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto sides = static_cast<std::uint32_t>(rings.front().size());
  mesh.positions.push_back(start);
  for (const Ring& ring : rings) {
    assert(ring.size() == sides);
    mesh.positions.insert(mesh.positions.end(), ring.begin(), ring.end());
  }
  const auto last = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.push_back(end);

  const auto vertex = [&](std::size_t ring, std::uint32_t side) {
    return first + 1 + static_cast<std::uint32_t>(ring) * sides + side % sides;
  };
  for (std::uint32_t k = 0; k < sides; ++k) {
    mesh.triangles.push_back({first, vertex(0, k + 1), vertex(0, k)});
    for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
      mesh.triangles.push_back({vertex(r, k), vertex(r, k + 1), vertex(r + 1, k + 1)});
      mesh.triangles.push_back({vertex(r, k), vertex(r + 1, k + 1), vertex(r + 1, k)});
    }
    mesh.triangles.push_back({vertex(rings.size() - 1, k), vertex(rings.size() - 1, k + 1), last});
  }
}

void append_hair(Mesh& mesh, const std::vector<glm::vec3>& centres, const std::vector<float>& radii_mm,
                 int sides, const glm::vec3& across) {
  assert(centres.size() >= 2 && centres.size() == radii_mm.size() && sides >= 3);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto n = static_cast<std::uint32_t>(sides);
  glm::vec3 side = across;
  for (std::size_t i = 0; i + 1 < centres.size(); ++i) {
    const glm::vec3 along = glm::normalize(centres[i + 1] - centres[i > 0 ? i - 1 : 0]);
    side = glm::normalize(side - along * glm::dot(side, along));  // carried on without turning about the hair
    const glm::vec3 up = glm::cross(along, side);
    for (std::uint32_t k = 0; k < n; ++k) {
      const float turn = static_cast<float>(2 * std::numbers::pi * k / sides);
      mesh.positions.push_back(centres[i] + radii_mm[i] * (std::cos(turn) * side + std::sin(turn) * up));
    }
  }
  const auto tip = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.push_back(centres.back());

  const auto rings = static_cast<std::uint32_t>(centres.size() - 1);
  for (std::uint32_t k = 1; k + 1 < n; ++k) mesh.triangles.push_back({first, first + k + 1, first + k});
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t next = (k + 1) % n;
    for (std::uint32_t r = 0; r + 1 < rings; ++r) {
      const std::uint32_t low = first + r * n, high = low + n;
      mesh.triangles.push_back({low + k, low + next, high + next});
      mesh.triangles.push_back({low + k, high + next, high + k});
    }
    mesh.triangles.push_back({first + (rings - 1) * n + k, first + (rings - 1) * n + next, tip});
  }
}

double scatter(std::uint32_t series, std::uint32_t index, std::uint32_t channel) {
  // SplitMix64 (Steele, Lea, Flood 2014) over the packed arguments.
  std::uint64_t z =
      (static_cast<std::uint64_t>(series) << 48) ^ (static_cast<std::uint64_t>(channel) << 32) ^ index;
  for (int round = 0; round < 2; ++round) {
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
  }
  return static_cast<double>(z >> 11) * 0x1p-53;
}

double step_golden(std::uint32_t index, double first) {
  constexpr double kGolden = 0.618034;
  const double at = first + kGolden * index;
  return at - std::floor(at);
}

double sample_noise(std::uint32_t series, double at, int period) {
  const double cell = std::floor(at), share = at - cell;
  const auto value = [&](double k) {
    const int wrapped = ((static_cast<int>(k) % period) + period) % period;
    return 2 * scatter(series, static_cast<std::uint32_t>(wrapped), 0) - 1;
  };
  const double ease = smooth_share(share);
  return value(cell) * (1 - ease) + value(cell + 1) * ease;
}

}  // namespace mien

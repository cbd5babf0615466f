#include "print/label_panel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/error.hpp"
#include "core/print_numbers.hpp"
#include "core/simplify.hpp"

namespace mien {

namespace {

constexpr double kTolerance_mm = 0.02;  // of the relief with fewer triangles

// The front of the wall unrolled: vertex by vertex, `along` in mm from x = 0, to the character's left.
struct Front {
  std::vector<std::size_t> index;  // in the rings
  std::vector<double> along;
  std::vector<glm::dvec2> at, outward;
};

// The ring's stretch around the front that is within the sector.
Front compute_front(const std::vector<glm::vec3>& ring) {
  const std::size_t n = ring.size();
  const auto at = [&](std::size_t i) { return glm::dvec2(ring[i % n].x, ring[i % n].y); };
  std::size_t first = n;
  for (std::size_t i = 0; i < n; ++i)
    if (at(i).x <= 0 && at(i + 1).x > 0 && at(i).y < 0) first = i;
  if (first == n) throw RunError("internal: the base has no front");
  double broadest = 0;
  for (const glm::vec3& p : ring) broadest = std::max(broadest, std::abs(double(p.x)));
  const auto is_seen = [&](std::size_t i) {
    return at(i).y < 0 && std::abs(at(i).x) <= kLabelSector * broadest;
  };
  std::size_t begin = first + n, end = first + n + 1;
  while (begin > first && is_seen(begin - 1)) --begin;
  while (end < begin + n - 1 && is_seen(end + 1)) ++end;

  Front front;
  double length = 0, zero = 0;
  for (std::size_t i = begin; i <= end; ++i) {
    if (i > begin) length += glm::distance(at(i - 1), at(i));
    if (i == first + n) {
      const double share = -at(i).x / (at(i + 1).x - at(i).x);
      zero = length + share * glm::distance(at(i), at(i + 1));
    }
    const glm::dvec2 way = glm::normalize(at(i + 1) - at(i + n - 1));
    front.index.push_back(i % n);
    front.along.push_back(length);
    front.at.push_back(at(i));
    front.outward.emplace_back(way.y, -way.x);
  }
  for (double& along : front.along) along -= zero;
  return front;
}

glm::dvec2 sample(const Front& front, const std::vector<glm::dvec2>& values, double along) {
  std::size_t i = 0;
  while (i + 2 < front.along.size() && front.along[i + 1] < along) ++i;
  const double share = (along - front.along[i]) / (front.along[i + 1] - front.along[i]);
  return values[i] + share * (values[i + 1] - values[i]);
}

// The relief, its sides in the order bottom, right, top, left, each counter-clockwise as seen from the front.
struct Relief {
  Mesh mesh;
  std::array<Loop, 4> sides;
};

Relief build_relief(const Front& front, const Label& label, double raise_mm, double low_z, double high_z) {
  const double half = label.width_mm / 2 + kLabelMargin_mm, bottom = (low_z + high_z - label.size_mm) / 2;
  const double low = bottom - kLabelMargin_mm * kLabelFrame,
               high = bottom + label.size_mm + kLabelMargin_mm * kLabelFrame;
  const int columns = int(std::ceil(std::min(2 * half / kLabelStep_mm, kMostLabelSteps)));
  const int rows = std::max(2, int(std::ceil((high - low) / kLabelStep_mm)));
  Relief relief;
  Mesh& mesh = relief.mesh;
  const auto vertex = [&](int i, int j) { return static_cast<std::uint32_t>(j * (columns + 1) + i); };
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const double along = -half + 2 * half * i / columns, z = low + (high - low) * j / rows;
      const double out = label.pen_mm / 2 - compute_stroke_distance(label.strokes, {along, z - bottom});
      // Half of the slope is beyond the pen's border, half within; the frame stays in the wall.
      const bool is_frame = i == 0 || j == 0 || i == columns || j == rows;
      const double share = is_frame ? 0 : std::clamp(0.5 + out / kLabelSlope_mm, 0.0, 1.0);
      const glm::dvec2 at = sample(front, front.at, along) +
                            share * raise_mm * glm::normalize(sample(front, front.outward, along));
      mesh.positions.emplace_back(at.x, at.y, z);
    }
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const std::uint32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1),
                          d = vertex(i, j + 1);
      if (glm::distance(mesh.positions[a], mesh.positions[c]) <=
          glm::distance(mesh.positions[b], mesh.positions[d]))
        mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
      else
        mesh.triangles.insert(mesh.triangles.end(), {{a, b, d}, {b, c, d}});
    }
  for (int i = 0; i <= columns; ++i) relief.sides[0].push_back(vertex(i, 0));
  for (int j = 0; j <= rows; ++j) relief.sides[1].push_back(vertex(columns, j));
  for (int i = columns; i >= 0; --i) relief.sides[2].push_back(vertex(i, rows));
  for (int j = rows; j >= 0; --j) relief.sides[3].push_back(vertex(0, j));
  return relief;
}

// Fewer triangles; the frame keeps its vertices, found again by their places.
void simplify_relief(Relief& relief) {
  const auto key = [](const glm::vec3& p) { return std::array<float, 3>{p.x, p.y, p.z}; };
  const std::vector<glm::vec3> before = relief.mesh.positions;
  simplify_mesh(relief.mesh, kTolerance_mm);
  std::map<std::array<float, 3>, std::uint32_t> found;
  for (std::uint32_t v = 0; v < relief.mesh.positions.size(); ++v) found[key(relief.mesh.positions[v])] = v;
  for (Loop& side : relief.sides)
    for (std::uint32_t& v : side) v = found.at(key(before[v]));
}

}  // namespace

void append_strip(Mesh& mesh, const Loop& right, const Loop& left) {
  std::size_t i = 0, j = 0;
  while (i + 1 < right.size() || j + 1 < left.size()) {
    const double next_i = double(i + 1) / double(right.size() - 1),
                 next_j = double(j + 1) / double(left.size() - 1);
    if (j + 1 == left.size() || (i + 1 < right.size() && next_i <= next_j)) {
      mesh.triangles.push_back({right[i], right[i + 1], left[j]});
      ++i;
    } else {
      mesh.triangles.push_back({right[i], left[j + 1], left[j]});
      ++j;
    }
  }
}

LabelRoom compute_label_room(const std::vector<glm::vec3>& high, const std::vector<glm::vec3>& low) {
  const Front front = compute_front(low);
  const double side = std::min(-front.along.front(), front.along.back());
  return {std::max(0.0, 2 * (side - 3 * kLabelMargin_mm)),
          std::max(0.0, double(high[0].z - low[0].z) - 2 * kLabelMargin_mm)};
}

void append_label_band(Mesh& mesh, const Loop& high, const Loop& low, const Label& label, double raise_mm) {
  mesh.normals.clear();
  std::vector<glm::vec3> ring;
  for (const std::uint32_t v : low) ring.push_back(mesh.positions[v]);
  const Front front = compute_front(ring);
  // As few columns of the wall as hold the label.
  const double half = label.width_mm / 2 + 2 * kLabelMargin_mm;
  std::size_t begin = 0, end = front.along.size() - 1;
  while (begin + 1 < end && front.along[begin + 1] < -half) ++begin;
  while (end > begin + 1 && front.along[end - 1] > half) --end;

  Relief relief = build_relief(front, label, raise_mm, mesh.positions[low[0]].z, mesh.positions[high[0]].z);
  simplify_relief(relief);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  append_mesh(mesh, relief.mesh);
  for (Loop& side : relief.sides)
    for (std::uint32_t& v : side) v += first;
  Loop bottom, top;
  std::vector<bool> is_panel(low.size(), false);
  for (std::size_t i = begin; i <= end; ++i) {
    bottom.push_back(low[front.index[i]]);
    top.insert(top.begin(), high[front.index[i]]);
    if (i < end) is_panel[front.index[i]] = true;
  }
  append_strip(mesh, bottom, relief.sides[0]);
  append_strip(mesh, {bottom.back(), top.front()}, relief.sides[1]);
  append_strip(mesh, top, relief.sides[2]);
  append_strip(mesh, {top.back(), bottom.front()}, relief.sides[3]);
  for (std::size_t i = 0; i < low.size(); ++i) {
    const std::size_t j = (i + 1) % low.size();
    if (is_panel[i]) continue;
    mesh.triangles.push_back({low[i], low[j], high[j]});
    mesh.triangles.push_back({low[i], high[j], high[i]});
  }
}

}  // namespace mien

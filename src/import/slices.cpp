// A cloud is what comes of slices, not triangles between them: a slice of a head is often several lines, and
// where one becomes two, no triangles are right. What is nearest on the next slice is right everywhere else.
#include "import/slices.hpp"

#include <fmt/format.h>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "core/signals.hpp"
#include "import/reading.hpp"

namespace mien {

namespace {

constexpr std::size_t kMostSlices = 20'000;
constexpr double kSameHeight = 1e-3;    // of the way from the first plane to the last: one plane
constexpr double kMostTilt = 0.2;       // of the way between planes: lines further out of theirs are in none
constexpr double kStepShare = 1.0 / 3;  // of the way between slices: how far apart points are then
// Ways between slices. A surface that lies nearly in the planes is left open; more joins what is not one.
constexpr double kReach = 2;
constexpr double kClosingGap = 2.5;      // steps between a line's ends: it is closed
constexpr double kLeastWay = 1e-9;       // in the file's unit; below it slices are one
constexpr double kLeap = 20;             // steps: no line goes on so far without a point
constexpr double kMostFilled = 400'000;  // points; a cloud is thinned to a tenth of them
constexpr double kMostSampled = 50'000;  // points on the lines; each looks among all of the next layer
constexpr std::size_t kLook = 64;        // points of a layer that are asked how far the next one is

using Layer = std::vector<glm::dvec3>;

double find_median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The line, closed if it ends where it begins, in the pieces that are left where it leaps: over a hole, or to
// a point that is a slip.
std::vector<Slice> split_slice(Slice slice) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < slice.size(); ++i) steps.push_back(glm::distance(slice[i - 1], slice[i]));
  const double step = find_median(std::move(steps));
  if (slice.size() > 3 && glm::distance(slice.front(), slice.back()) <= kClosingGap * step)
    slice.push_back(slice.front());
  std::vector<Slice> pieces(1);
  for (const glm::dvec3& p : slice) {
    if (!pieces.back().empty() && step > 0 && glm::distance(pieces.back().back(), p) > kLeap * step)
      pieces.emplace_back();
    pieces.back().push_back(p);
  }
  if (pieces.size() > 1) std::erase_if(pieces, [](const Slice& piece) { return piece.size() < 2; });
  return pieces;
}

double compute_length(const Slice& slice) {
  double length = 0;
  for (std::size_t i = 1; i < slice.size(); ++i) length += glm::distance(slice[i - 1], slice[i]);
  return length;
}

// Points along the line, `step` apart at most and not much nearer.
void append_even_points(const Slice& slice, double step, Layer& layer) {
  layer.push_back(slice.front());
  double left = step;  // until the next one
  for (std::size_t i = 1; i < slice.size(); ++i) {
    const double length = glm::distance(slice[i - 1], slice[i]);
    double at = left;
    for (; at < length; at += step) layer.push_back(glm::mix(slice[i - 1], slice[i], at / length));
    left = at - length;
  }
  layer.push_back(slice.back());
}

// The planes' normal, and how far the points are from their slices' planes on the whole.
std::pair<glm::dvec3, double> find_planes(const std::vector<Slice>& slices) {
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  double count = 0;
  for (const Slice& slice : slices) {
    glm::dvec3 middle(0);
    for (const glm::dvec3& p : slice) middle += p / static_cast<double>(slice.size());
    for (const glm::dvec3& p : slice) {
      const Eigen::Vector3d way(p.x - middle.x, p.y - middle.y, p.z - middle.z);
      spread += way * way.transpose();
      ++count;
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  const Eigen::Vector3d normal = solver.eigenvectors().col(0);
  return {{normal(0), normal(1), normal(2)}, std::sqrt(std::max(0.0, solver.eigenvalues()(0)) / count)};
}

// Which slices are one layer, the layers in order; empty if they do not lie in parallel planes.
std::vector<std::vector<std::size_t>> find_planar_layers(const std::vector<Slice>& slices) {
  const auto [normal, off] = find_planes(slices);
  std::vector<double> heights;
  for (const Slice& slice : slices) {
    double height = 0;
    for (const glm::dvec3& p : slice) height += glm::dot(p, normal) / static_cast<double>(slice.size());
    heights.push_back(height);
  }
  std::vector<std::size_t> order(slices.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return heights[i]; });
  const double whole = heights[order.back()] - heights[order.front()];
  std::vector<std::vector<std::size_t>> layers;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || heights[order[i]] - heights[order[i - 1]] > kSameHeight * whole) layers.emplace_back();
    layers.back().push_back(order[i]);
  }
  const double way = whole / static_cast<double>(std::max<std::size_t>(1, layers.size() - 1));
  return off <= kMostTilt * way ? layers : std::vector<std::vector<std::size_t>>{};
}

// The nearest of a layer's points, by cells as wide as one looks.
struct LayerIndex {
  const Layer& points;
  double reach = 0;
  std::map<std::array<std::int64_t, 3>, std::vector<std::uint32_t>> cells;
};

std::array<std::int64_t, 3> find_layer_cell(const LayerIndex& index, const glm::dvec3& p) {
  const glm::dvec3 cell = glm::floor(p / index.reach);
  return {static_cast<std::int64_t>(cell.x), static_cast<std::int64_t>(cell.y),
          static_cast<std::int64_t>(cell.z)};
}

LayerIndex build_layer_index(const Layer& points, double reach) {
  LayerIndex index{points, reach, {}};
  for (std::uint32_t i = 0; i < points.size(); ++i)
    index.cells[find_layer_cell(index, points[i])].push_back(i);
  return index;
}

const glm::dvec3* find_nearest_point(const LayerIndex& index, const glm::dvec3& p) {
  const glm::dvec3* nearest = nullptr;
  double least = index.reach;
  const auto [x, y, z] = find_layer_cell(index, p);
  for (std::int64_t i = x - 1; i <= x + 1; ++i)
    for (std::int64_t j = y - 1; j <= y + 1; ++j)
      for (std::int64_t k = z - 1; k <= z + 1; ++k) {
        const auto cell = index.cells.find({i, j, k});
        if (cell == index.cells.end()) continue;
        for (const std::uint32_t other : cell->second)
          if (const double way = glm::distance(index.points[other], p); way < least) {
            least = way;
            nearest = &index.points[other];
          }
      }
  return nearest;
}

// How far it is from one layer to the next, as a rule.
double find_typical_way(const std::vector<Layer>& layers) {
  std::vector<double> ways;
  for (std::size_t i = 0; i + 1 < layers.size(); ++i) {
    const Layer &from = layers[i], &to = layers[i + 1];
    for (std::size_t a = 0; a < from.size(); a += std::max<std::size_t>(1, from.size() / kLook)) {
      double least = 1e300;
      for (const glm::dvec3& p : to) least = std::min(least, glm::distance(from[a], p));
      ways.push_back(least);
    }
  }
  return find_median(std::move(ways));
}

// How the surface runs at `here` towards `next`, coming from `before` if that is anywhere.
glm::dvec3 find_course(const glm::dvec3* before, const glm::dvec3& here, const glm::dvec3& next) {
  const double after = glm::distance(here, next);
  if (before == nullptr || here == *before) return next - here;
  const double ago = glm::distance(*before, here);
  const glm::dvec3 from = (here - *before) / ago, on = (next - here) / after;
  if (glm::dot(from, on) < 0) return next - here;  // an edge, or another part of the head
  return after * (after * from + ago * on) / (ago + after);
}

// Points on the way from each point of `from` to the nearest one of `to`: along a cubic curve, since chords
// make a face thinner. `before` and `behind` are the layers on either side, if there are any.
void fill_way(const LayerIndex* before, const Layer& from, const LayerIndex& to, const LayerIndex* behind,
              double step, std::vector<glm::dvec3>& filled) {
  for (const glm::dvec3& p : from) {
    const glm::dvec3* other = find_nearest_point(to, p);
    if (other == nullptr || p == *other) continue;
    const glm::dvec3 begin = find_course(before ? find_nearest_point(*before, p) : nullptr, p, *other),
                     end = -find_course(behind ? find_nearest_point(*behind, *other) : nullptr, *other, p);
    const int steps = static_cast<int>(std::ceil(glm::distance(p, *other) / step));
    for (int i = 1; i < steps; ++i) {
      const double t = double(i) / steps, u = 1 - t;  // Hermite's
      filled.push_back(u * u * (1 + 2 * t) * p + t * t * (1 + 2 * u) * *other + u * u * t * begin -
                       t * t * u * end);
    }
  }
}

Layer sample_layer(const std::vector<Slice>& slices, const std::vector<std::size_t>& members, double step) {
  Layer layer;
  for (const std::size_t member : members) append_even_points(slices[member], step, layer);
  return layer;
}

std::vector<Layer> sample_layers(const std::vector<Slice>& slices,
                                 const std::vector<std::vector<std::size_t>>& members, double step) {
  std::vector<Layer> layers;
  for (const auto& each : members) layers.push_back(sample_layer(slices, each, step));
  return layers;
}

}  // namespace

std::vector<std::vector<std::uint32_t>> chain_lines(const std::vector<std::vector<std::uint32_t>>& lines) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> ends;  // the lines that end in a point
  for (std::uint32_t i = 0; i < lines.size(); ++i)
    for (const std::uint32_t end : {lines[i].front(), lines[i].back()}) ends[end].push_back(i);
  std::vector<bool> is_used(lines.size(), false);
  // The line that goes on where the chain ends, if there is just one.
  const auto find_next = [&](std::uint32_t end) -> const std::uint32_t* {
    const std::vector<std::uint32_t>& there = ends.at(end);
    if (there.size() != 2) return nullptr;
    const auto next = std::ranges::find_if(there, [&](std::uint32_t i) { return !is_used[i]; });
    return next == there.end() ? nullptr : &*next;
  };
  std::vector<std::vector<std::uint32_t>> chains;
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    if (is_used[i]) continue;
    is_used[i] = true;
    std::vector<std::uint32_t>& chain = chains.emplace_back(lines[i]);
    for (const bool is_front : {false, true}) {  // on from its end, then, turned, from its beginning
      while (const std::uint32_t* next = find_next(chain.back())) {
        is_used[*next] = true;
        std::vector<std::uint32_t> more = lines[*next];
        if (more.front() != chain.back()) std::ranges::reverse(more);
        chain.insert(chain.end(), more.begin() + 1, more.end());
      }
      std::ranges::reverse(chain);
      if (is_front) break;
    }
  }
  return chains;
}

void fill_slices(const std::vector<Slice>& told, Polygons& mesh) {
  if (told.size() > kMostSlices)
    fail_file(mesh.file, fmt::format("more than {} slices; expected fewer", kMostSlices));
  std::vector<Slice> pieces;
  std::vector<std::vector<std::size_t>> by_slice;  // the pieces of each
  double length = 0;
  for (const Slice& slice : told) {
    by_slice.emplace_back();
    for (Slice& piece : split_slice(slice)) {
      length += compute_length(piece);
      by_slice.back().push_back(pieces.size());
      pieces.push_back(std::move(piece));
    }
  }
  std::vector<std::vector<std::size_t>> members = find_planar_layers(pieces);
  const bool is_planar = !members.empty();
  if (!is_planar) members = std::move(by_slice);
  mesh.slices = told.size();
  mesh.is_made = true;
  mesh.positions.clear();
  mesh.lines.clear();
  mesh.normals.clear();
  const double least = length / kMostSampled;
  if (least <= 0) {  // points alone
    for (const Slice& piece : pieces) mesh.positions.push_back(piece.front());
    return;
  }
  const double way = find_typical_way(sample_layers(pieces, members, least));
  const double step = std::max({least, kStepShare * way, std::sqrt(length * way / kMostFilled)});
  const std::vector<Layer> layers = sample_layers(pieces, members, step);
  for (const Layer& layer : layers) mesh.positions.insert(mesh.positions.end(), layer.begin(), layer.end());
  if (way <= kLeastWay) return;
  std::vector<LayerIndex> indices;
  for (const Layer& layer : layers) indices.push_back(build_layer_index(layer, kReach * way));
  // What was led around the head comes back to where it began.
  const std::size_t count = layers.size();
  const bool is_round = !is_planar && count > 2;
  const auto find_index = [&](std::size_t i) -> const LayerIndex* {  // i may be -1
    return is_round ? &indices[i % count] : i < count ? &indices[i] : nullptr;
  };
  for (std::size_t i = 0; i + (is_round ? 0 : 1) < count; ++i) {
    throw_if_interrupted();
    const std::size_t next = (i + 1) % count;
    const LayerIndex *before = find_index(is_round ? i + count - 1 : i - 1), *behind = find_index(i + 2);
    fill_way(before, layers[i], indices[next], behind, step, mesh.positions);
    fill_way(behind, layers[next], indices[i], before, step, mesh.positions);
  }
}

}  // namespace mien

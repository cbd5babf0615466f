#include "wire/drawing.hpp"

#include <algorithm>
#include <cmath>

#include "core/pool.hpp"
#include "wire/edges.hpp"

namespace mien {

namespace {

using PaperLine = std::vector<glm::dvec2>;

constexpr std::array<std::uint8_t, 3> kRedPencil{184, 38, 26}, kBluePencil{51, 84, 140}, kPale{128, 122, 114};
constexpr double kFlat_px = 0.05;  // a point nearer to the line between its neighbours is left out

double compute_off_px(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 way = b - a;
  const double length = glm::dot(way, way);
  const double t = length > 0 ? std::clamp(glm::dot(p - a, way) / length, 0.0, 1.0) : 0;
  return glm::distance(p, a + t * way);
}

// D. Douglas and T. Peucker, "Algorithms for the reduction of the number of points", 1973.
void append_reduced(const PaperLine& line, std::size_t first, std::size_t last, PaperLine& reduced) {
  std::size_t farthest = first;
  double most_px = kFlat_px;
  for (std::size_t i = first + 1; i < last; ++i)
    if (const double off_px = compute_off_px(line[i], line[first], line[last]); off_px > most_px)
      most_px = off_px, farthest = i;
  if (farthest == first) return reduced.push_back(line[last]);
  append_reduced(line, first, farthest, reduced);
  append_reduced(line, farthest, last, reduced);
}

PaperLine reduce(const PaperLine& line) {
  PaperLine reduced{line.front()};
  append_reduced(line, 0, line.size() - 1, reduced);
  return reduced;
}

// The shares of a way that lie within the picture: Y.-D. Liang and B. Barsky, "A new concept and method for
// line clipping", 1984. Empty: first > second.
std::array<double, 2> clip_to_picture(const glm::dvec2& from, const glm::dvec2& to, const PictureSize& size) {
  std::array<double, 2> within{0, 1};
  const glm::dvec2 way = to - from, high(size.width_px, size.height_px);
  for (int axis = 0; axis < 2; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      const double step = sign * way[axis];
      const double room = sign > 0 ? high[axis] - from[axis] : from[axis];
      if (step == 0 && room < 0) return {1, 0};
      if (step > 0) within[1] = std::min(within[1], room / step);
      if (step < 0) within[0] = std::max(within[0], room / step);
    }
  return within;
}

// What is seen of one line, in the camera's picture.
std::vector<PaperLine> find_seen_lines(const WireLine& line, const WireStage& stage,
                                       const WireCamera& camera) {
  std::vector<PaperLine> seen_lines;
  bool goes_on = false;  // the last of them reaches to the next point
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    const glm::dvec3 from(line.points[i]), to(line.points[i + 1]);
    if (!camera.is_orthographic &&
        std::min(compute_depth_mm(camera, from), compute_depth_mm(camera, to)) <= 1) {
      goes_on = false;
      continue;
    }
    const glm::dvec2 a = find_paper_place(camera, from), b = find_paper_place(camera, to);
    const auto [first, last] = clip_to_picture(a, b, camera.size);
    if (first >= last) {
      goes_on = false;
      continue;
    }
    std::vector<std::array<double, 2>> seen{{0, 1}};
    if (!line.is_before_all) seen = find_seen(stage, camera, from, to, kWireStep_px);
    bool reaches = false;
    for (const auto& [begin, end] : seen) {
      const double low = std::max(begin, first), high = std::min(end, last);
      if (low >= high) continue;
      // What perspective does along one edge of a net is less than a hundredth of a pixel.
      if (!(goes_on && low == 0)) seen_lines.push_back({glm::mix(a, b, low)});
      seen_lines.back().push_back(glm::mix(a, b, high));
      goes_on = false;
      reaches = high == 1;
    }
    goes_on = reaches;
  }
  for (PaperLine& seen : seen_lines) seen = reduce(seen);
  return seen_lines;
}

}  // namespace

PenLooks get_pen_looks() {
  PenLooks looks;
  const auto set = [&](Pen pen, const PenLook& look) { looks[static_cast<std::size_t>(pen)] = look; };
  set(Pen::mesh, {0.00062});
  set(Pen::hair, {0.0007});
  set(Pen::crease, {0.0009});
  set(Pen::border, {0.0019});
  set(Pen::contour, {0.0022});
  set(Pen::guide, {0.0018, kRedPencil});
  set(Pen::limit, {0.0018, kBluePencil});
  set(Pen::rest, {0.0009, kPale});
  return looks;
}

std::vector<WireLine> list_wire_lines(const WireModel& model, const WireCamera& camera) {
  std::vector<WireLine> lines = model.lines;
  for (const WireSolid& solid : model.solids)
    for (WireLine& line : list_edge_lines(solid, list_edges(solid.triangles), camera))
      lines.push_back(std::move(line));
  return lines;
}

void draw_wire(const WireModel& model, const WireCamera& camera, const PenLooks& looks,
               const glm::dvec2& corner_px, int jobs, Paper& paper) {
  const WireStage stage(model.solids);
  std::vector<WireLine> lines = list_wire_lines(model, camera);
  std::ranges::stable_sort(lines, {},
                           [](const WireLine& line) { return std::pair(line.is_before_all, line.pen); });
  std::vector<std::vector<PaperLine>> seen(lines.size());
  for_each_index(lines.size(), jobs,
                 [&](std::size_t i, int) { seen[i] = find_seen_lines(lines[i], stage, camera); });
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const PenLook& look = looks[static_cast<std::size_t>(lines[i].pen)];
    for (PaperLine& points : seen[i]) {
      for (glm::dvec2& p : points) p += corner_px;
      paper.strokes.push_back({std::move(points), look.width * camera.size.height_px, look.srgb});
    }
  }
}

}  // namespace mien

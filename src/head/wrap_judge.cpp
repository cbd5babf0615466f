#include "head/wrap_judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/mesh.hpp"
#include "head/least_squares.hpp"
#include "head/nearest.hpp"
#include "head/surface.hpp"

namespace mien {

namespace {

// The face, where the adult has it: the front between hairline and chin, without the sides.
bool is_face(const glm::dvec3& adult) {
  constexpr double kLeast_z_mm = 45, kLeast_y_mm = -95, kMost_y_mm = 55;
  return adult.z > kLeast_z_mm && adult.y > kLeast_y_mm && adult.y < kMost_y_mm;
}

// Further off, a place of the scan is another one.
constexpr double kReach_mm = 15;
constexpr double kAgreeing = 0.5;  // cosine: less than 60 degrees apart

std::vector<std::uint32_t> list_face(const WrapView& wrap, const std::vector<glm::vec3>& adult) {
  std::vector<std::uint32_t> face;
  for (const std::uint32_t v : wrap.vertices)
    if (is_face(glm::dvec3(adult[v]))) face.push_back(v);
  return face;
}

void measure_places(const WrapView& wrap, const std::vector<std::uint32_t>& face, WrapWorth& worth) {
  std::size_t covered = 0, near = 0, off = 0, agreeing = 0;
  double squares = 0;
  for (const std::uint32_t v : face) {
    bool is_covered = false;
    for (const bool is_right : {false, true}) {
      const NearestPlace place = find_place(wrap.placed, glm::dvec3(wrap.positions[v]), kReach_mm, is_right);
      if (place.distance > kReach_mm || place.is_rim) continue;
      is_covered = true;
      ++near;
      squares += place.distance * place.distance;
      off += place.distance > kOff_mm;
      agreeing += glm::dot(place.normal, glm::dvec3(wrap.normals[v])) >= kAgreeing;
    }
    covered += is_covered;
  }
  if (near == 0) return;
  const auto count = static_cast<double>(near);
  worth.covered = static_cast<double>(covered) / static_cast<double>(face.size());
  worth.rms_mm = std::sqrt(squares / count);
  worth.off = static_cast<double>(off) / count;
  worth.agreeing = static_cast<double>(agreeing) / count;
}

// Triangles that look away from where the adult's look.
void measure_folds(const WrapView& wrap, const std::vector<glm::vec3>& adult,
                   const std::vector<std::uint32_t>& face, WrapWorth& worth) {
  std::vector<bool> is_face(adult.size(), false);
  for (const std::uint32_t v : face) is_face[v] = true;
  const auto compute_area = [](const std::vector<glm::vec3>& p, const Quad& q) {
    return glm::cross(p[q[2]] - p[q[0]], p[q[3]] - p[q[1]]);
  };
  for (const Quad& q : wrap.stock.surface->quads)
    if (std::ranges::all_of(q, [&](std::uint32_t v) { return is_face[v]; }) &&
        glm::dot(compute_area(adult, q), compute_area(wrap.positions, q)) < 0)
      worth.folded += 2;
}

// The scan's own points, in front of and behind the skin.
void measure_points(const WrapView& wrap, const std::vector<std::uint32_t>& face, WrapWorth& worth) {
  constexpr std::size_t kMostPoints = 4000;  // more say the same
  constexpr double kAround_mm = 5;           // in front of the face: a beard, glasses
  Polygons skin;
  skin.positions.assign(wrap.positions.begin(), wrap.positions.end());
  for (const Quad& q : wrap.stock.surface->quads) {
    skin.corners.insert(skin.corners.end(), q.begin(), q.end());
    skin.first.push_back(static_cast<std::uint32_t>(skin.corners.size()));
  }
  const SurfaceTree tree = build_surface_tree(skin);
  glm::dvec3 low(1e300), high(-1e300);
  for (const std::uint32_t v : face) {
    const glm::dvec3 p(wrap.positions[v]);
    low = glm::min(low, glm::min(p, mirror(p)));
    high = glm::max(high, glm::max(p, mirror(p)));
  }
  low -= kAround_mm, high += kAround_mm;
  const std::vector<glm::dvec3>& points = wrap.placed.tree.positions;
  const std::size_t step = 1 + points.size() / kMostPoints;
  std::size_t seen = 0, stray = 0;
  for (std::size_t i = 0; i < points.size(); i += step) {
    const glm::dvec3 at = wrap.placed.turn * points[i] + wrap.placed.shift;
    if (glm::any(glm::lessThan(at, low)) || glm::any(glm::greaterThan(at, high))) continue;
    ++seen;
    stray += !is_within(tree, at, kStray_mm);
  }
  if (seen > 0) worth.stray_points = static_cast<double>(stray) / static_cast<double>(seen);
}

void measure_marks(const WrapView& wrap, WrapWorth& worth) {
  for (std::size_t i = 0; i < wrap.marks.size(); ++i) {
    if (wrap.scan.marks[i].weight < 1) continue;
    const double miss = glm::distance(sample_row(wrap.scan.marks[i].place, wrap.points), wrap.marks[i]);
    if (miss <= worth.mark_mm) continue;
    worth.mark_mm = miss;
    worth.worst_mark = i;
  }
}

int count_percent(double share) { return static_cast<int>(std::lround(100 * share)); }

}  // namespace

WrapWorth measure_wrap(const WrapView& wrap) {
  std::vector<Float4> packed;
  std::vector<glm::vec3> adult;
  pack_points(wrap.stock.adult.points, packed);
  deform_surface(*wrap.stock.surface, packed, adult);
  const std::vector<std::uint32_t> face = list_face(wrap, adult);
  WrapWorth worth;
  measure_places(wrap, face, worth);
  measure_folds(wrap, adult, face, worth);
  measure_points(wrap, face, worth);
  measure_marks(wrap, worth);
  return worth;
}

std::vector<Diagnostic> judge_wrap(const Scan& scan, const WrapWorth& worth) {
  // What scans of faces come to, and what others do, is told in docs/soundness.md.
  constexpr double kLeastCovered = 0.7, kNoFace = 0.3;
  constexpr double kLeastAgreeing = 0.85, kNoSurface = 0.6;
  constexpr double kMostRms_mm = 1.5, kMostOff = 0.12, kMostStray = 0.15;
  constexpr double kMostMark_mm = 5;
  constexpr int kMostFolded = 8;
  const Place place{scan.mesh.file, 0, 0};
  if (worth.covered < kNoFace)
    return {{place,
             fmt::format("only {} of 100 places of a face lie near the scan; expected {} at least, where its "
                         "landmarks say that it is",
                         count_percent(worth.covered), count_percent(kNoFace)),
             "", false}};
  if (worth.agreeing < kNoSurface)
    return {{place,
             fmt::format(
                 "{} of 100 places of the scan's face look another way than a face does there; expected {} "
                 "at most: its triangles make no surface",
                 100 - count_percent(worth.agreeing), 100 - count_percent(kNoSurface)),
             "", false}};
  std::vector<Diagnostic> warnings;
  const auto warn = [&](const std::string& message) { warnings.push_back({place, message, "", true}); };
  if (worth.covered < kLeastCovered)
    warn(fmt::format(
        "only {} of 100 places of the face lie near the scan: the others are made up; scan more of "
        "the face, or see whether its landmarks are right",
        count_percent(worth.covered)));
  if (worth.agreeing < kLeastAgreeing)
    warn(fmt::format(
        "{} of 100 places of the scan's face look another way than the wrapped skin: smooth the scan, "
        "or see whether its triangles are right",
        100 - count_percent(worth.agreeing)));
  if (worth.rms_mm > kMostRms_mm || worth.off > kMostOff)
    warn(fmt::format(
        "the wrapped face lies {:.1f} mm from the scan in the mean, and {} of 100 places further than "
        "{} mm: see whether the landmarks are right, and whether the scan is of one face at rest",
        worth.rms_mm, count_percent(worth.off), kOff_mm));
  if (worth.stray_points > kMostStray)
    warn(fmt::format(
        "{} of 100 points of the scan about the face lie further than {} mm from the wrapped skin: "
        "they are no part of it; take out hair, glasses and noise",
        count_percent(worth.stray_points), kStray_mm));
  if (worth.folded > kMostFolded)
    warn(
        fmt::format("{} triangles of the wrapped face are turned over: see whether the landmarks beside each "
                    "other are right",
                    worth.folded));
  if (worth.mark_mm > kMostMark_mm) {
    const ScanMark& mark = scan.marks[worth.worst_mark];
    warnings.push_back(
        {mark.said.place.file.empty() ? place : mark.said.place,
         fmt::format("landmark '{}' lies {:.1f} mm from where the wrapped head has it: the scan or "
                     "the landmarks around it say otherwise",
                     mark.name, worth.mark_mm),
         mark.said.line, true});
  }
  return warnings;
}

}  // namespace mien

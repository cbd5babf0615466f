#include "face/lid_rig.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

#include "core/conventions.hpp"
#include "face/lid_place.hpp"
#include "head/cage.hpp"
#include "head/contact.hpp"
#include "head/surface.hpp"

namespace mien {

namespace {

constexpr std::array kEdgeRings{"E0", "E1"};
constexpr double kClear_mm = 0.1;      // of the inner edge off ball and cornea; at rest it may lie nearer
constexpr double kWideClear_mm = 0.4;  // of lids that a design opens wide: their columns lie further apart

std::vector<LidRing> build_rings(const NeutralHead& head, const LidData& data) {
  const double size = head.eye.radius_mm / head.adult_eye.radius_mm;
  std::vector<LidRing> rings;
  for (const auto& [name, share] : data.rows_upper) {
    LidRing ring;
    ring.is_inner = name == "EB" || name == kEdgeRings[0];
    ring.upper_share = ring.shut_share = share;
    if (const auto shut = data.rows_shut.find(name); shut != data.rows_shut.end())
      ring.shut_share = shut->second;
    ring.lower_share = data.rows_lower.at(name);
    if (const auto least = data.least_radius.find(name); least != data.least_radius.end())
      ring.least_radius_mm = least->second * size;
    if (const auto bulge = data.raised_bulge.find(name); bulge != data.raised_bulge.end())
      ring.bulge = bulge->second * size;
    for (int column = 0; column < kLidColumns; ++column) {
      ring.left[column] = find_point(head.cage, fmt::format("{}_{}", name, column));
      ring.right[column] = head.cage.mirror[ring.left[column]];
      ring.rest[column] = head.cage.points[ring.left[column]];
    }
    rings.push_back(ring);
  }
  return rings;
}

LidEdge build_edge(const NeutralHead& head, const std::vector<LidRing>& rings, const std::string& name) {
  LidEdge edge;
  std::map<std::uint32_t, LidShare> places;  // of each point in the rings
  for (std::size_t r = 0; r < rings.size(); ++r)
    for (int column = 0; column < kLidColumns; ++column) places[rings[r].left[column]] = {r, column, 0};
  const Surface& surface = *head.surface;
  for (int column = 0; column < kLidColumns; ++column) {
    const std::uint32_t point = find_point(head.cage, fmt::format("{}_{}", name, column));
    edge.ring = places.at(point).ring;
    for (std::uint32_t k = surface.first[point]; k < surface.first[point + 1]; ++k) {
      LidShare share = places.at(surface.point[k]);
      share.share = surface.weight[k];
      edge.shares[column].push_back(share);
    }
  }
  return edge;
}

void measure_edge(const LidRig& rig, const RingPoints& points, LidEdge& edge) {
  for (int column = 0; column < kLidColumns; ++column) {
    const glm::dvec3 on_skin = compute_on_skin(edge, column, points);
    const LidPlace place = find_place(rig, on_skin);
    edge.clear_mm[column] = std::min(std::lerp(kClear_mm, kWideClear_mm, rig.pairing),
                                     compute_standoff_mm(rig.eye_numbers, rig.eye, on_skin));
    const auto set = [&](int row, LidRow& height, LidRow& along, LidRow& radius) {
      height[row] = place.height_rad;
      along[row] = place.along_mm;
      radius[row] = place.radius_mm;
    };
    if (column <= 8) set(column, edge.upper_rad, edge.upper_along_mm, edge.upper_radius_mm);
    if (column == 0 || column >= 8)
      set(column == 0 ? 0 : kLidColumns - column, edge.lower_rad, edge.lower_along_mm, edge.lower_radius_mm);
  }
}

}  // namespace

LidRig build_lid_rig(const NeutralHead& head, const LidData& data) {
  LidRig rig;
  rig.eye = head.eye;
  rig.eye_numbers = head.data->parts.eye;
  rig.rings = build_rings(head, data);
  // Lids that a design opens wide meet on a line that falls steeply beside the corners: what differs a little
  // in its place along it would miss the other.
  constexpr double kWide = 0.5;
  rig.pairing = std::clamp((head.design.eye_opening - 1) / kWide, 0.0, 1.0);
  rig.least_gap_rad = data.least_gap_deg * kRadiansPerDegree;
  rig.wide_rad = data.wide_deg * kRadiansPerDegree;
  rig.raised_rad = data.raised_deg * kRadiansPerDegree;
  rig.follow_up = data.follow_up;
  rig.follow_down = data.follow_down;
  rig.follow_lower = data.follow_lower;
  RingPoints rest;
  for (const LidRing& ring : rig.rings) rest.push_back(ring.rest);
  for (std::size_t e = 0; e < 2; ++e) rig.edges[e] = build_edge(head, rig.rings, kEdgeRings[e]);
  const glm::dvec3 across = compute_on_skin(rig.edges[1], 8, rest) - compute_on_skin(rig.edges[1], 0, rest);
  rig.axis = glm::normalize(glm::dvec3(across.x, across.y, 0));
  for (LidEdge& edge : rig.edges) measure_edge(rig, rest, edge);
  const auto find_ring = [&](const std::string& name) {
    const std::uint32_t point = find_point(head.cage, name + "_0");
    return static_cast<std::size_t>(
        std::ranges::find_if(rig.rings, [&](const LidRing& ring) { return ring.left[0] == point; }) -
        rig.rings.begin());
  };
  rig.lid_ring = find_ring("E2");
  rig.fold_ring = find_ring("E3");
  rig.fold_least = data.fold_least;
  rig.fold_forward = data.fold_forward;
  rig.taper = data.column_taper;
  // Columns that a design brings beside each other do not slide as well.
  const double size = (1 - rig.pairing) * head.eye.radius_mm / head.adult_eye.radius_mm;
  for (int i = 0; i < 9; ++i) {
    rig.slide_upper_mm[i] = size * data.slide_upper[i];
    rig.slide_lower_mm[i] = size * data.slide_lower[i];
  }
  rig.meeting = data.meeting;
  return rig;
}

}  // namespace mien

#include "head/hair_lines.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/conventions.hpp"
#include "head/binding.hpp"
#include "head/hair.hpp"
#include "head/hair_comb.hpp"
#include "head/hair_drawn.hpp"
#include "head/hair_edge.hpp"
#include "head/hair_growth.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

constexpr std::uint32_t kLineSeries = 63;  // of scatter()
constexpr double kLineStep_mm = 9;         // of the adult

struct LinePath {
  std::vector<HairPlace> places;
  double begins = 0, width = 1, ends = 0;
  std::optional<std::size_t> column = std::nullopt;  // of the edge, that it begins at
};

glm::dvec3 find_on_ground(const HairScene& scene, const HairPlace& place) {
  return compute_hair_point(scene.chart, place, compute_ground_mm(scene, place));
}

// Along the way that hair is combed, `hand` 1, or against it, -1; not beyond the part or the knot.
std::vector<HairPlace> follow_comb(const HairScene& scene, HairPlace place, double length_mm, double hand) {
  constexpr double kStopped_mm = 15;
  const double size = scene.chart.size;
  constexpr double kFirst_mm = 1.5, kLonger = 1.5;  // steps grow: at its border hair is round
  std::vector<HairPlace> places{place};
  double step_mm = kFirst_mm;
  for (double gone_mm = 0; gone_mm < length_mm; gone_mm += step_mm) {
    if (gone_mm > 0) step_mm = std::min(kLineStep_mm, kLonger * step_mm);
    const glm::dvec3 at = find_on_ground(scene, place);
    const bool is_gathered = scene.cut.comb.is_gathered;
    const double left_mm =
        is_gathered ? glm::distance(at, scene.knot) : compute_part_arm(scene, at).distance_mm;
    if ((hand < 0) != is_gathered && left_mm < kStopped_mm * size) break;
    const glm::dvec3 way = compute_comb_way(scene, place, is_gathered ? 0 : left_mm / size);
    place = compute_hair_place(scene.chart, at + hand * step_mm * size * way);
    places.push_back(place);
  }
  return places;
}

// Where locks part, some further up than others; beside the face and at the back, where hair hangs, longest.
void add_partings(const HairScene& scene, std::vector<LinePath>& paths) {
  constexpr double kLeast_mm = 7, kShort_mm = 14, kLong_mm = 58, kHanging_mm = 46;
  std::size_t count = 0;
  const std::vector<DrawnEdge> edges = trace_drawn_edge(scene);
  for (std::size_t column = 0; column < edges.size(); ++column) {
    const DrawnEdge& edge = edges[column];
    if (edge.across != -1 || edge.deep_mm < kLeast_mm) continue;
    const auto index = static_cast<std::uint32_t>(count++);
    const double azimuth = wrap_azimuth(edge.turn_deg);
    const double share = step_golden(index);
    const double hangs = std::clamp(2 * (edge.way - 1), 0.0, 1.0);
    paths.push_back({follow_comb(scene, {azimuth, edge.way},
                                 kShort_mm + share * kLong_mm + hangs * (0.3 + share) * kHanging_mm, -1),
                     0.7, 0.6 + 0.25 * share, 0, column});
  }
}

void add_part_line(const HairScene& scene, std::vector<LinePath>& paths) {
  constexpr int kPlaces = 14;
  if (!has_part(scene)) return;
  LinePath& part = paths.emplace_back(LinePath{{}, 0.3, 0.75});
  for (int i = 0; i < kPlaces; ++i)
    part.places.push_back(compute_part_place(scene, static_cast<double>(i) / (kPlaces - 1)));
}

// Down from the part, a little beside it.
void add_beside_part(const HairScene& scene, std::vector<LinePath>& paths) {
  constexpr double kBeside_mm = 10, kFirst = 0.2, kStep = 0.33, kShort_mm = 26, kMore_mm = 34;
  constexpr int kLines = 3;
  if (!has_part(scene)) return;
  for (const double side : {-1.0, 1.0})
    for (int i = 0; i < kLines; ++i) {
      const double along = kFirst + kStep * i + (side > 0 ? 0.1 : 0);
      const double more = scatter(kLineSeries, static_cast<std::uint32_t>(i), side > 0 ? 1 : 0);
      const glm::dvec3 at = find_on_ground(scene, compute_part_place(scene, std::min(1.0, along)));
      const HairPlace begins =
          compute_hair_place(scene.chart, at + glm::dvec3(side * kBeside_mm * scene.chart.size, 0, 0));
      paths.push_back({follow_comb(scene, begins, kShort_mm + more * kMore_mm, 1), 0.15, 0.6});
    }
}

// From the border toward the knot.
void add_gathered(const HairScene& scene, std::vector<LinePath>& paths) {
  constexpr int kLines = 23;
  constexpr double kInside = 0.97, kShort = 0.3, kMore = 0.42;
  if (!scene.cut.comb.is_gathered) return;
  for (int i = 0; i < kLines; ++i) {
    const double azimuth = wrap_azimuth(360 * (i + 0.3) / kLines);
    const HairPlace begins{azimuth, kInside * sample_border(scene.hairline, azimuth)};
    const double share = step_golden(static_cast<std::uint32_t>(i));
    const double whole_mm = glm::distance(find_on_ground(scene, begins), scene.knot) / scene.chart.size;
    paths.push_back({follow_comb(scene, begins, (kShort + share * kMore) * whole_mm, 1), 0.55, 0.7});
  }
}

// A few in what hangs, under the ring of light and over its ends, that begin and end in nothing.
void add_hanging(const HairScene& scene, std::vector<LinePath>& paths) {
  constexpr int kStrands = 14;
  constexpr double kFrom_deg = 62, kHigh = 0.45, kMore = 0.25, kShort_mm = 26, kMore_mm = 40;
  for (int i = 0; i < kStrands; ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    const double azimuth = wrap_azimuth(std::lerp(kFrom_deg, 360 - kFrom_deg, (i + 0.5) / kStrands));
    const HairPlace begins{azimuth,
                           (kHigh + kMore * step_golden(index)) * sample_border(scene.ends, azimuth)};
    paths.push_back(
        {follow_comb(scene, begins, kShort_mm + kMore_mm * scatter(kLineSeries, index, 5), 1), 0.05, 0.6});
  }
}

// A few between the border and the crown that begin and end in nothing.
void add_free(const HairScene& scene, std::vector<LinePath>& paths) {
  constexpr int kRoots = 26;
  constexpr double kFrom_deg = 52, kLow = 0.5, kHigh = 0.88, kShort_mm = 22, kMore_mm = 30;
  if (scene.cut.comb.is_gathered) return;
  if (scene.cut.covers_ears) {
    add_hanging(scene, paths);
    return;
  }
  const std::vector<HairPlace> roots = spread_roots(scene, kRoots, 0, false);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const double share = roots[i].way / sample_border(scene.hairline, roots[i].azimuth_deg);
    if (std::abs(roots[i].azimuth_deg) < kFrom_deg || share < kLow || share > kHigh) continue;
    const double more = scatter(kLineSeries, static_cast<std::uint32_t>(i), 4);
    paths.push_back({follow_comb(scene, roots[i], kShort_mm + more * kMore_mm, 1), 0.05, 0.65});
  }
}

// Curls: arcs within a few of them.
void add_curls(const HairScene& scene, std::vector<LinePath>& paths) {
  constexpr int kArcs = 34, kPlaces = 9;
  constexpr double kRadius_mm = 11, kLong_deg = 230;
  if (scene.cut.locks.curl_mm <= 0) return;
  const std::vector<HairPlace> middles = spread_roots(scene, kArcs, 0, false);
  for (std::size_t i = 0; i < middles.size(); ++i) {
    const glm::dvec3 at = find_on_ground(scene, middles[i]), out = compute_ground_normal(scene, middles[i]);
    const glm::dvec3 aside = glm::normalize(glm::cross(glm::dvec3(0, 1, 0.01), out)),
                     up = glm::cross(out, aside);
    const double from_deg = 360 * scatter(kLineSeries, static_cast<std::uint32_t>(i), 2),
                 turns = scatter(kLineSeries, static_cast<std::uint32_t>(i), 3) > 0.5 ? 1 : -1;
    LinePath path{{}, 0.1, 0.75};
    for (int k = 0; k < kPlaces; ++k) {
      const double share = static_cast<double>(k) / (kPlaces - 1);
      const double turn = (from_deg + turns * kLong_deg * share) * kRadiansPerDegree;
      const double radius = kRadius_mm * scene.chart.size * (1 - 0.5 * share);
      path.places.push_back(
          compute_hair_place(scene.chart, at + radius * (std::cos(turn) * aside + std::sin(turn) * up)));
    }
    paths.push_back(path);
  }
}

// In waves, where hair has them.
void wave_line(const HairScene& scene, LinePath& path) {
  constexpr double kAside_mm = 5, kRadius_mm = 95;
  const double length_mm = scene.cut.locks.wave_length_mm;
  if (scene.cut.locks.wave_mm <= 0) return;
  double gone_mm = 0;
  glm::dvec3 before = find_on_ground(scene, path.places.front());
  for (HairPlace& place : path.places) {
    const glm::dvec3 at = find_on_ground(scene, place);
    gone_mm += glm::distance(at, before) / scene.chart.size;
    before = at;
    const double aside = kAside_mm * std::sin(2 * std::numbers::pi * gone_mm / length_mm);
    place.azimuth_deg = wrap_azimuth(place.azimuth_deg + aside / kRadius_mm / kRadiansPerDegree);
  }
}

double measure_length(const std::vector<glm::dvec3>& way) {
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length += glm::distance(way[i - 1], way[i]);
  return length;
}

// Not past `edge`, that of the mass; anywhere where it is empty.
bool is_in_mass(const std::vector<DrawnEdge>& edge, const HairPlace& place) {
  constexpr double kPast = 0.01;
  if (edge.empty()) return true;
  const auto away_deg = [&](const DrawnEdge& here) {
    return std::abs(wrap_azimuth(here.turn_deg + here.bent_deg - place.azimuth_deg));
  };
  const auto nearest = std::min_element(
      edge.begin(), edge.end(), [&](const auto& a, const auto& b) { return away_deg(a) < away_deg(b); });
  return place.way <= nearest->way + kPast;
}

// No line leaves the hair or crosses one before it: it ends where it would, and short ones are none.
void part_lines(const HairScene& scene, std::vector<LinePath>& paths) {
  constexpr double kApart_mm = 8, kLeast_mm = 16;
  // A line would go on over a free ear; hair that covers ears has none where it could leave it.
  const std::vector<DrawnEdge> edge =
      scene.cut.covers_ears ? std::vector<DrawnEdge>{} : trace_drawn_edge(scene);
  std::vector<std::vector<glm::dvec3>> ways;
  std::vector<LinePath> kept;
  for (LinePath& path : paths) {
    std::vector<glm::dvec3> way;
    path.places.erase(path.places.begin(), std::ranges::find_if(path.places, [&](const HairPlace& place) {
                        return is_in_mass(edge, place);
                      }));
    for (const HairPlace& place : path.places) way.push_back(find_on_ground(scene, place));
    std::size_t count = 0;
    const auto is_free = [&](const glm::dvec3& at) {
      for (const std::vector<glm::dvec3>& other : ways)
        for (const glm::dvec3& p : other)
          if (glm::distance(at, p) < kApart_mm * scene.chart.size) return false;
      return true;
    };
    while (count < way.size() && is_in_mass(edge, path.places[count]) && is_free(way[count])) ++count;
    way.resize(count);
    path.places.resize(count);
    if (measure_length(way) < kLeast_mm * scene.chart.size) continue;
    ways.push_back(std::move(way));
    kept.push_back(std::move(path));
  }
  paths = std::move(kept);
}

// Where the way out from the axis meets the outside of the mass.
MeshPlace find_on_mass(const HairScene& scene, const Mesh& mass, const SkinPatch& patch,
                       const HairPlace& place) {
  constexpr int kRounds = 5;  // of coming nearer
  SkinPlace nearest;
  double out_mm = compute_ground_mm(scene, place) + scene.chart.size * compute_thickness_mm(scene, place);
  for (int round = 0; round < kRounds; ++round) {
    nearest = find_nearest_place(patch, glm::vec3(compute_hair_point(scene.chart, place, out_mm)));
    const glm::dvec3 from = compute_hair_point(scene.chart, place, 0);
    out_mm = glm::dot(glm::dvec3(nearest.point) - from, compute_hair_direction(scene.chart, place));
  }
  return {mass.triangles[nearest.triangle], nearest.barycentric};
}

glm::dvec3 find_point(const Mesh& mass, const MeshPlace& place) {
  glm::dvec3 at(0);
  for (int i = 0; i < 3; ++i)
    at += static_cast<double>(place.shares[i]) * glm::dvec3(mass.positions[place.vertices[i]]);
  return at;
}

// The line begins in the corner itself and goes along the groove above it, which is as narrow as a line: near
// it, what is nearest lies on one side.
void begin_at_edge(const HairScene& scene, const Mesh& mass, std::size_t column,
                   std::vector<MeshPlace>& places) {
  constexpr double kGroove_mm = 12, kGap_mm = 6;
  const auto find = [&](const MeshPlace& place) { return find_point(mass, place); };
  std::vector<MeshPlace> groove;
  for (const std::uint32_t v : list_drawn_column(column)) {
    const MeshPlace place{{v, v, v}, {1, 0, 0}};
    if (groove.size() > 1 && glm::distance(find(place), find(groove.front())) > kGroove_mm * scene.chart.size)
      break;
    groove.push_back(place);
  }
  // Hair that is combed across the groove goes another way: the line ends with it.
  constexpr double kStraight = 0.8;  // cosine
  const glm::dvec3 corner = find(groove.front());
  const double gone_mm = glm::distance(find(groove.back()), corner) + kGap_mm * scene.chart.size;
  glm::dvec3 way = glm::normalize(find(groove.back()) - corner);
  for (const MeshPlace& place : places) {
    if (glm::distance(find(place), corner) < gone_mm) continue;
    const glm::dvec3 on = glm::normalize(find(place) - find(groove.back()));
    if (glm::dot(on, way) < kStraight) break;
    way = on;
    groove.push_back(place);
  }
  places = std::move(groove);
}

// Waves and grooves move lines toward each other: one ends where it comes near another before it.
void end_where_near(const Mesh& mass, const std::vector<HairLine>& lines, std::vector<MeshPlace>& places) {
  constexpr double kClose_mm = 2.5;
  const auto is_near = [&](const MeshPlace& place) {
    const glm::dvec3 at = find_point(mass, place);
    for (const HairLine& line : lines)
      for (const MeshPlace& other : line.places)
        if (glm::distance(at, find_point(mass, other)) < kClose_mm) return true;
    return false;
  };
  places.erase(std::ranges::find_if(places, is_near), places.end());
}

// Where the wall below the mass's edge goes into the skin.
MeshPlace find_edge_place(const HairScene& scene, const Mesh& mass, const HairPlace& place,
                          std::size_t column, std::size_t columns) {
  const auto [outer, inner] = find_drawn_rim(column, columns);
  const glm::dvec3 from = compute_hair_point(scene.chart, place, 0),
                   out = compute_hair_direction(scene.chart, place);
  const double outer_mm = glm::dot(glm::dvec3(mass.positions[outer]) - from, out),
               inner_mm = glm::dot(glm::dvec3(mass.positions[inner]) - from, out),
               skin_mm = sample_hair_chart(scene.chart, scene.chart.skin_mm, place);
  const auto share =
      static_cast<float>(std::clamp((outer_mm - skin_mm) / std::max(1e-6, outer_mm - inner_mm), 0.0, 1.0));
  return {{outer, inner, inner}, {1 - share, share, 0}};
}

// The edge itself where it lies on the skin: what is drawn behind hair does not show there.
void append_edge_lines(const HairScene& scene, const Mesh& mass, std::vector<HairLine>& lines) {
  constexpr double kFront_deg = 52, kWidth = 0.55;
  if (scene.cut.covers_ears) return;
  const std::vector<DrawnEdge> edge = trace_drawn_edge(scene);
  HairLine line{{}, kWidth, kWidth, kWidth};
  double begins_deg = 0;
  for (std::size_t i = 0; i <= edge.size(); ++i) {
    const std::size_t column = i % edge.size();
    const DrawnEdge &here = edge[column], &before = edge[(column + edge.size() - 1) % edge.size()];
    const double azimuth_deg = wrap_azimuth(here.turn_deg + here.bent_deg);
    const bool is_corner = here.lock != before.lock || (before.across < 0 && here.across >= 0);
    line.places.push_back(find_edge_place(scene, mass, {azimuth_deg, here.way}, column, edge.size()));
    if (!is_corner && i < edge.size()) continue;
    if (line.places.size() > 1 && std::abs(begins_deg) > kFront_deg && std::abs(azimuth_deg) > kFront_deg)
      lines.push_back(line);
    line.places = {line.places.back()};
    begins_deg = azimuth_deg;
  }
}

}  // namespace

std::vector<HairLine> list_hair_lines(const NeutralHead& head, const std::string& cut, const Mesh& mass) {
  std::vector<HairLine> lines;
  if (!(find_drawn_cut(head, cut).mass > 0)) return lines;
  const HairScene scene = build_hair_scene(head, find_drawn_cut(head, cut));
  std::vector<LinePath> paths;
  add_part_line(scene, paths);
  if (scene.cut.locks.curl_mm > 0)
    add_curls(scene, paths);
  else
    add_partings(scene, paths);
  add_beside_part(scene, paths);
  add_free(scene, paths);
  add_gathered(scene, paths);
  const SkinPatch patch = build_skin_patch(mass, compute_bounds(mass.positions));
  part_lines(scene, paths);
  for (LinePath& path : paths) {
    if (path.ends == 0) wave_line(scene, path);
    HairLine line{{}, path.begins, path.width, path.ends};
    for (const HairPlace& place : path.places) line.places.push_back(find_on_mass(scene, mass, patch, place));
    if (path.column && scene.cut.covers_ears) begin_at_edge(scene, mass, *path.column, line.places);
    end_where_near(mass, lines, line.places);
    if (line.places.size() > 1) lines.push_back(std::move(line));
  }
  append_edge_lines(scene, mass, lines);
  return lines;
}

}  // namespace mien

// Borders are told from each other by where they run, not by the numbers of their control points: most
// programs write each patch with points of its own.
#include "import/patches.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "core/signals.hpp"
#include "import/reading.hpp"

namespace mien {

namespace {

constexpr double kChord = 1.0 / 4000;   // of the size of all: a tenth of a millimetre on a head
constexpr double kOwnChord = 1.0 / 50;  // of a patch's own: a point astray does not make the others flat
constexpr int kMostSteps = 64;          // of a span
constexpr std::size_t kFinePoints = 500'000;    // a head needs a tenth of them
constexpr std::size_t kMostProbes = 4'000'000;  // more take seconds; two a span do then
constexpr double kSamePlace = 1e-6;   // of the size: borders are the same curve to the last digits written
constexpr double kLeastSame = 1e-11;  // in the file's unit; cells stay countable
constexpr int kBorderSteps = 4;       // of a span: where borders are compared

// A patch ready to be looked at from place to place.
struct Weave {
  const SplinePatch* patch = nullptr;
  std::array<std::vector<std::size_t>, 2> spans;  // along u and v
  std::array<int, 2> steps{1, 1};                 // of each span
  double size = 0;
};

glm::dvec3 divide(const glm::dvec4& sum) { return glm::dvec3(sum) / sum.w; }

std::vector<SplineRow> build_rows_along(const Weave& weave, int way, int steps) {
  const SplinePatch& patch = *weave.patch;
  return build_spline_rows(way == 0 ? patch.u : patch.v, weave.spans[way], patch.low[way], patch.high[way],
                           steps);
}

// The places of one row along u, or, with `way` 1, along v, at each of `rows` of the other axis.
std::vector<glm::dvec3> sample_line(const Weave& weave, int way, const SplineRow& at,
                                    const std::vector<SplineRow>& rows) {
  const SplinePatch& patch = *weave.patch;
  const SplineAxis &across = way == 0 ? patch.u : patch.v, &along = way == 0 ? patch.v : patch.u;
  const std::size_t width = patch.u.point_count();
  const auto point = [&](std::size_t i, std::size_t j) {  // i of `across`, j of `along`
    glm::dvec4 p = way == 0 ? patch.points[j * width + i] : patch.points[i * width + j];
    return glm::dvec4(glm::dvec3(p) * p.w, p.w);
  };
  std::vector<glm::dvec4> curve(along.point_count(), glm::dvec4(0));  // the control points of this line
  const std::size_t first = rows.front().first,
                    last = rows.back().first + static_cast<std::size_t>(along.degree);
  for (std::size_t j = first; j <= last; ++j)
    for (std::size_t i = 0; i <= static_cast<std::size_t>(across.degree); ++i)
      curve[j] += at.shares[i] * point(at.first + i, j);
  std::vector<glm::dvec3> places;
  for (const SplineRow& row : rows) {
    glm::dvec4 sum(0);
    for (std::size_t j = 0; j <= static_cast<std::size_t>(along.degree); ++j)
      sum += row.shares[j] * curve[row.first + j];
    places.push_back(divide(sum));
  }
  return places;
}

// Where a curve through a, b, c, evenly apart, bends furthest from its chords.
double compute_sag(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return glm::length(a - 2.0 * b + c) / 8;
}

// A direction without a bend takes one step: straight lines with even weights.
bool is_straight(const Weave& weave, int way) {
  const SplinePatch& patch = *weave.patch;
  const double weight = patch.points.front().w;
  return (way == 0 ? patch.u : patch.v).degree == 1 &&
         std::ranges::all_of(patch.points, [&](const glm::dvec4& p) { return p.w == weight; });
}

// How many steps of each span keep within the tolerance. The sag falls with the square of their number.
void choose_steps(Weave& weave, double tolerance) {
  std::array<std::size_t, 2> probes{};
  std::size_t count = 1;
  for (const int way : {0, 1}) {
    const int degree = (way == 0 ? weave.patch->u : weave.patch->v).degree;
    probes[way] = is_straight(weave, way) ? 1 : static_cast<std::size_t>(std::max(2, degree));
    count *= weave.spans[way].size() * probes[way];
  }
  if (count > kMostProbes)
    for (std::size_t& each : probes) each = std::min(each, std::size_t{2});
  const std::vector<SplineRow> across = build_rows_along(weave, 0, static_cast<int>(probes[0])),
                               along = build_rows_along(weave, 1, static_cast<int>(probes[1]));
  std::array<double, 2> sags{};
  std::vector<glm::dvec3> before, last, line;
  // Three places of one span: the middle one is no knot.
  const auto is_within_span = [](std::size_t i, std::size_t steps) { return i >= 2 && (i - 1) % steps != 0; };
  for (std::size_t i = 0; i < across.size(); ++i) {
    before = std::move(last);
    last = std::move(line);
    line = sample_line(weave, 0, across[i], along);
    for (std::size_t j = 0; j < line.size(); ++j) {
      if (is_within_span(i, probes[0])) sags[0] = std::max(sags[0], compute_sag(before[j], last[j], line[j]));
      if (is_within_span(j, probes[1]))
        sags[1] = std::max(sags[1], compute_sag(line[j - 2], line[j - 1], line[j]));
    }
  }
  for (const int way : {0, 1})
    weave.steps[way] = static_cast<int>(
        std::clamp(std::ceil(static_cast<double>(probes[way]) * std::sqrt(sags[way] / tolerance)), 1.0,
                   double{kMostSteps}));
}

// Places that are one within the tolerance, by number.
struct Welder {
  double same = 0;
  std::map<std::array<std::int64_t, 3>, std::vector<std::uint32_t>> cells;
  std::vector<glm::dvec3> places;
};

std::array<std::int64_t, 3> find_cell(const Welder& welder, const glm::dvec3& place) {
  const glm::dvec3 cell = glm::floor(place / (4 * welder.same));
  return {static_cast<std::int64_t>(cell.x), static_cast<std::int64_t>(cell.y),
          static_cast<std::int64_t>(cell.z)};
}

std::uint32_t weld_place(Welder& welder, const glm::dvec3& place) {
  const auto low = find_cell(welder, place - welder.same), high = find_cell(welder, place + welder.same);
  for (std::int64_t x = low[0]; x <= high[0]; ++x)
    for (std::int64_t y = low[1]; y <= high[1]; ++y)
      for (std::int64_t z = low[2]; z <= high[2]; ++z) {
        const auto found = welder.cells.find({x, y, z});
        if (found == welder.cells.end()) continue;
        for (const std::uint32_t known : found->second)
          if (glm::distance(welder.places[known], place) <= welder.same) return known;
      }
  const auto next = static_cast<std::uint32_t>(welder.places.size());
  welder.places.push_back(place);
  welder.cells[find_cell(welder, place)].push_back(next);
  return next;
}

// One side of a patch. `way` is the axis that it runs along; counter-clockwise, sides 0 and 1 run with their
// axis, 2 and 3 against it.
struct Border {
  std::uint32_t patch = 0;
  int way = 0;
  bool is_backwards = false;  // going round, as seen by who goes along the known curve
};

using BorderKey = std::vector<std::uint32_t>;  // the places along it, by number

// All borders by their curves. Those that are one point only are none.
std::map<BorderKey, std::vector<Border>> list_borders(const std::vector<Weave>& weaves, double same) {
  Welder welder{same, {}, {}};
  std::map<BorderKey, std::vector<Border>> borders;
  for (std::uint32_t p = 0; p < weaves.size(); ++p) {
    throw_if_interrupted();
    for (const int across : {0, 1}) {
      const std::vector<SplineRow> ends = build_rows_along(weaves[p], across, 1),
                                   rows = build_rows_along(weaves[p], 1 - across, kBorderSteps);
      for (const bool is_high : {false, true}) {
        BorderKey key;
        for (const glm::dvec3& place :
             sample_line(weaves[p], across, is_high ? ends.back() : ends.front(), rows))
          key.push_back(weld_place(welder, place));
        if (std::ranges::all_of(key, [&](std::uint32_t n) { return n == key.front(); })) continue;
        BorderKey turned(key.rbegin(), key.rend());
        const bool is_turned = turned < key;
        // Round the patch: along u at the low v, along v at the high u; back at the others.
        const bool is_against = (across == 1) == is_high;
        borders[is_turned ? std::move(turned) : std::move(key)].push_back(
            {p, 1 - across, is_against != is_turned});
      }
    }
  }
  return borders;
}

// Steps that meet at a border are the more of both, from patch to patch.
void agree_on_steps(std::vector<Weave>& weaves, const std::map<BorderKey, std::vector<Border>>& borders) {
  std::vector<std::uint32_t> leader(2 * weaves.size());
  std::iota(leader.begin(), leader.end(), 0);
  const auto find = [&](std::uint32_t node) {
    while (leader[node] != node) node = leader[node] = leader[leader[node]];
    return node;
  };
  const auto node = [](const Border& border) {
    return 2 * border.patch + static_cast<std::uint32_t>(border.way);
  };
  for (const auto& [key, sides] : borders)
    for (const Border& side : sides) leader[find(node(side))] = find(node(sides.front()));
  std::vector<int> most(leader.size(), 1);
  for (std::uint32_t i = 0; i < leader.size(); ++i)
    most[find(i)] = std::max(most[find(i)], weaves[i / 2].steps[i % 2]);
  for (std::uint32_t i = 0; i < leader.size(); ++i) weaves[i / 2].steps[i % 2] = most[find(i)];
}

// Which patches are to be turned for neighbours to face the same way.
std::vector<bool> agree_on_faces(const std::vector<Weave>& weaves,
                                 const std::map<BorderKey, std::vector<Border>>& borders) {
  std::vector<std::vector<std::pair<std::uint32_t, bool>>> neighbours(weaves.size());  // and whether unlike
  for (const auto& [key, sides] : borders) {
    if (sides.size() != 2 || sides[0].patch == sides[1].patch) continue;
    const bool is_unlike = sides[0].is_backwards == sides[1].is_backwards;
    neighbours[sides[0].patch].emplace_back(sides[1].patch, is_unlike);
    neighbours[sides[1].patch].emplace_back(sides[0].patch, is_unlike);
  }
  std::vector<bool> is_turned(weaves.size(), false), is_known(weaves.size(), false);
  for (std::uint32_t first = 0; first < weaves.size(); ++first) {
    if (is_known[first]) continue;
    std::vector<std::uint32_t> piece{first};
    is_known[first] = true;
    double turned = 0, all = 0;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const double area = weaves[piece[i]].size * weaves[piece[i]].size;
      all += area;
      if (is_turned[piece[i]]) turned += area;
      for (const auto& [next, is_unlike] : neighbours[piece[i]]) {
        if (is_known[next]) continue;
        is_known[next] = true;
        is_turned[next] = is_turned[piece[i]] != is_unlike;
        piece.push_back(next);
      }
    }
    if (turned > all / 2)
      for (const std::uint32_t p : piece) is_turned[p] = !is_turned[p];
  }
  return is_turned;
}

std::size_t count_points(const Weave& weave) {
  return (weave.spans[0].size() * static_cast<std::size_t>(weave.steps[0]) + 1) *
         (weave.spans[1].size() * static_cast<std::size_t>(weave.steps[1]) + 1);
}

std::size_t count_points(const std::vector<Weave>& weaves) {
  std::size_t count = 0;
  for (const Weave& weave : weaves) count += count_points(weave);
  return count;
}

// Corners that are one point count once; less than a triangle is nothing.
void add_polygon(Polygons& mesh, std::array<std::uint32_t, 4> corners, bool is_turned) {
  if (is_turned) std::swap(corners[1], corners[3]);
  std::vector<std::uint32_t> kept;
  for (const std::uint32_t corner : corners)
    if (std::ranges::find(kept, corner) == kept.end()) kept.push_back(corner);
  const bool is_pinched = corners[0] == corners[2] || corners[1] == corners[3];
  if (kept.size() < 3 || is_pinched) return;
  mesh.corners.insert(mesh.corners.end(), kept.begin(), kept.end());
  mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
}

// `known` has the number in the mesh of each of the welder's places.
void add_patch(const Weave& weave, bool is_turned, Welder& welder, std::vector<std::uint32_t>& known,
               Polygons& mesh) {
  const std::vector<SplineRow> across = build_rows_along(weave, 0, weave.steps[0]),
                               along = build_rows_along(weave, 1, weave.steps[1]);
  const auto add_point = [&](const glm::dvec3& place) {
    mesh.positions.push_back(place);
    mesh.lines.push_back(static_cast<std::uint32_t>(weave.patch->line));
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
  };
  std::vector<std::uint32_t> last, line;
  for (std::size_t i = 0; i < across.size(); ++i) {
    last = std::move(line);
    line.clear();
    const std::vector<glm::dvec3> places = sample_line(weave, 0, across[i], along);
    for (std::size_t j = 0; j < places.size(); ++j) {
      const bool is_border = i == 0 || i + 1 == across.size() || j == 0 || j + 1 == places.size();
      if (!is_border) {
        line.push_back(add_point(places[j]));
        continue;
      }
      const std::uint32_t number = weld_place(welder, places[j]);
      if (number == known.size()) known.push_back(add_point(places[j]));
      line.push_back(known[number]);
    }
    for (std::size_t j = 0; i > 0 && j + 1 < line.size(); ++j)
      add_polygon(mesh, {last[j], line[j], line[j + 1], last[j + 1]}, is_turned);
  }
}

struct Box {
  glm::dvec3 low{1e300}, high{-1e300};
};

void grow_box(Box& box, const SplinePatch& patch) {
  for (const glm::dvec4& p : patch.points) {
    box.low = glm::min(box.low, glm::dvec3(p));
    box.high = glm::max(box.high, glm::dvec3(p));
  }
}

}  // namespace

void add_patches(const std::string& file, const std::vector<SplinePatch>& patches, Polygons& mesh) {
  Box all;
  for (const SplinePatch& patch : patches) grow_box(all, patch);
  const double size = glm::distance(all.low, all.high);
  if (size < 1000 * kLeastSame)
    fail_line(file, patches.front().line, "all control points lie in one place; expected a surface");
  std::vector<Weave> weaves;
  for (const SplinePatch& patch : patches) {
    throw_if_interrupted();
    Box own;
    grow_box(own, patch);
    Weave& weave = weaves.emplace_back();
    weave.patch = &patch;
    weave.spans = {list_spans(patch.u, patch.low.x, patch.high.x),
                   list_spans(patch.v, patch.low.y, patch.high.y)};
    weave.size = glm::distance(own.low, own.high);
    choose_steps(weave, std::max(kSamePlace * size, std::min(kChord * size, kOwnChord * weave.size)));
  }
  const double same = std::max(kSamePlace * size, kLeastSame);
  const auto borders = list_borders(weaves, same);
  agree_on_steps(weaves, borders);
  for (int most = kMostSteps / 2; most > 0 && count_points(weaves) > kFinePoints; most /= 2)
    for (Weave& weave : weaves)
      for (int& steps : weave.steps) steps = std::min(steps, most);
  check_point_count(file, patches.back().line, mesh.positions.size() + count_points(weaves));
  const std::vector<bool> is_turned = agree_on_faces(weaves, borders);
  Welder welder{same, {}, {}};
  std::vector<std::uint32_t> known;
  for (std::size_t p = 0; p < weaves.size(); ++p) {
    throw_if_interrupted();
    add_patch(weaves[p], is_turned[p], welder, known, mesh);
  }
}

}  // namespace mien

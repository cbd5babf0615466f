#include "import/obj_surfaces.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "import/reading.hpp"

namespace mien {

namespace {

constexpr std::size_t kMostControlPoints = 500'000;  // a head has some thousands
constexpr double kMostKnot = 1e9;                    // further out, knots that differ would not
constexpr double kLightest = 1e-6, kHeaviest = 1e6;
constexpr double kRangeSlack = 1e-5;  // of the range: it is written with fewer digits than the knots

constexpr std::array<std::string_view, 5> kKinds{"bezier", "bspline", "bmatrix", "cardinal", "taylor"};
// What belongs to curves and surfaces and does not change these surfaces: how finely others draw them, curves
// on them, what joins them.
constexpr std::array<std::string_view, 9> kPassedBeside{"bmat", "step", "ctech",      "stech",    "scrv",
                                                        "sp",   "con",  "shadow_obj", "trace_obj"};
constexpr std::array<char, 2> kWays{'u', 'v'};

[[noreturn]] void fail(const ObjStatement& statement, const std::string& message) {
  fail_line(statement.file, statement.line, message);
}

void read_kind(const ObjStatement& statement, ObjSurfaces& surfaces) {
  const auto& words = statement.words;
  surfaces.is_rational = words.size() > 1 && words[1] == "rat";
  const std::size_t at = surfaces.is_rational ? 2 : 1;
  const std::string_view kind = at < words.size() ? words[at] : "";
  if (std::ranges::find(kKinds, kind) == kKinds.end())
    fail(statement, fmt::format("unknown cstype '{}'; expected bspline or bezier, or rat and one of them",
                                show_found(kind)));
  surfaces.kind = kind;
}

void read_degrees(const ObjStatement& statement, ObjSurfaces& surfaces) {
  surfaces.degrees = {0, 0};
  if (statement.words.size() < 2 || statement.words.size() > 3)
    fail(statement, "expected deg and one or two degrees, as in deg 3 3");
  for (std::size_t i = 1; i < statement.words.size(); ++i) {
    const auto degree = parse_index(statement.words[i]);
    if (!degree || *degree < 1 || *degree > kMaxSplineDegree)
      fail(statement, fmt::format("the degree is '{}'; expected a whole number from 1 to {}",
                                  show_found(statement.words[i]), kMaxSplineDegree));
    surfaces.degrees[i - 1] = static_cast<int>(*degree);
  }
}

double parse_knot(const ObjStatement& statement, std::string_view word) {
  const auto value = parse_coordinate(word);
  if (!value || std::abs(*value) > kMostKnot)
    fail(statement,
         fmt::format("'{}' is no parameter; expected a number from -1e9 to 1e9", show_found(word)));
  return *value;
}

void check_closed(const std::string& file, const ObjSurfaces& surfaces) {
  if (surfaces.open == ObjSurfaces::Open::surface)
    fail_line(file, surfaces.found.back().line,
              "the surface has no 'end'; expected surf, parm u, parm v and end");
}

void open_surface(const ObjStatement& statement, ObjSurfaces& surfaces) {
  check_closed(statement.file, surfaces);
  if (surfaces.kind != "bspline" && surfaces.kind != "bezier")
    fail(statement, surfaces.kind.empty()
                        ? "a surface before any 'cstype'; expected cstype bspline or cstype bezier first"
                        : fmt::format("a surface of cstype '{}'; expected bspline or bezier", surfaces.kind));
  if (surfaces.degrees[1] == 0)
    fail(statement, "a surface without two degrees; expected deg U V before it, as in deg 3 3");
  const auto& words = statement.words;
  if (words.size() < 9)
    fail(statement, "a surface of too few words; expected surf U0 U1 V0 V1 and 4 control points at least");
  ObjSurface& surface = surfaces.found.emplace_back();
  surfaces.open = ObjSurfaces::Open::surface;
  surface.line = statement.line;
  surface.is_rational = surfaces.is_rational;
  surface.is_bezier = surfaces.kind == "bezier";
  surface.degrees = surfaces.degrees;
  for (const std::size_t way : {0, 1}) {
    surface.low[way] = parse_knot(statement, words[1 + 2 * way]);
    surface.high[way] = parse_knot(statement, words[2 + 2 * way]);
  }
  surfaces.point_count += words.size() - 5;
  if (surfaces.point_count > kMostControlPoints)
    fail(statement, fmt::format("more than {} control points; expected fewer", kMostControlPoints));
  for (std::size_t i = 5; i < words.size(); ++i)
    surface.points.push_back(
        parse_point_number(statement.file, statement.line, words[i], statement.point_count, "surface"));
}

void read_knots(const ObjStatement& statement, ObjSurfaces& surfaces) {
  if (surfaces.open == ObjSurfaces::Open::curve) return;
  if (surfaces.open == ObjSurfaces::Open::nothing)
    fail(statement, "'parm' outside of a surface; expected it between 'surf' and 'end'");
  const auto& words = statement.words;
  const std::size_t way = words.size() > 1 && words[1] == "v" ? 1 : 0;
  if (words.size() < 2 || words[1].size() != 1 || words[1][0] != kWays[way])
    fail(statement, "expected parm u or parm v, and numbers");
  std::vector<double>& knots = surfaces.found.back().knots[way];
  if (!knots.empty())
    fail(statement, fmt::format("the surface has 'parm {}' twice; expected it once", kWays[way]));
  for (std::size_t i = 2; i < words.size(); ++i) {
    knots.push_back(parse_knot(statement, words[i]));
    if (i > 2 && knots.back() < knots[knots.size() - 2])
      fail(statement, fmt::format("'parm {}' falls from {:.7g} to {:.7g}; expected numbers that rise",
                                  kWays[way], knots[knots.size() - 2], knots.back()));
  }
}

void note_trim(const ObjStatement& statement, ObjSurfaces& surfaces) {
  if (surfaces.open != ObjSurfaces::Open::surface)
    fail(statement, fmt::format("'{}' outside of a surface; expected it between 'surf' and 'end'",
                                statement.words.front()));
  if (surfaces.trimmed_line == 0) surfaces.trimmed_line = statement.line;
  if (surfaces.last_trimmed == surfaces.found.size()) return;  // a surface may have several
  surfaces.last_trimmed = surfaces.found.size();
  ++surfaces.trimmed;
}

SplineAxis build_axis(const std::string& file, const ObjSurface& surface, std::size_t way) {
  const std::vector<double>& knots = surface.knots[way];
  const int degree = surface.degrees[way];
  const std::size_t least = surface.is_bezier ? 2 : 2 * static_cast<std::size_t>(degree) + 2;
  if (knots.size() < least)
    fail_line(file, surface.line,
              fmt::format("'parm {}' of the surface has {} number{}; expected {} at least for degree {}",
                          kWays[way], knots.size(), knots.size() == 1 ? "" : "s", least, degree));
  return surface.is_bezier ? build_bezier_axis(degree, knots) : SplineAxis{degree, knots};
}

// The part of the axis that is told, if it is one.
void set_range(const std::string& file, const ObjSurface& surface, std::size_t way, const SplineAxis& axis,
               SplinePatch& patch) {
  const double first = find_first_place(axis), last = find_last_place(axis),
               slack = kRangeSlack * (last - first);
  const double low = surface.low[way], high = surface.high[way];
  if (!(low < high) || !(first < last) || low < first - slack || high > last + slack)
    fail_line(file, surface.line,
              fmt::format("the surface goes from {0} = {1:.7g} to {2:.7g}; expected a part of {3:.7g} to "
                          "{4:.7g}, where its 'parm {0}' makes one",
                          kWays[way], low, high, first, last));
  const auto axis_at = static_cast<glm::length_t>(way);
  patch.low[axis_at] = std::max(low, first);
  patch.high[axis_at] = std::min(high, last);
}

SplinePatch build_patch(const std::string& file, const ObjSurface& surface,
                        const std::vector<glm::dvec3>& positions, const std::vector<double>& weights) {
  SplinePatch patch;
  patch.line = surface.line;
  patch.u = build_axis(file, surface, 0);
  patch.v = build_axis(file, surface, 1);
  const std::size_t across = patch.u.point_count(), along = patch.v.point_count();
  if (across * along != surface.points.size())
    fail_line(
        file, surface.line,
        fmt::format("a surface of {} control points; expected {}, {} by {}, as its degrees and its 'parm' "
                    "have it",
                    surface.points.size(), across * along, across, along));
  set_range(file, surface, 0, patch.u, patch);
  set_range(file, surface, 1, patch.v, patch);
  for (const std::uint32_t point : surface.points) {
    if (point >= positions.size())
      fail_line(file, surface.line,
                fmt::format("a surface names point {}; expected numbers from 1 to {}", point + 1,
                            positions.size()));
    const double weight = surface.is_rational ? weights[point] : 1;
    if (!(weight >= kLightest && weight <= kHeaviest))
      fail_line(
          file, surface.line,
          fmt::format("the surface's point {} has the weight {:.7g}; expected a number from 0.000001 to "
                      "1000000",
                      point + 1, weight));
    patch.points.emplace_back(positions[point], weight);
  }
  return patch;
}

}  // namespace

bool read_surface_statement(const ObjStatement& statement, ObjSurfaces& surfaces) {
  const std::string_view word = statement.words.front();
  if (word == "cstype") {
    read_kind(statement, surfaces);
  } else if (word == "deg") {
    read_degrees(statement, surfaces);
  } else if (word == "surf") {
    open_surface(statement, surfaces);
  } else if (word == "curv" || word == "curv2") {
    check_closed(statement.file, surfaces);
    surfaces.open = ObjSurfaces::Open::curve;
    if (surfaces.curve_line == 0) surfaces.curve_line = statement.line;
  } else if (word == "parm") {
    read_knots(statement, surfaces);
  } else if (word == "trim" || word == "hole") {
    note_trim(statement, surfaces);
  } else if (word == "end") {
    surfaces.open = ObjSurfaces::Open::nothing;
  } else {
    return std::ranges::find(kPassedBeside, word) != kPassedBeside.end();
  }
  return true;
}

std::vector<SplinePatch> build_patches(const std::string& file, const ObjSurfaces& surfaces,
                                       const std::vector<glm::dvec3>& positions,
                                       const std::vector<double>& weights) {
  check_closed(file, surfaces);
  std::vector<SplinePatch> patches;
  for (const ObjSurface& surface : surfaces.found)
    patches.push_back(build_patch(file, surface, positions, weights));
  return patches;
}

}  // namespace mien

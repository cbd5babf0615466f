// Limit positions are linear in the control points (Halstead, Kass, DeRose 1993), so a moved skin is a linear
// system for moved control points. Solved exactly it rings about a single dragged point; a little fairness of
// the displacement damps that.
#include "head/own_half.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "config/head_files.hpp"
#include "core/error.hpp"
#include "head/eye_fit.hpp"
#include "head/least_squares.hpp"
#include "head/surface.hpp"
#include "head/wrap.hpp"
#include "import/polygons.hpp"

namespace mien {

namespace {

constexpr double kDecimals = 1e4;               // an OBJ of ours holds four decimals
constexpr double kMiddle_mm = 0.05;             // what a point of the mid-plane may stray; it is put back
constexpr double kDisplacementFairness = 0.05;  // lower rings, higher melts small edits
constexpr int kRefinements = 2;                 // each brings the skin nearer to the asked places
constexpr double kHardWeight = 1000;            // a hard point goes where it was put

[[noreturn]] void fail_at_point(const Polygons& mesh, std::size_t point, const std::string& message) {
  const int line = point < mesh.lines.size() ? static_cast<int>(mesh.lines[point]) : 0;
  throw InputError(std::vector<Diagnostic>{{{mesh.file, line, 0}, message, "", false}});
}

// Faces as sorted lists of points: which one comes first and how they are turned is of no account.
std::vector<std::vector<std::uint32_t>> sort_faces(const Polygons& mesh) {
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    faces.emplace_back(mesh.corners.begin() + mesh.first[f], mesh.corners.begin() + mesh.first[f + 1]);
    std::ranges::sort(faces.back());
  }
  std::ranges::sort(faces);
  return faces;
}

bool has_our_faces(const HeadStock& stock, const Polygons& mesh) {
  if (mesh.positions.size() != stock.data->half.points.size()) return false;
  std::vector<std::vector<std::uint32_t>> ours;
  for (const Quad& quad : compute_half_quads(stock)) {
    ours.emplace_back(quad.begin(), quad.end());
    std::ranges::sort(ours.back());
  }
  std::ranges::sort(ours);
  return sort_faces(mesh) == ours;
}

// Turns a right half into a left one; throws for a mesh that is neither.
void put_on_left(Polygons& mesh) {
  const auto [low, high] = std::ranges::minmax_element(mesh.positions, {}, &glm::dvec3::x);
  if (low->x >= -kMiddle_mm) return;
  if (high->x <= kMiddle_mm) {
    for (glm::dvec3& p : mesh.positions) p.x = -p.x;
    return;
  }
  const bool is_left = -low->x < high->x;
  const auto stray = static_cast<std::size_t>((is_left ? low : high) - mesh.positions.begin());
  fail_at_point(
      mesh, stray,
      fmt::format("not a half: point {} is at x = {:.4g}, others are at x = {:.4g}; expected all on one "
                  "side of x = 0, to {} mm",
                  stray + 1, mesh.positions[stray].x, is_left ? high->x : low->x, kMiddle_mm));
}

void check_size(const HeadStock& stock, const Polygons& mesh) {
  const auto height = [](const std::vector<glm::dvec3>& points) {
    const auto [low, high] = std::ranges::minmax_element(points, {}, &glm::dvec3::y);
    return high->y - low->y;
  };
  const double ours = height(compute_half_places(stock, stock.adult.points)), theirs = height(mesh.positions);
  constexpr double kLeast = 0.3,
                   kMost = 3;  // of the adult: an infant's is 0.6, a metre instead of a mm 0.001
  if (theirs < kLeast * ours || theirs > kMost * ours)
    fail_at_point(
        mesh, mesh.positions.size(),
        fmt::format("the half is {:.4g} high; expected {:.0f} to {:.0f}, as its unit is the millimetre",
                    theirs, kLeast * ours, kMost * ours));
}

// The moves of the half's points as moves of the cage's control points.
std::vector<glm::dvec3> solve_moves(const HeadStock& stock, const std::vector<glm::dvec3>& moves) {
  const Cage& cage = stock.adult;
  const std::size_t half_count = moves.size();
  const std::vector<LinearRow> umbrellas = compute_umbrella_rows(cage);
  LeastSquares problem;
  for (std::uint32_t i = 0; i < cage.points.size(); ++i) {
    const std::uint32_t left = i < half_count ? i : cage.mirror[i];
    const bool is_hard = stock.data->half.points[left].is_hard;
    const glm::dvec3 move = moves[left] * glm::dvec3(left == i ? 1 : -1, 1, 1);
    problem.equations.push_back({is_hard ? LinearRow{{i, 1.0}} : compute_limit_row(*stock.surface, i),
                                 is_hard ? kHardWeight : 1, move});
  }
  const std::size_t place_count = problem.equations.size();
  for (std::uint32_t i = 0; i < cage.points.size(); ++i)
    problem.equations.push_back({umbrellas[i], kDisplacementFairness, glm::dvec3(0)});

  // Each round asks again for what the fairness has kept back (iterated Tikhonov regularisation).
  std::vector<glm::dvec3> sum(cage.points.size(), glm::dvec3(0));
  for (int round = 0; round <= kRefinements; ++round) {
    const std::vector<glm::dvec3> more = solve_least_squares(problem, cage.points.size());
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += more[i];
    for (std::size_t i = 0; i < place_count; ++i)
      problem.equations[i].target -= sample_row(problem.equations[i].row, more);
  }
  return sum;
}

HeadForm build_moved(const HeadStock& stock, const Polygons& mesh) {
  const std::vector<glm::dvec3> places = compute_half_places(stock, stock.adult.points);
  std::vector<glm::dvec3> moves(places.size());
  bool is_moved = false;
  for (std::size_t i = 0; i < places.size(); ++i) {
    glm::dvec3 place = mesh.positions[i];
    if (stock.adult.mirror[i] == i) {
      if (std::abs(place.x) >= kMiddle_mm)
        fail_at_point(mesh, i,
                      fmt::format("point {} ({}) of the mid-plane is at x = {:.4g}; expected x = 0, to {} mm",
                                  i + 1, stock.adult.names[i], place.x, kMiddle_mm));
      place.x = 0;
    }
    moves[i] = place - places[i];
    is_moved = is_moved || moves[i] != glm::dvec3(0);
  }
  HeadForm form{stock.adult.points, Eye{}};
  if (!is_moved) return form;
  const std::vector<glm::dvec3> solved = solve_moves(stock, moves);
  for (std::size_t i = 0; i < form.points.size(); ++i) form.points[i] += solved[i];
  mirror_half(stock.adult, form.points);
  fit_eye(stock, stock.adult.points, form);
  return form;
}

}  // namespace

std::vector<glm::dvec3> compute_half_places(const HeadStock& stock, const std::vector<glm::dvec3>& points) {
  std::vector<glm::dvec3> places;
  for (std::size_t i = 0; i < stock.data->half.points.size(); ++i) {
    const bool is_hard = stock.data->half.points[i].is_hard;
    glm::dvec3 place = is_hard ? points[i] : sample_row(compute_limit_row(*stock.surface, i), points);
    for (int axis = 0; axis < 3; ++axis) place[axis] = std::round(place[axis] * kDecimals) / kDecimals;
    if (stock.adult.mirror[i] == i) place.x = 0;
    places.push_back(place);
  }
  return places;
}

std::vector<Quad> compute_half_quads(const HeadStock& stock) {
  return {stock.adult.quads.begin(),
          stock.adult.quads.begin() + static_cast<std::ptrdiff_t>(stock.data->half.quads.size())};
}

Wrap build_own_half(const HeadStock& stock, const std::filesystem::path& file) {
  Polygons mesh = load_polygons(file, find_landmark_file(file) ? Faces::optional : Faces::needed);
  if (!has_our_faces(stock, mesh)) {
    if (find_landmark_file(file)) return wrap_scan(stock, load_scan_files(stock, file, true));
    fail_at_point(
        mesh, mesh.positions.size(),
        fmt::format("{} points and {} faces are not those of the shipped half ({} and {}); expected "
                    "templates/head/half.obj with its points moved, or landmarks in '{}' beside it",
                    mesh.positions.size(), mesh.face_count(), stock.data->half.points.size(),
                    stock.data->half.quads.size(),
                    std::filesystem::path(file).replace_extension(".yaml").filename().string()));
  }
  check_size(stock, mesh);
  put_on_left(mesh);
  return {build_moved(stock, mesh), {}, {}, {}};
}

}  // namespace mien

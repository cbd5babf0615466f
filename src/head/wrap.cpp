// Landmarks first, the surface then: a similarity by landmarks (Umeyama 1991), then closest points with less
// and less stiffness, as in Amberg, Romdhani, Vetter, "Optimal step nonrigid ICP algorithms for surface
// registration" (2007). The unknowns are the displacements of the half's control points, stiffness is the
// fairness of the displacement, and points are held to the planes of their closest points (Chen and Medioni
// 1992), so that the skin may slide until it is fair.
#include "head/wrap.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "head/eye_fit.hpp"
#include "head/half_system.hpp"
#include "head/nearest.hpp"
#include "head/own_half.hpp"
#include "head/scan_frame.hpp"
#include "head/surface.hpp"
#include "head/wrap_finish.hpp"

namespace mien {

namespace {

// One round of the fit.
struct Step {
  double stiffness;    // of the displacement against the closest points
  double landmark;     // weight of one landmark
  double reach_mm;     // closest points further off are no correspondences but holes
  double facing;       // least cosine between the skin's normal and the scan's
  std::size_t stride;  // every so many vertices are asked: the first, stiff steps need few
};

constexpr int kSteps = 16;
constexpr Step kFirst{200, 200, 40, 0.2, 5}, kLast{0.05, 4, 6, 0.6, 1};
constexpr double kSlide = 0.06;  // of a closest point itself against its plane: keeps the skin from drifting
// Edges keep their vectors, so that what nobody has seen does not fly off: of the stiffness, and at least.
constexpr double kCalm = 0.02, kLeastCalm = 0.1;
// The least stiffness where nothing is seen (mouth bag, nostrils, inner lids) and where scans are poor: ears
// and the thin rims of lids and lips keep the form they have and are only moved and bent.
constexpr double kHiddenStiffness = 2, kDelicateStiffness = 1;

// Places of our head that no scan shows.
bool is_hidden(std::string_view name) {
  for (const char* prefix : {"ni_", "nd_", "EB_", "E0_", "M0_", "MB", "er8_", "er9_", "er10_", "er11_"})
    if (has_prefix(name, prefix)) return true;
  return false;
}

double find_least_stiffness(std::string_view name) {
  if (is_hidden(name)) return kHiddenStiffness;
  for (const char* prefix : {"E1_", "M1_", "er"})
    if (has_prefix(name, prefix) && !has_prefix(name, "er1_")) return kDelicateStiffness;
  return 0;
}

struct Problem {
  const HeadStock* stock = nullptr;
  SurfaceTree tree;    // the scan, laid on the adult by its landmarks
  glm::dmat3 turn{1};  // what closest points make better of that: ours from the tree's
  glm::dvec3 shift{0};
  std::vector<std::uint32_t> vertices;         // of the skin's left half and middle, which a scan can show
  std::vector<HalfRow> samples;                // of each vertex
  std::vector<glm::dvec3> adult;               // where the adult has each
  std::vector<HalfRow> marks;                  // of each landmark, a left one for a right one
  std::vector<glm::dvec3> mark_from, mark_to;  // where the adult and where the tree has it
  std::vector<double> mark_weights;
  std::vector<HalfRow> bends, edges;    // fairness
  std::vector<double> least_stiffness;  // of each bend
  HalfSystem system;
};

glm::dvec3 mirror(const glm::dvec3& p) { return p * glm::dvec3(-1, 1, 1); }

// The share of hidden points in the vertex.
double find_hidden_share(const HeadStock& stock, std::size_t v) {
  double share = 0;
  for (const auto& [point, weight] : find_limit_row(*stock.surface, v))
    if (is_hidden(stock.adult.names[point])) share += weight;
  return share;
}

void choose_samples(Problem& problem) {
  const HeadStock& stock = *problem.stock;
  const Surface& surface = *stock.surface;
  constexpr double kMostHidden = 0.3;  // beyond, the skin turns inward
  for (std::uint32_t v = 0; v < surface.vertex_count(); ++v) {
    if (surface.mirror[v] < v || find_hidden_share(stock, v) > kMostHidden) continue;
    problem.vertices.push_back(v);
    problem.samples.push_back(build_half_row(stock.adult, find_limit_row(surface, v)));
    problem.adult.push_back(sample_row(find_limit_row(surface, v), stock.adult.points));
  }
}

void choose_fairness(Problem& problem) {
  const Cage& cage = problem.stock->adult;
  const std::vector<LinearRow> umbrellas = find_umbrella_rows(cage);
  for (std::uint32_t i = 0; i < problem.stock->half.points.size(); ++i) {
    problem.bends.push_back(build_half_row(cage, umbrellas[i]));
    problem.least_stiffness.push_back(find_least_stiffness(cage.names[i]));
  }
  for (const Quad& quad : find_half_quads(*problem.stock))
    for (int i = 0; i < 4; ++i)
      problem.edges.push_back(build_half_row(cage, {{quad[i], 1.0}, {quad[(i + 1) % 4], -1.0}}));
}

void choose_marks(Problem& problem, const Scan& scan, const Similarity& ours_from_scan) {
  const HeadStock& stock = *problem.stock;
  for (const ScanMark& mark : scan.marks) {
    problem.marks.push_back(build_half_row(stock.adult, mark.place));
    problem.mark_from.push_back(sample_row(mark.place, stock.adult.points));
    problem.mark_to.push_back(apply_similarity(ours_from_scan, mark.at));
    problem.mark_weights.push_back(mark.weight);
  }
}

Step find_step(int index) {
  const double way = static_cast<double>(index) / (kSteps - 1);
  const auto between = [&](double a, double b) { return a * std::pow(b / a, way); };
  return {between(kFirst.stiffness, kLast.stiffness), between(kFirst.landmark, kLast.landmark),
          between(kFirst.reach_mm, kLast.reach_mm), glm::mix(kFirst.facing, kLast.facing, way),
          way < 0.6 ? kFirst.stride : kLast.stride};
}

// Closest points of the vertices, on one side; all of the right side mirrored.
struct Matches {
  std::vector<bool> is_found;
  std::vector<glm::dvec3> points, normals;
};

struct Skin {
  std::vector<glm::vec3> positions, normals;
};

Matches find_matches(const Problem& problem, const Step& step, bool is_right, const Skin& skin) {
  const std::size_t count = problem.vertices.size();
  std::vector<NearestPlace> places(count);
  constexpr std::size_t kChunk = 250;
  const auto in_tree = [&](const glm::dvec3& p) {
    return glm::transpose(problem.turn) * (p - problem.shift);
  };
  for_each_index((count + kChunk - 1) / kChunk, count_cores(), [&](std::size_t chunk, int) {
    for (std::size_t i = chunk * kChunk; i < std::min(count, (chunk + 1) * kChunk); ++i) {
      if (i % step.stride != 0) continue;
      const glm::dvec3 at(skin.positions[problem.vertices[i]]);
      places[i] = find_nearest(problem.tree, in_tree(is_right ? mirror(at) : at), step.reach_mm);
    }
  });
  Matches matches{std::vector<bool>(count), std::vector<glm::dvec3>(count), std::vector<glm::dvec3>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    if (places[i].distance > step.reach_mm || places[i].is_rim) continue;
    const glm::dvec3 point = problem.turn * places[i].point + problem.shift,
                     normal = problem.turn * places[i].normal;
    matches.points[i] = is_right ? mirror(point) : point;
    matches.normals[i] = is_right ? mirror(normal) : normal;
    matches.is_found[i] =
        glm::dot(matches.normals[i], glm::dvec3(skin.normals[problem.vertices[i]])) >= step.facing;
  }
  return matches;
}

// Turns the scan so that its two halves lie alike on ours: landmarks are set by hand, the surface is sharper.
void turn_scan(Problem& problem, const Skin& skin, const std::array<Matches, 2>& sides) {
  std::vector<glm::dvec3> from, to;
  for (const int side : {0, 1})
    for (std::size_t i = 0; i < problem.vertices.size(); ++i) {
      if (!sides[0].is_found[i] || !sides[1].is_found[i]) continue;  // one side alone would pull
      const glm::dvec3 at(skin.positions[problem.vertices[i]]);
      from.push_back(side == 1 ? mirror(sides[side].points[i]) : sides[side].points[i]);
      to.push_back(side == 1 ? mirror(at) : at);
    }
  if (from.size() < 100) return;  // of some thousands: nothing to go by
  const Similarity better = fit_similarity(from, to);
  glm::dvec3 from_mean(0), to_mean(0);
  for (const glm::dvec3& p : from) from_mean += p / static_cast<double>(from.size());
  for (const glm::dvec3& p : to) to_mean += p / static_cast<double>(to.size());
  problem.turn = better.rotation * problem.turn;
  problem.shift = better.rotation * (problem.shift - from_mean) + to_mean;
}

Skin build_skin(const Surface& surface, const std::vector<glm::dvec3>& points) {
  std::vector<Float4> packed;
  Skin skin;
  pack_points(points, packed);
  deform_surface(surface, packed, skin.positions);
  update_surface_normals(surface, skin.positions, skin.normals);
  return skin;
}

// Some programs wind their faces the other way round: turns the scan's normals outward as ours are. Throws
// InputError if hardly anything of the head lies near the scan.
void orient_scan(const Scan& scan, Problem& problem, const HeadForm& form) {
  Step step = kFirst;
  step.facing = -1;  // all
  const Skin skin = build_skin(*problem.stock->surface, form.points);
  const Matches matches = find_matches(problem, step, false, skin);
  std::size_t near = 0, outward = 0;
  for (std::size_t i = 0; i < problem.vertices.size(); ++i) {
    if (!matches.is_found[i]) continue;
    ++near;
    outward += glm::dot(matches.normals[i], glm::dvec3(skin.normals[problem.vertices[i]])) > 0;
  }
  const std::size_t asked = problem.vertices.size() / step.stride;
  constexpr std::size_t kLeastShare = 10;  // percent; a face alone is 35
  if (near * 100 < kLeastShare * asked)
    throw InputError(std::vector<Diagnostic>{
        {{scan.mesh.file, 0, 0},
         fmt::format("only {} of 100 places of a head have a surface near them; expected a face at least",
                     near * 100 / asked),
         "",
         false}});
  if (2 * outward < near)
    for (glm::dvec3& normal : problem.tree.normals) normal = -normal;
}

void add_fairness(Problem& problem, double stiffness) {
  for (std::size_t i = 0; i < problem.bends.size(); ++i) {
    add_equation(problem.system, problem.bends[i], glm::dvec3(0), glm::dvec3(0), 0,
                 std::max(stiffness, problem.least_stiffness[i]));
  }
  for (const HalfRow& edge : problem.edges)
    add_equation(problem.system, edge, glm::dvec3(0), glm::dvec3(0), 0,
                 std::max(kCalm * stiffness, kLeastCalm));
}

void apply_moves(const Problem& problem, const std::vector<glm::dvec3>& moves, HeadForm& form) {
  form.points = problem.stock->adult.points;
  for (std::size_t i = 0; i < moves.size(); ++i) form.points[i] += moves[i];
  mirror_half(problem.stock->adult, form.points);
}

void add_surface(Problem& problem, const Step& step, const HeadForm& form) {
  const Skin skin = build_skin(*problem.stock->surface, form.points);
  std::array<Matches, 2> sides{find_matches(problem, step, false, skin),
                               find_matches(problem, step, true, skin)};
  if (step.stride > 1) {
    turn_scan(problem, skin, sides);
    sides = {find_matches(problem, step, false, skin), find_matches(problem, step, true, skin)};
  }
  const auto weight = static_cast<double>(step.stride);
  for (const Matches& matches : sides)
    for (std::size_t i = 0; i < problem.vertices.size(); ++i)
      if (matches.is_found[i])
        add_equation(problem.system, problem.samples[i], matches.points[i] - problem.adult[i],
                     matches.normals[i], weight, weight * kSlide);
}

void fit_step(Problem& problem, const Step& step, bool has_surface, HeadForm& form) {
  clear_equations(problem.system);
  add_fairness(problem, step.stiffness);
  for (std::size_t i = 0; i < problem.marks.size(); ++i)
    add_equation(problem.system, problem.marks[i],
                 problem.turn * problem.mark_to[i] + problem.shift - problem.mark_from[i], glm::dvec3(0), 0,
                 step.landmark * problem.mark_weights[i]);
  if (has_surface) add_surface(problem, step, form);
  apply_moves(problem, solve_equations(problem.system), form);
}

}  // namespace

HeadForm wrap_head(const HeadStock& stock, const Scan& scan) {
  const Similarity ours_from_scan = align_marks(stock, scan);
  const double growth = find_growth(scan, ours_from_scan.scale);
  Polygons mesh = scan.mesh;
  for (glm::dvec3& p : mesh.positions) p = apply_similarity(ours_from_scan, p);
  Problem problem;
  problem.stock = &stock;
  problem.tree = build_surface_tree(mesh);
  choose_samples(problem);
  choose_fairness(problem);
  choose_marks(problem, scan, ours_from_scan);
  problem.system = build_half_system(stock.adult, stock.half.points.size(),
                                     {&problem.samples, &problem.marks, &problem.bends, &problem.edges});
  HeadForm form{stock.adult.points, Eye{}};
  fit_step(problem, find_step(0), false, form);
  orient_scan(scan, problem, form);
  for (int i = 0; i < kSteps; ++i) fit_step(problem, find_step(i), true, form);
  finish_wrap(stock, growth, form);
  return form;
}

}  // namespace mien

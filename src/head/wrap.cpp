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
#include "core/pool.hpp"
#include "core/signals.hpp"
#include "head/eye_fit.hpp"
#include "head/half_system.hpp"
#include "head/own_half.hpp"
#include "head/placed_scan.hpp"
#include "head/scan_ear.hpp"
#include "head/scan_frame.hpp"
#include "head/scan_nose.hpp"
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

constexpr int kSteps = 22;
constexpr Step kFirst{200, 200, 40, 0.2, 5}, kLast{0.05, 4, 6, 0.6, 1};
constexpr double kSlide = 0.035;  // of a closest point itself against its plane: keeps the skin from drifting
// Edges keep their vectors, so that what nobody has seen does not fly off: of the stiffness, and at least.
constexpr double kCalm = 0.02, kLeastCalm = 0.1;
// The least stiffness where nothing is seen (mouth bag, nostrils, inner lids) and where scans are poor: ears
// and the thin rims of lids and lips keep the form they have and are only moved and bent.
constexpr double kHiddenStiffness = 2, kDelicateStiffness = 1, kEarStiffness = 1;
// The step before which the ears are looked for: the head lies on the scan to some millimetres then.
constexpr int kEarStep = 6;
constexpr double kEarMark = 0.02;  // weight of a landmark on the ear, of another one's
constexpr int kInnermostRing = 7;  // of the ear; what lies further in is the hollow before the canal
constexpr double kEarHold = 2,
                 kRootHold = 1;  // of its points to where it is carried: more would keep it stiff
// The scan's nose looks for ours from this step on, and so far.
constexpr int kNoseStep = 3;
constexpr double kNoseReach_mm = 10;

// Places of our head that no scan shows.
bool is_hidden(std::string_view name) {
  for (const char* prefix : {"na_", "nr_", "ni_", "nd_", "EB_", "E0_", "M0_", "MB"})
    if (has_prefix(name, prefix)) return true;
  return find_ear_ring(name) > kInnermostRing;
}

bool is_ear(std::string_view name) { return find_ear_ring(name) > 1; }  // its root belongs to the side

double compute_least_stiffness(std::string_view name) {
  if (is_ear(name)) return kEarStiffness;
  if (is_hidden(name)) return kHiddenStiffness;
  for (const char* prefix : {"E1_", "M1_"})
    if (has_prefix(name, prefix)) return kDelicateStiffness;
  return 0;
}

enum class Zone { skin, ear, nostril };

struct Problem {
  const HeadStock* stock = nullptr;
  PlacedScan scan;                             // laid on the adult by its landmarks, then by closest points
  std::vector<std::uint32_t> vertices;         // of the skin's left half and middle, which a scan can show
  std::vector<Zone> zones;                     // of each vertex
  std::vector<HalfRow> samples;                // of each vertex
  std::vector<glm::dvec3> adult;               // where the adult has each
  std::vector<HalfRow> marks;                  // of each landmark, a left one for a right one
  std::vector<glm::dvec3> mark_from, mark_to;  // where the adult and where the tree has it
  std::vector<double> mark_weights;
  std::vector<HalfRow> bends, edges;    // fairness
  std::vector<HalfRow> ear_points;      // each on its own
  std::vector<double> least_stiffness;  // of each bend
  EarFit ear;
  bool has_nose = false;         // the nose is near enough to be looked for
  std::vector<glm::dvec3> rest;  // of each point of the half: where the ear's fit carries it, from the adult
  HalfSystem system;
};

// The share of such points in the vertex.
template <typename Test>
double compute_share(const HeadStock& stock, std::size_t v, Test is_such) {
  double share = 0;
  for (const auto& [point, weight] : compute_limit_row(*stock.surface, v))
    if (is_such(stock.adult.names[point])) share += weight;
  return share;
}

Zone find_zone(const HeadStock& stock, std::size_t v) {
  constexpr double kLeastShare = 0.3, kLeastNostril = 0.02;
  if (compute_share(stock, v, is_ear) > kLeastShare) return Zone::ear;
  const auto is_nostril = [](std::string_view name) { return has_prefix(name, "na_"); };
  return compute_share(stock, v, is_nostril) > kLeastNostril ? Zone::nostril : Zone::skin;
}

void choose_samples(Problem& problem) {
  const HeadStock& stock = *problem.stock;
  const Surface& surface = *stock.surface;
  constexpr double kMostHidden = 0.3;  // beyond, the skin turns inward
  for (std::uint32_t v = 0; v < surface.vertex_count(); ++v) {
    if (surface.mirror[v] < v || compute_share(stock, v, is_hidden) > kMostHidden) continue;
    problem.vertices.push_back(v);
    problem.zones.push_back(find_zone(stock, v));
    problem.samples.push_back(build_half_row(stock.adult, compute_limit_row(surface, v)));
    problem.adult.push_back(sample_row(compute_limit_row(surface, v), stock.adult.points));
  }
}

void choose_fairness(Problem& problem) {
  const Cage& cage = problem.stock->adult;
  const std::vector<LinearRow> umbrellas = compute_umbrella_rows(cage);
  for (std::uint32_t i = 0; i < problem.stock->data->half.points.size(); ++i) {
    problem.bends.push_back(build_half_row(cage, umbrellas[i]));
    problem.least_stiffness.push_back(compute_least_stiffness(cage.names[i]));
  }
  for (std::uint32_t i = 0; i < problem.stock->data->half.points.size(); ++i)
    if (find_ear_ring(cage.names[i]) > 0) problem.ear_points.push_back(build_half_row(cage, {{i, 1.0}}));
  for (const Quad& quad : compute_half_quads(*problem.stock))
    for (int i = 0; i < 4; ++i)
      problem.edges.push_back(build_half_row(cage, {{quad[i], 1.0}, {quad[(i + 1) % 4], -1.0}}));
}

void choose_marks(Problem& problem, const Scan& scan, const Similarity& ours_from_scan) {
  const HeadStock& stock = *problem.stock;
  for (const ScanMark& mark : scan.marks) {
    problem.marks.push_back(build_half_row(stock.adult, mark.place));
    problem.mark_from.push_back(sample_row(mark.place, stock.adult.points));
    problem.mark_to.push_back(apply_similarity(ours_from_scan, mark.at));
    const auto is_on_ear = [&](const auto& entry) { return is_ear(stock.adult.names[entry.first]); };
    problem.mark_weights.push_back(std::ranges::any_of(mark.place, is_on_ear) ? kEarMark * mark.weight
                                                                              : mark.weight);
  }
}

Step compute_step(int index) {
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

// Whether the vertex asks for a place at all.
bool is_asked(const Problem& problem, const Step& step, std::size_t i) {
  if (i % step.stride != 0 || problem.zones[i] == Zone::nostril) return false;
  return problem.zones[i] != Zone::ear || problem.ear.is_found;
}

Matches compute_matches(const Problem& problem, const Step& step, bool is_right, const Skin& skin) {
  const std::size_t count = problem.vertices.size();
  // Not bools: threads write side by side.
  std::vector<char> is_found(count, 0);
  Matches matches{{}, std::vector<glm::dvec3>(count), std::vector<glm::dvec3>(count)};
  constexpr std::size_t kChunk = 250;
  for_each_index((count + kChunk - 1) / kChunk, count_workers(), [&](std::size_t chunk, int) {
    for (std::size_t i = chunk * kChunk; i < std::min(count, (chunk + 1) * kChunk); ++i) {
      if (!is_asked(problem, step, i)) continue;
      const glm::dvec3 at(skin.positions[problem.vertices[i]]), normal(skin.normals[problem.vertices[i]]);
      const NearestPlace place = find_place(problem.scan, at, step.reach_mm, is_right);
      matches.points[i] = place.point;
      matches.normals[i] = place.normal;
      is_found[i] =
          place.distance <= step.reach_mm && !place.is_rim && glm::dot(place.normal, normal) >= step.facing;
    }
  });
  matches.is_found.assign(is_found.begin(), is_found.end());
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
  problem.scan.turn = better.rotation * problem.scan.turn;
  problem.scan.shift = better.rotation * (problem.scan.shift - from_mean) + to_mean;
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
  const Matches matches = compute_matches(problem, step, false, skin);
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
    for (glm::dvec3& normal : problem.scan.tree.normals) normal = -normal;
}

// Where the row goes with the ear that was found; nowhere unless all of its points are the ear's.
glm::dvec3 compute_rest(const Problem& problem, const HalfRow& row) {
  glm::dvec3 sum(0);
  for (const HalfTerm& term : row.terms) {
    if (find_ear_ring(problem.stock->adult.names[term.point]) == 0) return glm::dvec3(0);
    sum += glm::dvec3(term.x, term.yz, term.yz) * problem.rest[term.point];
  }
  return sum;
}

void add_fairness(Problem& problem, double stiffness) {
  for (std::size_t i = 0; i < problem.bends.size(); ++i)
    add_equation(problem.system, problem.bends[i], compute_rest(problem, problem.bends[i]), glm::dvec3(0), 0,
                 std::max(stiffness, problem.least_stiffness[i]));
  for (const HalfRow& point : problem.ear_points)
    if (problem.ear.is_found)
      add_equation(problem.system, point, compute_rest(problem, point), glm::dvec3(0), 0,
                   is_ear(problem.stock->adult.names[point.terms[0].point]) ? kEarHold : kRootHold);
  for (const HalfRow& edge : problem.edges)
    add_equation(problem.system, edge, compute_rest(problem, edge), glm::dvec3(0), 0,
                 std::max(kCalm * stiffness, kLeastCalm));
}

// Looks for the scan's ears; from now on ours are stiff about where they are to be carried.
void place_ears(Problem& problem, const HeadForm& form) {
  const Cage& cage = problem.stock->adult;
  problem.ear = find_ear(*problem.stock, problem.scan, form.points);
  const Similarity carried =
      problem.ear.is_found ? problem.ear.carried : carry_ear_by_root(cage, form.points);
  for (std::size_t i = 0; i < problem.rest.size(); ++i)
    problem.rest[i] = apply_similarity(carried, cage.points[i]) - cage.points[i];
}

void apply_moves(const Problem& problem, const std::vector<glm::dvec3>& moves, HeadForm& form) {
  form.points = problem.stock->adult.points;
  for (std::size_t i = 0; i < moves.size(); ++i) form.points[i] += moves[i];
  mirror_half(problem.stock->adult, form.points);
}

// Where the nose is, and how far it reaches.
struct NosePlace {
  glm::dvec3 middle{0};
  double radius_mm = 0;
};

NosePlace compute_nose(const Cage& cage, const std::vector<glm::dvec3>& points) {
  const glm::dvec3 tip = points[find_point(cage, "p_tip")], wing = points[find_point(cage, "k_tip")],
                   base = points[find_point(cage, "M6_0")];
  constexpr double kRadius = 0.9;  // of the way from tip to wing: more would reach lids and lips
  return {(tip + base + 2.0 * wing) / 4.0, kRadius * glm::distance(tip, wing)};
}

void add_nose(Problem& problem, const Step& step, const HeadForm& form, const Skin& skin) {
  const NosePlace nose = compute_nose(problem.stock->adult, form.points);
  NosePatch patch;
  std::vector<std::size_t> samples;  // of each vertex of the patch
  for (std::size_t i = 0; i < problem.vertices.size(); ++i) {
    const glm::dvec3 at(skin.positions[problem.vertices[i]]);
    if (glm::distance(at, nose.middle) > nose.radius_mm) continue;
    patch.points.push_back(at);
    patch.normals.emplace_back(skin.normals[problem.vertices[i]]);
    samples.push_back(i);
  }
  const std::vector<NosePull> pulls = compute_nose_pulls(problem.scan, patch, nose.middle, nose.radius_mm,
                                                         std::min(step.reach_mm, kNoseReach_mm));
  if (pulls.empty()) return;
  // A dense scan is not to count for more than our own skin.
  const double weight = static_cast<double>(samples.size()) / static_cast<double>(pulls.size());
  for (const NosePull& pull : pulls) {
    const std::size_t sample = samples[pull.vertex];
    if (problem.zones[sample] == Zone::nostril) continue;  // the rim keeps its own form
    add_equation(problem.system, problem.samples[sample], pull.at - problem.adult[sample], pull.normal,
                 weight, weight * kSlide);
  }
}

void add_surface(Problem& problem, const Step& step, const HeadForm& form) {
  const Skin skin = build_skin(*problem.stock->surface, form.points);
  std::array<Matches, 2> sides{compute_matches(problem, step, false, skin),
                               compute_matches(problem, step, true, skin)};
  if (step.stride > 1) {
    turn_scan(problem, skin, sides);
    sides = {compute_matches(problem, step, false, skin), compute_matches(problem, step, true, skin)};
  }
  const auto weight = static_cast<double>(step.stride);
  for (const Matches& matches : sides)
    for (std::size_t i = 0; i < problem.vertices.size(); ++i)
      if (matches.is_found[i])
        add_equation(problem.system, problem.samples[i], matches.points[i] - problem.adult[i],
                     matches.normals[i], weight, weight * kSlide);
  if (problem.has_nose) add_nose(problem, step, form, skin);
}

void fit_step(Problem& problem, const Step& step, bool has_surface, HeadForm& form) {
  throw_if_interrupted();
  clear_equations(problem.system);
  add_fairness(problem, step.stiffness);
  for (std::size_t i = 0; i < problem.marks.size(); ++i)
    add_equation(problem.system, problem.marks[i],
                 problem.scan.turn * problem.mark_to[i] + problem.scan.shift - problem.mark_from[i],
                 glm::dvec3(0), 0, step.landmark * problem.mark_weights[i]);
  if (has_surface) add_surface(problem, step, form);
  apply_moves(problem, solve_equations(problem.system), form);
}

// Faces that reach far from the head: no step asks for them, and their boxes would hold everything.
void leave_out_far(Polygons& mesh) {
  constexpr double kFar_mm = 1000;
  const auto is_far = [&](std::uint32_t corner) { return glm::length(mesh.positions[corner]) > kFar_mm; };
  std::vector<std::uint32_t> corners, first{0};
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto begin = mesh.corners.begin() + mesh.first[f], end = mesh.corners.begin() + mesh.first[f + 1];
    if (std::any_of(begin, end, is_far)) continue;
    corners.insert(corners.end(), begin, end);
    first.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  mesh.corners = std::move(corners);
  mesh.first = std::move(first);
  for (glm::dvec3& p : mesh.positions)
    if (glm::length(p) > kFar_mm) p = glm::dvec3(0);  // nobody's now
}

// Triangles that join points from all over the head make no surface, and would be looked at from everywhere.
// Throws InputError if all together are too long.
void check_triangles(const HeadStock& stock, const Polygons& mesh) {
  constexpr double kMost = 20;        // a scan with hair and an inside comes to 5, one of slivers to 10
  constexpr double kAround_mm = 250;  // what lies further off, such as a body, may be as large as it is
  const auto compute_square = [](const glm::dvec3& a, const glm::dvec3& b) { return glm::dot(a - b, a - b); };
  std::vector<Float4> packed;
  std::vector<glm::vec3> skin;
  pack_points(stock.adult.points, packed);
  deform_surface(*stock.surface, packed, skin);
  double head = 0, scan = 0;
  for (const Quad& q : stock.surface->quads)
    head += 2 * compute_square(glm::dvec3(skin[q[0]]), glm::dvec3(skin[q[2]]));
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    for (std::uint32_t i = mesh.first[f] + 2; i < mesh.first[f + 1]; ++i) {
      const glm::dvec3 &a = mesh.positions[mesh.corners[mesh.first[f]]],
                       &b = mesh.positions[mesh.corners[i - 1]], &c = mesh.positions[mesh.corners[i]];
      if (glm::length(a + b + c) < 3 * kAround_mm)
        scan += std::max({compute_square(a, b), compute_square(b, c), compute_square(c, a)});
    }
  if (scan > kMost * head)
    throw InputError(std::vector<Diagnostic>{
        {{mesh.file, 0, 0},
         fmt::format(
             "its triangles are so long that they would cover a head {:.0f} times; expected {} times at "
             "most: they make no surface",
             scan / head, kMost),
         "",
         false}});
}

// Lays the scan on the adult; the equations are those of the adult's half.
Problem build_problem(const HeadStock& stock, const Scan& scan, const Similarity& ours_from_scan) {
  Polygons mesh = scan.mesh;
  for (glm::dvec3& p : mesh.positions) p = apply_similarity(ours_from_scan, p);
  leave_out_far(mesh);
  check_triangles(stock, mesh);
  Problem problem;
  problem.stock = &stock;
  problem.scan.tree = build_surface_tree(mesh);
  if (!scan.rims.empty()) problem.scan.tree.is_rim = scan.rims;
  problem.rest.assign(stock.data->half.points.size(), glm::dvec3(0));
  choose_samples(problem);
  choose_fairness(problem);
  choose_marks(problem, scan, ours_from_scan);
  problem.system = build_half_system(
      stock.adult, stock.data->half.points.size(),
      {&problem.samples, &problem.marks, &problem.bends, &problem.edges, &problem.ear_points});
  return problem;
}

// The first steps, until the ears have been looked for.
HeadForm begin_fit(Problem& problem, const Scan& scan) {
  HeadForm form{problem.stock->adult.points, Eye{}};
  fit_step(problem, compute_step(0), false, form);
  orient_scan(scan, problem, form);
  for (int i = 0; i < kEarStep; ++i) {
    problem.has_nose = i >= kNoseStep;
    fit_step(problem, compute_step(i), true, form);
  }
  place_ears(problem, form);
  return form;
}

// Throws InputError if the scan is no face.
void judge(const Problem& problem, const Scan& scan, Wrap& wrap) {
  const Skin skin = build_skin(*problem.stock->surface, wrap.form.points);
  std::vector<std::uint32_t> plain;
  for (std::size_t i = 0; i < problem.vertices.size(); ++i)
    if (problem.zones[i] == Zone::skin) plain.push_back(problem.vertices[i]);
  std::vector<glm::dvec3> marks;
  for (const glm::dvec3& p : problem.mark_to) marks.push_back(problem.scan.turn * p + problem.scan.shift);
  wrap.worth = measure_wrap(
      {*problem.stock, scan, problem.scan, plain, skin.positions, skin.normals, wrap.form.points, marks});
  std::vector<Diagnostic> told = judge_wrap(scan, wrap.worth);
  if (!told.empty() && !told.front().is_warning) throw InputError(std::move(told));
  wrap.warnings.insert(wrap.warnings.end(), told.begin(), told.end());
}

}  // namespace

Wrap wrap_scan(const HeadStock& stock, const Scan& scan) {
  const Similarity ours_from_scan = align_marks(stock, scan);
  const double growth = compute_growth(scan, ours_from_scan.scale);
  Problem problem = build_problem(stock, scan, ours_from_scan);
  Wrap wrap;
  wrap.form = begin_fit(problem, scan);
  for (int i = kEarStep; i < kSteps; ++i) fit_step(problem, compute_step(i), true, wrap.form);
  if (!problem.ear.is_found) wrap.kept.emplace_back("ears");
  wrap.warnings = scan.warnings;
  for (Diagnostic& warning : judge_growth(scan, growth)) wrap.warnings.push_back(std::move(warning));
  judge(problem, scan, wrap);
  finish_wrap(stock, growth, wrap.form);
  return wrap;
}

}  // namespace mien

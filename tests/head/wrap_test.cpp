// Scans made of heads that are known: what comes back is compared with what went in.
#include "head/wrap.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <random>

#include "core/data.hpp"
#include "core/error.hpp"
#include "head/eye_fit.hpp"
#include "head/landmarks.hpp"
#include "head/nearest.hpp"
#include "head/scan_ear.hpp"
#include "head/surface.hpp"
#include "shipped.hpp"

namespace mien {
namespace {

const HeadStock& stock() {
  static const HeadStock stock = shipped().heads;
  return stock;
}

// A vertex of the skin that leans on points with one of these beginnings.
bool is_of(std::size_t v, const std::vector<const char*>& prefixes) {
  double share = 0;
  for (const auto& [point, weight] : compute_limit_row(*stock().surface, v))
    for (const char* prefix : prefixes)
      if (has_prefix(stock().adult.names[point], prefix)) share += weight;
  return share > 0.02;
}

// Hidden, or of a form that is kept: nostrils and ears.
bool is_unseen(std::size_t v) {
  return is_of(v, {"na_", "nr_", "ni_", "nd_", "EB_", "E0_", "M0_", "MB", "er"});
}

struct ScanMaking {
  double noise_mm = 0;  // of the landmarks
  double unit_mm = 1;   // of the mesh
  bool is_unit_told = false;
  double neck_mm = -1e9;  // below, nothing was seen
  int holes = 0;          // round ones of 16 mm in the cheek, skull and brow
  glm::dvec3 turn_deg{20, -60, 35};
  double cell_mm = 0;        // vertices are gathered to one in each such cell: a coarse mesh
  double least_z_mm = -1e9;  // behind, nothing was seen
  double least_x_mm = -1e9;  // and further to the right
  double rough_mm = 0;       // noise of the surface
  bool has_ears = true;      // else there are holes
};

constexpr std::array kHoles{glm::vec3(45, -45, 75), glm::vec3(-60, 60, 20), glm::vec3(20, 40, 95),
                            glm::vec3(0, 20, -90)};

// One vertex for all in a cell of a grid, at their mean: another program's coarse mesh.
void gather_points(Polygons& mesh, double cell_mm) {
  std::map<std::array<int, 3>, std::vector<std::uint32_t>> cells;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::dvec3 p = glm::floor(mesh.positions[v] / cell_mm);
    cells[{int(p.x), int(p.y), int(p.z)}].push_back(v);
  }
  std::vector<glm::dvec3> positions;
  std::vector<std::uint32_t> image(mesh.positions.size());
  for (const auto& [cell, members] : cells) {
    glm::dvec3 sum(0);
    for (const std::uint32_t v : members) {
      sum += mesh.positions[v];
      image[v] = static_cast<std::uint32_t>(positions.size());
    }
    positions.push_back(sum / static_cast<double>(members.size()));
  }
  mesh.positions = positions;
  for (std::uint32_t& corner : mesh.corners) corner = image[corner];
}

Polygons build_scan_mesh(const NeutralHead& head, const ScanMaking& making) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> share(0, 0.35f);
  Polygons mesh;
  const auto& skin = head.skin.positions;
  std::vector<std::vector<std::uint32_t>> around(skin.size());
  for (const Quad& q : head.surface->quads)
    for (int i = 0; i < 4; ++i) around[q[i]].push_back(q[(i + 1) % 4]);
  // Other vertices and other diagonals than ours, on the same surface.
  for (std::size_t v = 0; v < skin.size(); ++v) {
    const glm::vec3 other = around[v].empty() ? skin[v] : skin[around[v][random() % around[v].size()]];
    mesh.positions.emplace_back(glm::mix(skin[v], other, share(random)));
  }
  for (const auto& [a, b, c, d] : head.surface->quads) {
    const glm::dvec3 at = mesh.positions[a];
    if (!making.has_ears && is_of(a, {"er"})) continue;
    bool is_seen = at.y > making.neck_mm && at.z > making.least_z_mm && at.x > making.least_x_mm;
    for (int h = 0; h < making.holes; ++h)
      is_seen = is_seen && glm::distance(at, glm::dvec3(kHoles[static_cast<std::size_t>(h)])) > 16;
    if (!is_seen) continue;
    for (const std::uint32_t v : random() % 2 ? std::array{a, b, c, a, c, d} : std::array{b, c, d, b, d, a})
      mesh.corners.push_back(v);
    mesh.first.push_back(mesh.first.back() + 3);
    mesh.first.push_back(mesh.first.back() + 3);
  }
  std::normal_distribution<double> rough(0, 1);
  for (glm::dvec3& p : mesh.positions)
    p += making.rough_mm * glm::dvec3(rough(random), rough(random), rough(random));
  if (making.cell_mm > 0) gather_points(mesh, making.cell_mm);
  return mesh;
}

// The scan of a head somewhere in space, its landmarks as a person would set them.
Scan build_scan(const NeutralHead& head, const ScanMaking& making) {
  Scan scan;
  scan.mesh = build_scan_mesh(head, making);
  scan.unit_mm = making.is_unit_told ? making.unit_mm : 0;
  std::mt19937 random(8);
  std::normal_distribution<double> noise(0, making.noise_mm > 0 ? making.noise_mm : 1);
  const NeutralHead adult = build_bare_head(stock(), stock().adult.points);
  for (const char* name : {"n", "prn", "sn", "gn", "en", "ex", "ch", "t"}) {
    const SkinSpot spot = find_place(adult, name);
    LinearRow place = compute_mean_row(*stock().surface, spot.vertices, spot.shares);
    const bool is_middle = std::abs(sample_row(place, stock().adult.points).x) < 0.01;
    for (int side = 0; side < (is_middle ? 1 : 2); ++side) {
      if (side == 1)
        for (auto& entry : place) entry.first = stock().adult.mirror[entry.first];
      glm::dvec3 at = sample_row(place, head.cage.points);
      if (making.noise_mm > 0) at += glm::dvec3(noise(random), noise(random), noise(random));
      scan.marks.push_back({name, at, place, 1});
    }
  }
  glm::dmat4 world = glm::translate(glm::dmat4(1), glm::dvec3(300, -200, 1000));
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 about(0);
    about[axis] = 1;
    world = glm::rotate(world, glm::radians(making.turn_deg[axis]), about);
  }
  const auto move = [&](glm::dvec3& p) { p = glm::dvec3(world * glm::dvec4(p, 1)) / making.unit_mm; };
  for (glm::dvec3& p : scan.mesh.positions) move(p);
  for (ScanMark& mark : scan.marks) move(mark.at);
  return scan;
}

struct Miss {
  double mean = 0, max = 0;
  glm::dvec3 where{0};
  std::size_t vertex = 0;
};

SurfaceTree build_skin_tree(const std::vector<glm::vec3>& skin) {
  Polygons mesh;
  mesh.positions.assign(skin.begin(), skin.end());
  for (const Quad& q : stock().surface->quads) {
    mesh.corners.insert(mesh.corners.end(), q.begin(), q.end());
    mesh.first.push_back(mesh.first.back() + 4);
  }
  return build_surface_tree(mesh);
}

// The similarity that lays `from` best on the skin, whatever points stand for what: closest points, a few
// times.
Similarity settle(Similarity similarity, const std::vector<glm::dvec3>& from,
                  const std::vector<glm::vec3>& skin) {
  const SurfaceTree tree = build_skin_tree(skin);
  for (int round = 0; round < 30; ++round) {
    std::vector<glm::dvec3> a, b;
    for (std::size_t i = 0; i < from.size(); i += 7) {
      const glm::dvec3 at = apply_similarity(similarity, from[i]);
      if (at.y < -90) continue;  // the neck may be made up
      a.push_back(from[i]);
      b.push_back(find_nearest(tree, at, 100).point);
    }
    similarity = fit_similarity(a, b);
  }
  return similarity;
}

// Distances from the vertices of `from` to the surface of `to`, what nobody sees and ears left out.
Miss measure(const std::vector<glm::vec3>& from, const std::vector<glm::vec3>& to, double lowest) {
  const SurfaceTree tree = build_skin_tree(to);
  Miss miss;
  int count = 0;
  for (std::size_t v = 0; v < from.size(); ++v) {
    if (is_unseen(v) || from[v].y < lowest) continue;
    const double distance = find_nearest(tree, glm::dvec3(from[v]), 100).distance;
    miss.mean += distance;
    ++count;
    if (distance > miss.max) miss.max = distance, miss.where = from[v], miss.vertex = v;
  }
  miss.mean /= count;
  return miss;
}

std::string name_nearest_point(std::size_t v) {
  double most = 0;
  std::string name;
  for (const auto& [point, weight] : compute_limit_row(*stock().surface, v))
    if (weight > most) most = weight, name = stock().adult.names[point];
  return name;
}

struct Outcome {
  Miss out, back;    // ours to the scan, the scan to ours
  double marks = 0;  // greatest miss of a landmark
  double ear = 0;    // and of one on the ear, which keeps its own form
  double seconds = 0;
  HeadForm form;
  WrapWorth worth;
  std::string warnings;
};

std::string describe_worth(const WrapWorth& worth) {
  return fmt::format(
      "covered {:.2f}, {:.2f} mm off, {:.3f} far off, {:.3f} agreeing, {:.3f} stray, {} folded, "
      "landmarks {:.1f} mm off",
      worth.covered, worth.rms_mm, worth.off, worth.agreeing, worth.stray_points, worth.folded,
      worth.mark_mm);
}

std::string join_warnings(const Wrap& wrap) {
  std::string text;
  for (const Diagnostic& warning : wrap.warnings) text += warning.message + "\n";
  return text;
}

Outcome wrap(const NeutralHead& head, const ScanMaking& making) {
  const Scan scan = build_scan(head, making);
  const auto begin = std::chrono::steady_clock::now();
  Outcome outcome;
  const Wrap result = wrap_scan(stock(), scan);
  outcome.form = result.form;
  outcome.worth = result.worth;
  outcome.warnings = join_warnings(result);
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  // Both in one frame: the same points stand for the same places.
  const NeutralHead wrapped = build_bare_head(stock(), outcome.form.points);
  std::vector<glm::dvec3> from, to;
  for (std::size_t v = 0; v < head.skin.positions.size(); ++v) {
    if (is_unseen(v)) continue;
    from.emplace_back(wrapped.skin.positions[v]);
    to.emplace_back(head.skin.positions[v]);
  }
  Similarity same = fit_similarity(from, to);
  same = settle(same, from, head.skin.positions);
  if (making.is_unit_told) {
    EXPECT_NEAR(same.scale, 1, 0.01);
  }
  std::vector<glm::vec3> ours;
  for (const glm::vec3& p : wrapped.skin.positions) ours.emplace_back(apply_similarity(same, glm::dvec3(p)));
  // The cut's own edge is nobody's to know.
  const double lowest = std::max(making.neck_mm, double(compute_bounds(head.skin.positions).low.y)) + 20;
  outcome.out = measure(ours, head.skin.positions, lowest);
  outcome.back = measure(head.skin.positions, ours, lowest);
  for (const ScanMark& mark : scan.marks) {
    double& most = mark.name == "t" ? outcome.ear : outcome.marks;
    most = std::max(most, glm::distance(sample_row(mark.place, head.cage.points),
                                        apply_similarity(same, sample_row(mark.place, outcome.form.points))));
  }
  return outcome;
}

struct Sitter {
  const char* name;
  HeadSpec spec;
  ScanMaking making;
};

// Heads far from ours and from each other, scanned badly in different ways.
std::vector<Sitter> list_sitters() {
  std::vector<Sitter> sitters(7);
  sitters[0] = {"adult", {}, {}};
  sitters[1] = {"square woman in metres", {}, {0, 1000, false, -140, 3}};
  sitters[1].spec.character = -1;
  sitters[1].spec.skull = {{"square", 1.0}};
  sitters[1].spec.features = {{"nose_length", 0.7}, {"mouth_width", -0.6}};
  sitters[2] = {"narrow man in inches", {}, {0, 25.4, true, -150, 2, {-70, 20, 0}}};
  sitters[2].spec.character = 1;
  sitters[2].spec.skull = {{"narrow", 1.0}};
  sitters[2].spec.features = {{"nose_bridge", 1}, {"chin_projection", 1}};
  sitters[3] = {"child in centimetres", {}, {0, 10, true, -100, 3, {30, 50, -45}}};
  sitters[3].spec.age = {{"child", 1.0}};
  sitters[4] = {"infant", {}, {0, 1, true, -1e9, 0, {30, 50, -45}}};
  sitters[4].spec.age = {{"infant", 1.0}};
  sitters[5] = {"landmarks 1.5 mm off", sitters[1].spec, {1.5, 1000, false, -140, 3}};
  sitters[6] = {
      "coarse and rough", sitters[2].spec, {1, 1000, false, -140, 3, {20, -60, 35}, 5, -1e9, -1e9, 0.4}};
  return sitters;
}

TEST(wrap, comes_back_with_the_shape_that_was_scanned) {
  for (const Sitter& sitter : list_sitters()) {
    const NeutralHead head = build_neutral_head(shipped().heads, sitter.spec);
    const Outcome outcome = wrap(head, sitter.making);
    const bool is_rough = sitter.making.rough_mm > 0, is_off = sitter.making.noise_mm > 0;
    for (const Miss& miss : {outcome.out, outcome.back}) {
      EXPECT_LT(miss.mean, is_rough ? 0.3 : 0.1) << sitter.name;
      EXPECT_LT(miss.max, is_rough ? 2.5
                          : is_off ? 1.2
                                   : 0.5)
          << sitter.name << " at " << name_nearest_point(miss.vertex);
    }
    EXPECT_LT(outcome.marks, is_off ? 3 * sitter.making.noise_mm : 1) << sitter.name;
    EXPECT_LT(outcome.ear, 3) << sitter.name;  // an ear keeps its own form: its notch is where that has it
    EXPECT_NEAR(outcome.form.eye.radius_mm / head.eye.radius_mm, 1, is_off ? 0.06 : 0.03) << sitter.name;
    EXPECT_EQ(std::abs(outcome.form.eye.centre.y), 0) << sitter.name;
    EXPECT_EQ(outcome.warnings, "") << sitter.name;
    RecordProperty(sitter.name,
                   fmt::format("mean {:.3f} max {:.2f} back {:.3f} {:.2f} in {:.1f} s; {}", outcome.out.mean,
                               outcome.out.max, outcome.back.mean, outcome.back.max, outcome.seconds,
                               describe_worth(outcome.worth)));
  }
}

// The skin's vertices of the left ear: its rim and what lies around it.
std::vector<std::size_t> list_ear() {
  std::vector<std::size_t> ear;
  for (std::size_t v = 0; v < stock().data->half.points.size(); ++v) {
    const int ring = find_ear_ring(stock().adult.names[v]);
    if (ring >= 3 && ring <= 7) ear.push_back(v);
  }
  return ear;
}

std::vector<glm::dvec3> pick(const std::vector<glm::vec3>& skin, const std::vector<std::size_t>& vertices) {
  std::vector<glm::dvec3> points;
  for (const std::size_t v : vertices) points.emplace_back(skin[v]);
  return points;
}

// How far `from` is from `to` in the mean, after the similarity that lays it there.
double find_mean_miss(const Similarity& similarity, const std::vector<glm::dvec3>& from,
                      const std::vector<glm::dvec3>& to) {
  double sum = 0;
  for (std::size_t i = 0; i < from.size(); ++i)
    sum += glm::distance(apply_similarity(similarity, from[i]), to[i]);
  return sum / static_cast<double>(from.size());
}

TEST(wrap, ears_take_place_size_and_angle_of_the_scans_and_keep_their_own_form) {
  HeadSpec spec;
  spec.features = {{"ear_size", -1}, {"ear_angle", 1}};
  const NeutralHead head = build_neutral_head(shipped().heads, spec);
  const auto ear = list_ear();
  const NeutralHead adult = build_bare_head(stock(), stock().adult.points);
  const std::vector<glm::dvec3> theirs = pick(head.skin.positions, ear),
                                own = pick(adult.skin.positions, ear);
  const Scan scan = build_scan(head, {});
  EXPECT_TRUE(wrap_scan(stock(), scan).kept.empty());
  const NeutralHead wrapped = build_bare_head(stock(), wrap_scan(stock(), scan).form.points);
  std::vector<glm::dvec3> from, to;
  for (std::size_t v = 0; v < head.skin.positions.size(); ++v) {
    if (is_unseen(v)) continue;
    from.emplace_back(wrapped.skin.positions[v]);
    to.emplace_back(head.skin.positions[v]);
  }
  const std::vector<glm::dvec3> ours = pick(wrapped.skin.positions, ear);
  EXPECT_GT(find_mean_miss({}, own, theirs), 2.5) << "there is something to be found";
  EXPECT_LT(find_mean_miss(fit_similarity(from, to), ours, theirs), 1);
  EXPECT_LT(find_mean_miss(fit_similarity(own, ours), own, ours), 0.5);
}

TEST(wrap, keeps_our_own_ears_where_a_scan_has_none_and_says_so) {
  ScanMaking making;
  making.has_ears = false;
  const NeutralHead head = build_neutral_head(shipped().heads, list_sitters()[1].spec);
  const Scan scan = build_scan(head, making);
  EXPECT_EQ(wrap_scan(stock(), scan).kept, std::vector<std::string>{"ears"});
  const NeutralHead wrapped = build_bare_head(stock(), wrap_scan(stock(), scan).form.points);
  const NeutralHead adult = build_bare_head(stock(), stock().adult.points);
  const auto own = pick(adult.skin.positions, list_ear()), ours = pick(wrapped.skin.positions, list_ear());
  EXPECT_LT(find_mean_miss(fit_similarity(own, ours), own, ours), 1);
}

TEST(wrap, nostrils_keep_their_form) {
  std::vector<std::size_t> rim;
  for (std::size_t v = 0; v < stock().data->half.points.size(); ++v)
    if (has_prefix(stock().adult.names[v], "na_") || has_prefix(stock().adult.names[v], "nr_"))
      rim.push_back(v);
  ASSERT_FALSE(rim.empty());
  const NeutralHead adult = build_bare_head(stock(), stock().adult.points);
  const auto own = pick(adult.skin.positions, rim);
  for (const Sitter& sitter : list_sitters()) {
    const NeutralHead head = build_neutral_head(shipped().heads, sitter.spec);
    const NeutralHead wrapped =
        build_bare_head(stock(), wrap_scan(stock(), build_scan(head, sitter.making)).form.points);
    const auto ours = pick(wrapped.skin.positions, rim);
    EXPECT_LT(find_mean_miss(fit_similarity(own, ours), own, ours), 1) << sitter.name;
  }
}

TEST(wrap, is_the_same_every_time_and_its_own_mirror_image) {
  const NeutralHead head = build_neutral_head(shipped().heads, HeadSpec{});
  const Scan scan = build_scan(head, {1, 1000, false, -140, 3});
  const HeadForm once = wrap_scan(stock(), scan).form, again = wrap_scan(stock(), scan).form;
  EXPECT_TRUE(once.points == again.points);
  for (std::size_t i = 0; i < once.points.size(); ++i)
    ASSERT_TRUE(once.points[stock().adult.mirror[i]] == once.points[i] * glm::dvec3(-1, 1, 1) ||
                stock().adult.mirror[i] == i);
}

// What wrap_scan says of the scan; empty if it wraps it.
std::string find_fault(const Scan& scan) {
  try {
    wrap_scan(stock(), scan);
  } catch (const InputError& e) {
    return e.diagnostics.at(0).message;
  }
  return "";
}

TEST(wrap, a_face_alone_or_wound_inward_will_do) {
  const NeutralHead head = build_neutral_head(shipped().heads, list_sitters()[1].spec);
  Scan scan = build_scan(head, {});
  const HeadForm whole = wrap_scan(stock(), scan).form;
  for (std::size_t i = 0; i + 2 < scan.mesh.corners.size(); i += 3)
    std::swap(scan.mesh.corners[i], scan.mesh.corners[i + 2]);
  const HeadForm inward = wrap_scan(stock(), scan).form;
  for (std::size_t i = 0; i < whole.points.size(); ++i)
    ASSERT_LT(glm::distance(inward.points[i], whole.points[i]), 0.05);

  ScanMaking face;
  face.neck_mm = -125;
  face.least_z_mm = -15;
  const HeadForm alone = wrap_scan(stock(), build_scan(head, face)).form;
  const NeutralHead wrapped = build_bare_head(stock(), alone.points);
  std::vector<glm::dvec3> ours, theirs;  // of the face
  for (std::size_t v = 0; v < head.skin.positions.size(); ++v) {
    const glm::vec3& p = head.skin.positions[v];
    if (is_unseen(v) || p.y < -105) continue;
    if (p.z < 10) {
      EXPECT_LT(glm::distance(p, wrapped.skin.positions[v]), 20) << "made up, but near";
      continue;
    }
    ours.emplace_back(wrapped.skin.positions[v]);
    theirs.emplace_back(p);
  }
  const Similarity same = settle(fit_similarity(ours, theirs), ours, head.skin.positions);
  const SurfaceTree tree = build_skin_tree(head.skin.positions);
  for (const glm::dvec3& p : ours)
    EXPECT_LT(find_nearest(tree, apply_similarity(same, p), 100).distance, 0.5);
}

TEST(wrap, one_side_is_enough) {
  const NeutralHead head = build_neutral_head(shipped().heads, list_sitters()[2].spec);
  ScanMaking left;
  left.least_x_mm = -8;
  const Outcome outcome = wrap(head, left);
  EXPECT_LT(outcome.out.mean, 0.1);
  EXPECT_LT(outcome.out.max, 1);
}

TEST(wrap, refuses_landmarks_that_are_no_heads) {
  const NeutralHead head = build_neutral_head(shipped().heads, HeadSpec{});
  const Scan good = build_scan(head, {});
  Scan scan = good;
  for (ScanMark& mark : scan.marks)
    for (auto& entry : mark.place) entry.first = stock().adult.mirror[entry.first];
  EXPECT_EQ(find_fault(scan), "the landmarks' sides are swapped; expected _l on the character's own left");
  scan = good;
  scan.marks.front().at += 0.3 * (scan.marks.front().at - scan.marks.back().at) + glm::dvec3(0, 90, 0);
  EXPECT_TRUE(find_fault(scan).ends_with("on a head of our size; expected 30 at most")) << find_fault(scan);
  scan = good;
  for (ScanMark& mark : scan.marks) mark.at = glm::dvec3(1, 2, 3);
  EXPECT_EQ(find_fault(scan), "the landmarks lie in one place; expected them all over the head");
  scan = good;
  scan.mesh.corners.resize(300);
  scan.mesh.first.resize(101);
  EXPECT_TRUE(
      find_fault(scan).ends_with("places of a head have a surface near them; expected a face at least"));
  scan = good;
  scan.unit_mm = 1000;
  EXPECT_EQ(find_fault(scan),
            "with this unit the head is 1e+03 times as large as an adult's; expected 0.4 to 2.5, or no unit "
            "at all");
  scan.unit_mm = 0;
  for (glm::dvec3& p : scan.mesh.positions) p *= 150;
  for (ScanMark& mark : scan.marks) mark.at *= 150;
  EXPECT_EQ(find_fault(scan),
            "in mm, cm, in and m alike the head is no head's size, at best 150 times an adult's; expected "
            "0.4 to 2.5");
}

TEST(wrap, says_that_a_unit_would_tell_how_large_a_head_is) {
  const NeutralHead head = build_neutral_head(shipped().heads, HeadSpec{});
  Scan scan = build_scan(head, {});
  for (glm::dvec3& p : scan.mesh.positions) p *= 1.5;
  for (ScanMark& mark : scan.marks) mark.at *= 1.5;
  scan.mesh.file = "face.ply";
  EXPECT_EQ(
      join_warnings(wrap_scan(stock(), scan)),
      "the head is 1.5 times as large as an adult's in the unit that fits best: say the scan's unit, such as "
      "unit: mm\n");
  scan.unit_mm = 1;
  EXPECT_EQ(join_warnings(wrap_scan(stock(), scan)), "") << "who says so knows";
}

// Inner and outer corners of the eyes lie some 29 mm apart: less than a landmark may miss.
TEST(wrap, tells_landmarks_that_are_exchanged) {
  const NeutralHead head = build_neutral_head(shipped().heads, HeadSpec{});
  const Scan good = build_scan(head, {1});
  const auto find = [&](const char* name, int which) {
    for (std::size_t i = 0; i < good.marks.size(); ++i)
      if (good.marks[i].name == name && which-- == 0) return i;
    throw std::runtime_error(name);
  };
  for (const auto& [a, b] : {std::pair{find("en", 0), find("ex", 0)},
                             {find("en", 1), find("ex", 1)},
                             {find("en", 0), find("en", 1)},
                             {find("ch", 0), find("ch", 1)},
                             {find("prn", 0), find("sn", 0)},
                             {find("n", 0), find("prn", 0)}}) {
    Scan scan = good;
    std::swap(scan.marks[a].at, scan.marks[b].at);
    EXPECT_EQ(
        find_fault(scan).find(fmt::format("landmarks '{}' and '{}' look exchanged: they lie ",
                                          scan.marks[std::min(a, b)].name, scan.marks[std::max(a, b)].name)),
        0u)
        << find_fault(scan);
  }
  Scan scan = good;
  for (const int which : {0, 1})
    std::swap(scan.marks[find("en", which)].at, scan.marks[find("ex", which)].at);
  EXPECT_EQ(find_fault(scan).substr(0, 40), "landmarks 'en' and 'ex' look exchanged: ") << find_fault(scan);
}

// All landmarks of a ball lie where a head's would, more or less.
TEST(wrap, refuses_a_face_without_a_nose) {
  const NeutralHead head = build_neutral_head(shipped().heads, HeadSpec{});
  Scan scan = build_scan(head, {});
  const auto find = [&](const char* name) { return std::ranges::find(scan.marks, name, &ScanMark::name); };
  find("prn")->at = 0.5 * (find("n")->at + find("sn")->at);
  EXPECT_EQ(
      find_fault(scan),
      "landmark 'prn', the tip of the nose, stands 0.0 mm before the line from 'n' to 'sn' on a head of our "
      "size; expected 4.5 at least");
}

// Its points are a face's, its triangles join any three of them.
TEST(wrap, refuses_triangles_that_make_no_surface) {
  const NeutralHead head = build_neutral_head(shipped().heads, HeadSpec{});
  Scan scan = build_scan(head, {});
  std::mt19937 random(3);
  for (std::uint32_t& corner : scan.mesh.corners)
    corner = static_cast<std::uint32_t>(random() % scan.mesh.positions.size());
  EXPECT_TRUE(find_fault(scan).ends_with("expected 20 times at most: they make no surface"))
      << find_fault(scan);
}

TEST(wrap, says_how_much_of_the_face_a_scan_shows) {
  const NeutralHead head = build_neutral_head(shipped().heads, HeadSpec{});
  Scan scan = build_scan(head, {});
  ScanMaking making;
  making.neck_mm = -35;  // the nose and what lies above it
  const Wrap upper = wrap_scan(stock(), build_scan(head, making));
  EXPECT_LT(upper.worth.covered, 0.7) << describe_worth(upper.worth);
  EXPECT_EQ(upper.warnings.front().message,
            fmt::format(
                "only {:.0f} of 100 places of the face lie near the scan: the others are made up; scan more "
                "of the face, or see whether its landmarks are right",
                100 * upper.worth.covered));
  making.neck_mm = 25;  // the forehead alone
  EXPECT_EQ(find_fault(build_scan(head, making)).substr(0, 5), "only ");
}

TEST(wrap, warns_of_a_landmark_that_lies_elsewhere) {
  const NeutralHead head = build_neutral_head(shipped().heads, HeadSpec{});
  Scan scan = build_scan(head, {});
  const auto mark = std::ranges::find(scan.marks, "gn", &ScanMark::name);
  mark->at += 0.2 * (scan.marks.front().at - mark->at);  // up from the chin, 20 mm
  mark->said = {{"face.yaml", 7, 3}, "  gn: [0, 0, 0]"};
  const Wrap wrapped = wrap_scan(stock(), scan);
  ASSERT_FALSE(wrapped.warnings.empty()) << describe_worth(wrapped.worth);
  EXPECT_EQ(
      format_diagnostic(wrapped.warnings.back()),
      fmt::format(
          "face.yaml:7:3: warning: landmark 'gn' lies {:.1f} mm from where the wrapped head has it: the "
          "scan or the landmarks around it say otherwise\n    gn: [0, 0, 0]\n    ^",
          wrapped.worth.mark_mm));
}

}  // namespace
}  // namespace mien

#include "head/hair_locks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/smooth.hpp"
#include "head/hair_comb.hpp"
#include "head/hair_mass.hpp"
#include "head/strands.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::uint32_t kSeries = 51;  // of scatter()
enum Channel : std::uint32_t { kTone, kRoll, kWidth, kAngle, kDepth, kReach, kLean, kTurn, kBegin };

// How wide a lock is on its way: it comes out of the skin, is full, and runs out in a point.
double compute_lock_width(double way, const LockForm& form) {
  return (form.begins + (1 - form.begins) * smooth_step(0, form.widens, way)) *
         (1 - std::pow(way, form.runs_out));
}

std::uint16_t compute_tone(double shade) {
  return static_cast<std::uint16_t>(std::lround(std::clamp(shade, 0.0, 1.0) * (kHairTones - 1)));
}

// How far along the grain a place of a lock is, 0 at the root, 100 at the tip. From kThins on strands end one
// by one (materials.inc): over the last centimetres of a long lock, or all of it would be threads.
// Where it comes up through others it does so likewise, or it has a whole edge there.
double compute_grain(double way, double length_mm, double comes_up) {
  constexpr double kThins = 0.5, kThinning_mm = 34, kRoot = 4;
  // Short hair is not dark at its root and light at its tip in so little room: it would be quills.
  constexpr double kShort_mm = 15, kLong_mm = 60, kShortRoot = 0.35;
  const double last = length_mm > 0 ? std::min(1 - kThins, kThinning_mm / length_mm) : 1 - kThins;
  const double first = 1 - last;
  if (way < comes_up) return kRoot * way / comes_up;
  const double along = way < first ? kThins * way / first : kThins + (1 - kThins) * (way - first) / last;
  return 100 * std::lerp(kShortRoot * (1 - smooth_step(kShort_mm, kLong_mm, length_mm)), 1.0, along);
}

// What lies deep is dark, and no two locks are the same.
double compute_lock_shade(double layer, std::uint32_t index, std::uint32_t family) {
  constexpr double kFamily = 0.85;
  const double own = scatter(kSeries, index, kTone);
  const double tone = index == family ? own : std::lerp(own, scatter(kSeries, family, kTone), kFamily);
  return 0.4 + 0.15 * layer + 0.25 * (tone - 0.5) * (0.4 + 0.6 * layer);
}

double compute_tail_radius(double s) {
  return (0.4 + 0.6 * smooth_step(0, 0.3, s)) * (1 - 0.7 * smooth_step(0.6, 1.0, s));
}

// Whether hair at a place falls over the forehead, 1, or hangs beside the face, 0.
double compute_in_fringe(const HairScene& scene, const HairPlace& place) {
  constexpr double kFringe_deg = 40, kBeside_deg = 56;
  return sample_border(scene.hangs, 0) *
         (1 - smooth_step(kFringe_deg, kBeside_deg, std::abs(place.azimuth_deg)));
}

}  // namespace

glm::dvec3 TailLine::at(double s) const {
  const glm::dvec3 turn = start + out * reach_mm;
  const glm::dvec3 end = start + out * (0.85 * reach_mm) + glm::dvec3(0, -fall_mm, 0);
  return glm::mix(glm::mix(start, turn, s), glm::mix(turn, end, s), s);
}

const HairSeat& find_seat(const HairScene& scene, const HairPlace& place) {
  // What hangs free rides with the broadest place above it, not with forehead, cheek and neck.
  return find_hair_seat(scene.chart,
                        {place.azimuth_deg, scene.cut.covers_ears ? std::min(place.way, 0.7) : place.way});
}

void append_lock(HeadPart& part, const HairSeat& seat, const HairStrand& strand, double width_mm,
                 double shade, std::uint32_t index, const LockForm& form) {
  constexpr double kFan_deg = 16;  // more and neighbours look like rods, less and the mass like a sheet
  constexpr double kGround =
      0.75;  // of the head's own roundness: none and every lock shines by itself, all and none does
  constexpr double kRoll_deg = 5;  // about its own way, or all lie in one plane
  const double fan = kFan_deg * kPi / 180,
               roll = kRoll_deg * kPi / 180 * (2 * scatter(kSeries, index, kRoll) - 1);
  Mesh& mesh = part.part.rest;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const std::size_t rings = strand.points.size();
  const std::vector<double> ways = compute_ways(strand);
  const double grain = 11.0 * (index % 997);  // mm: no two locks show the same streaks
  for (std::size_t i = 0; i < rings; ++i) {
    const double s = ways[i];
    const glm::dvec3 ahead = strand.points[std::min(i + 1, rings - 1)] - strand.points[i > 0 ? i - 1 : 0];
    const glm::dvec3 along = glm::dot(ahead, ahead) > 1e-12 ? glm::normalize(ahead) : glm::dvec3(0, -1, 0);
    glm::dvec3 out = strand.outs[i] - along * glm::dot(strand.outs[i], along);
    out = glm::dot(out, out) > 1e-6 ? glm::normalize(out) : glm::dvec3(0, 0, 1);
    const glm::dvec3 level = glm::cross(along, out);
    const glm::dvec3 side = std::cos(roll) * level + std::sin(roll) * out, up = glm::cross(side, along);
    const double half_mm = 0.5 * width_mm * compute_lock_width(s, form);
    const bool is_tip = i + 1 == rings;
    for (const double hand : {-1.0, 1.0}) {
      if (is_tip && hand > 0) break;
      mesh.positions.emplace_back(strand.points[i] + (is_tip ? 0 : hand * half_mm) * side);
      const glm::dvec3 lit = glm::normalize(glm::mix(up, out, kGround));
      mesh.normals.emplace_back(
          glm::normalize(std::cos(fan) * lit + (is_tip ? 0 : hand) * std::sin(fan) * side));
      part.part.grain.emplace_back(
          grain + (is_tip ? 0 : hand) * 0.5 * width_mm * (0.6 + 0.4 * compute_lock_width(s, form)),
          compute_grain(s, strand.length_mm, form.comes_up));
    }
  }
  const auto count = static_cast<std::uint32_t>(mesh.positions.size()) - first;
  for (std::uint32_t i = 0; i + 3 < count; i += 2) {
    const std::uint32_t a = first + i;
    mesh.triangles.push_back({a, a + 1, a + 3});
    mesh.triangles.push_back({a, a + 3, a + 2});
  }
  mesh.triangles.push_back({first + count - 3, first + count - 2, first + count - 1});
  part.part.shade.resize(mesh.positions.size(), compute_tone(shade));
  part.bindings.push_back({seat.triangle, seat.barycentric, first, count});
}

void append_locks(HeadPart& part, const HairScene& scene) {
  const HairCut& cut = scene.cut;
  const double size = scene.chart.size * (1 - 0.3 * scene.youth);  // a child's hair is finer
  // Some frame the face, where the mass would show as a bare strip; more and the crown has gaps.
  constexpr double kAtFace = 0.24;
  constexpr double kFaceRise_mm = 60;    // sooner, and a row of roots stands like a comb's teeth
  constexpr double kFringeRise_mm = 38;  // a fringe is hardly longer
  constexpr double kFaceAway = 0.35;     // more, and all of it is swept behind the ears
  constexpr LockForm kAboutFace{0.55, 10, 0.02}, kOverForehead{0.12, 18, 0.05}, kBetween{0.15, 18, 0.02},
      kAtPartLine{0.5, 18, 0.04};
  const int at_face = cut.locks.from_part > 0 ? static_cast<int>(kAtFace * cut.locks.count) : 0;
  // Over an open forehead they begin at its border, or it is a bare edge.
  constexpr double kAtFront = 0.2;
  const bool is_open = cut.locks.from_part > 0 && sample_border(scene.hangs, 0) == 0;
  const int at_front = is_open ? static_cast<int>(kAtFront * cut.locks.count) : 0;
  // And beside their part, where few of the others begin: it would be a bare strip too. Short hair lies down
  // at once there.
  constexpr double kAtPart = 0.3, kAtShortPart = 0.12;
  const bool is_short = !cut.covers_ears && has_long_part(scene);
  const double share_at_part = is_open ? kAtPart : is_short ? kAtShortPart : 0;
  const int at_part = static_cast<int>(share_at_part * cut.locks.count);
  std::vector<HairPlace> roots = spread_roots(scene, cut.locks.count - at_face - at_front - at_part,
                                              cut.locks.root_band, cut.is_mirrored);
  const std::size_t first_at_part = roots.size();
  for (const HairPlace& root : spread_part_roots(scene, at_part)) roots.push_back(root);
  const std::size_t first_at_face = roots.size();
  for (const HairPlace& root : spread_border_roots(scene, at_face)) roots.push_back(root);
  const std::size_t first_at_front = roots.size();
  for (const HairPlace& root : spread_front_roots(scene, at_front)) roots.push_back(root);
  HairScene over_forehead = scene;
  over_forehead.cut.locks.rise_mm = kFaceRise_mm;
  HairScene about_face = scene;
  about_face.cut.comb.away *= kFaceAway;
  HairScene at_short_part = scene;
  at_short_part.cut.locks.risen = 1e-3;  // at once
  at_short_part.cut.locks.rise_mm = 0;
  constexpr LockForm kAlone{0.16, 5};      // its strands end one by one, and its outline late
  constexpr LockForm kTogether{0.04, 18};  // no skin shows at a part, and tips are no threads
  constexpr double kComesUp_mm = 30;       // that begin between others
  constexpr double kMostComesUp = 0.4, kFringeComesUp = 0.75;  // of the length; a fringe's are short
  constexpr double kAtBorder = 0.45,
                   kBorder_mm = 16;  // of short hair: toward its border locks are single hairs
  const std::vector<HairStrand> families = grow_families(scene);
  for (std::uint32_t index = 0; index < roots.size(); ++index) {
    const HairStrand* middle = find_family(scene, families, roots[index]);
    const std::uint32_t family = middle != nullptr ? middle->index : index;
    const bool is_over_forehead = index >= first_at_front;
    const bool is_about_face = index >= first_at_face && !is_over_forehead;
    const bool is_at_part = index >= first_at_part && index < first_at_face;
    const bool is_long = index < first_at_part && scatter(kSeries, index, kBegin) < cut.locks.from_part;
    // They come through those that lie over them here and there: all at once, and there is a row of ends.
    const double in_fringe = compute_in_fringe(scene, roots[index]);
    about_face.cut.locks.rise_mm =
        std::lerp(kFaceRise_mm, kFringeRise_mm, in_fringe) * (0.5 + 1.2 * scatter(kSeries, index, kReach));
    HairStrand strand =
        grow_strand(is_about_face            ? about_face
                    : is_over_forehead       ? over_forehead
                    : is_at_part && !is_open ? at_short_part
                                             : scene,
                    is_long ? trace_to_part(scene, roots[index], index) : roots[index], index, family);
    if (strand.points.empty()) continue;
    const bool is_fringe = is_about_face && in_fringe > 0;
    if (middle != nullptr && !is_fringe) fall_in(scene, *middle, strand);
    double width = size * cut.locks.width_mm * (0.7 + 0.6 * scatter(kSeries, index, kWidth));
    if (cut.locks.widest > 0) width = std::min(width, cut.locks.widest * strand.length_mm);
    if (scene.ends.empty())
      width *= std::lerp(kAtBorder, 1.0, smooth_step(0, kBorder_mm, compute_inside_mm(scene, strand.root)));
    LockForm form = is_fringe           ? kOverForehead
                    : is_about_face     ? kAboutFace
                    : is_over_forehead  ? kOverForehead
                    : is_at_part        ? kAtPartLine
                    : middle != nullptr ? (is_long ? kTogether : kBetween)
                                        : kAlone;
    if (is_about_face)
      form.comes_up = std::min(is_fringe ? kFringeComesUp : kMostComesUp,
                               about_face.cut.locks.rise_mm * size / strand.length_mm);
    if (middle != nullptr && !is_long && index < first_at_part)
      form.comes_up = std::min(kMostComesUp, kComesUp_mm * size / strand.length_mm);
    append_lock(part, find_seat(scene, strand.root), strand, width,
                compute_lock_shade(strand.layer, index, family), index, form);
  }
}

void append_part_line(HeadPart& part, const HairScene& scene) {
  constexpr int kRings = 22;
  constexpr double kAbove_mm = 0.3;  // the mass, in its groove
  constexpr double kWander_mm = 0.8,
                   kInside_mm = 5;  // before the hairline it would be a needle on the forehead
  const HairComb& comb = scene.cut.comb;
  const double size = scene.chart.size;
  HairStrand strand;
  for (int ring = 0; ring < kRings; ++ring) {
    const double s = static_cast<double>(ring) / (kRings - 1);
    HairPlace place = compute_part_place(scene, s);
    if (compute_inside_mm(scene, place) < kInside_mm) continue;
    const double high_mm = compute_mass_height_mm(scene, place) + kAbove_mm * size;
    glm::dvec3 point = compute_hair_point(scene.chart, place, compute_ground_mm(scene, place) + high_mm);
    if (comb.side_mm != 0) point.x += kWander_mm * size * sample_noise(kSeries, 0.45 * ring, kRings);
    strand.points.push_back(point);
    strand.outs.push_back(compute_ground_normal(scene, place));
    if (strand.points.size() == 1) strand.root = place;
  }
  if (strand.points.size() < 3) return;
  const auto first = part.part.rest.positions.size();
  append_lock(part, find_seat(scene, strand.root), strand, comb.scalp_mm * size, 0, 0);
  // Brows that rise push the mass together: the line goes with it, place by place, or is buried.
  part.bindings.pop_back();
  for (std::size_t v = first; v < part.part.rest.positions.size(); ++v) {
    const HairPlace place = compute_hair_place(scene.chart, glm::dvec3(part.part.rest.positions[v]));
    const HairSeat& seat = find_seat(scene, place);
    part.bindings.push_back({seat.triangle, seat.barycentric, static_cast<std::uint32_t>(v), 1});
  }
  std::fill(part.part.shade.begin() + static_cast<std::ptrdiff_t>(first), part.part.shade.end(),
            static_cast<std::uint16_t>(kHairTones));
}

void append_tail(HeadPart& part, const HairScene& scene) {
  constexpr std::uint32_t kCount = 65, kFirst = 10000;  // locks of its left half; their numbers among all
  constexpr int kRings = 12;
  const double size = scene.chart.size;
  const HairTail& tail = scene.cut.tail;
  glm::dvec3 at, out;
  compute_knot(scene, at, out);
  const HairSeat& seat = find_seat(scene, compute_hair_place(scene.chart, at));
  const glm::dvec3 aside(1, 0, 0);
  for (std::uint32_t index = kFirst; index < kFirst + kCount; ++index) {
    const double angle = kPi * scatter(kSeries, index, kAngle);
    const double depth = 0.55 + 0.45 * std::sqrt(scatter(kSeries, index, kDepth));
    const double reach = 0.72 + 0.36 * scatter(kSeries, index, kReach);
    const TailLine line{at + out * 2.0 * size, out, tail.out_mm * size, tail.length_mm * size * reach};
    HairStrand strand;
    strand.length_mm = tail.length_mm * size * reach;
    for (int ring = 0; ring < kRings; ++ring) {
      const double s = static_cast<double>(ring) / (kRings - 1);
      const glm::dvec3 along = glm::normalize(line.at(s + 0.01) - line.at(s - 0.01));
      const glm::dvec3 up = glm::normalize(glm::cross(along, aside));
      const glm::dvec3 round = std::sin(angle) * aside + std::cos(angle) * up;
      const double sway = 1.5 * size * std::sin(2 * kPi * (1.3 * s + scatter(kSeries, index, kLean)));
      strand.points.push_back(line.at(s) + round * (depth * tail.radius_mm * size * compute_tail_radius(s)) +
                              sway * smooth_step(0.2, 1, s) * aside);
      strand.outs.push_back(round);
    }
    append_lock(part, seat, strand, 1.5 * scene.cut.locks.width_mm * size,
                compute_lock_shade((depth - 0.55) / 0.45, index, index), index);
  }
}

void append_bun(HeadPart& part, const HairScene& scene) {
  constexpr std::uint32_t kCount = 120, kFirst = 20000;
  constexpr int kRings = 13;
  const double radius = scene.cut.bun_radius_mm * scene.chart.size;
  glm::dvec3 at, out;
  compute_knot(scene, at, out);
  const HairSeat& seat = find_seat(scene, compute_hair_place(scene.chart, at));
  const glm::dvec3 centre = at + out * 0.6 * radius, aside(1, 0, 0), up = glm::cross(out, aside);
  for (std::uint32_t i = 0; i < kCount; ++i) {
    // Each lock winds from the rim of the knot over its top: a part of a turn, nearer and nearer to the axis.
    const std::uint32_t index = kFirst + i;
    const double start = 2 * kPi * i / kCount, low = 1.75 - 0.9 * scatter(kSeries, index, kDepth);
    const double turns = 0.45 + 0.35 * scatter(kSeries, index, kReach);
    const double bulge = 1.0 + 0.05 * (scatter(kSeries, index, kWidth) - 0.3);
    HairStrand strand;
    for (int ring = 0; ring < kRings; ++ring) {
      const double s = static_cast<double>(ring) / (kRings - 1);
      const double angle = std::lerp(low, 0.22, s), turn = start + 2 * kPi * turns * s;
      const glm::dvec3 level = std::cos(turn) * aside + std::sin(turn) * up;
      const glm::dvec3 way = 0.8 * std::cos(angle) * out + std::sin(angle) * level;
      const double sink = 0.06 * smooth_step(0.75, 1, s) + 0.08 * (1 - smooth_step(0, 0.12, s));
      strand.points.push_back(centre + radius * (bulge - sink) * way);
      strand.outs.push_back(glm::normalize(way));
    }
    append_lock(part, seat, strand, 0.30 * radius, 0.3 + 0.6 * scatter(kSeries, index, kTone), index);
  }
}

void append_down(HeadPart& part, const HairScene& scene) {
  const HairDown& down = scene.cut.down;
  const double size = scene.chart.size;
  constexpr double kBeyond = 0.3;  // of the band, outside the border
  constexpr double kFirst = 0.7548776662466927, kSecond = 0.5698402909980532;  // see spread_roots
  const bool is_left = scene.cut.is_mirrored;
  const int wanted = is_left ? down.count / 2 : down.count;
  Mesh& mesh = part.part.rest;
  int grown = 0;
  for (std::uint32_t i = 1; grown < wanted && i < 150u * static_cast<std::uint32_t>(down.count); ++i) {
    const double turn = std::fmod(i * kFirst, 1.0), along = std::fmod(i * kSecond, 1.0);
    HairPlace place{is_left ? 180 * turn : 360 * turn - 180, 1.7 * along};
    const double inside_mm = compute_inside_mm(scene, place);
    if (inside_mm > down.band_mm || inside_mm < -kBeyond * down.band_mm) continue;
    const double room = compute_room(scene.chart, place);
    const double soft_mm = std::min(down.band_mm, 2 * scene.cut.soft_mm);
    const double thin = smooth_step(-kBeyond * soft_mm, 0.6 * soft_mm, inside_mm);
    if (scatter(kSeries, i, kReach) > room * thin) continue;
    ++grown;
    const glm::dvec3 normal = compute_ground_normal(scene, place);
    const double ground = sample_hair_chart(scene.chart, scene.chart.skin_mm, place);
    const glm::dvec3 root = compute_hair_point(scene.chart, place, ground - 0.1);
    glm::dvec3 way = compute_comb_way(scene, place);
    const double lean = 1.1 * (scatter(kSeries, i, kTurn) - 0.5);
    way = glm::normalize(way + lean * glm::cross(normal, way));
    const double length = size * down.length_mm * (0.5 + 0.9 * scatter(kSeries, i, kWidth)) *
                          (0.45 + 0.55 * smooth_step(-kBeyond * soft_mm, soft_mm, inside_mm));
    const double stand = down.stand * (0.6 + 0.8 * scatter(kSeries, i, kLean));
    const glm::dvec3 rise = glm::normalize(way + stand * normal);
    const glm::dvec3 side = glm::normalize(glm::cross(normal, way)) * (size * down.radius_mm);
    const glm::dvec3 middle = root + 0.5 * length * rise;
    const glm::dvec3 tip = middle + 0.5 * length * glm::normalize(way + 0.35 * stand * normal);
    const std::uint32_t first =
        append_blade({glm::vec3(root - side), glm::vec3(root + side), glm::vec3(middle - 0.7 * side),
                      glm::vec3(middle + 0.7 * side), glm::vec3(tip)},
                     glm::vec3(normal), mesh);
    part.part.shade.resize(mesh.positions.size(),
                           static_cast<std::uint16_t>(scatter(kSeries, i, kTone) * kHairShades));
    const HairSeat& seat = find_hair_seat(scene.chart, place);
    part.bindings.push_back({seat.triangle, seat.barycentric, first, 5});
  }
}

}  // namespace mien

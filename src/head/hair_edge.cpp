// Drawn hair is a silhouette first (Hart, "Manga Mania: How to Draw Japanese Comics", 2001): its mass, and
// the few locks that its edge is cut into.
#include "head/hair_edge.hpp"

#include <algorithm>
#include <cmath>

#include "core/conventions.hpp"
#include "core/smooth.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

constexpr std::uint32_t kDrawnSeries = 61;  // of scatter()
constexpr double kBehindEar_deg = 104;
enum DrawnChannel : std::uint32_t { kBreadth, kDeep, kTipAside, kBent, kShort };

// How much further back than its cut says what falls beside a face goes by the eye.
double find_back_deg(const HairScene& scene) {
  constexpr double kEye = 1.3, kEye_deg = 57;  // a way: as low as an eye; there it is that far aside
  constexpr int kLast_deg = 57;
  if (!scene.cut.covers_ears) return 0;
  for (int degree = 0; degree < kLast_deg; ++degree)
    if (sample_border(scene.ends, degree) > kEye) return kEye_deg - degree;
  return 0;
}

// Where hair would end if no lock parted from another: where its cut lets tips end, but above ears that it
// leaves free.
double compute_knotted_border(const HairScene& scene, double azimuth_deg) {
  constexpr double kBefore_deg = 66, kEar_deg = 78, kBehind_deg = 94, kPast_deg = 108;
  const double azimuth = std::abs(azimuth_deg), line = sample_border(scene.hairline, azimuth);
  if (scene.ends.empty()) return line;
  // As low as an eye it lies behind the eye; below, the lock that frames the face comes forward.
  constexpr double kFirst_deg = 14, kWhole_deg = 46, kPassed_deg = 84, kEnd_deg = 112;
  const double beside =
      smooth_step(kFirst_deg, kWhole_deg, azimuth) - smooth_step(kPassed_deg, kEnd_deg, azimuth);
  const double end = sample_border(scene.ends, azimuth - beside * find_back_deg(scene));
  // Brows tell more where they are drawn, and go further up: a fringe leaves them room.
  constexpr double kFringe_mm = 6, kFront_deg = 44, kSide_deg = 58;
  // Its hem is shorter at the nape than beside the face.
  constexpr double kNape_mm = 20, kCheek_deg = 70, kNape_deg = 165;
  if (scene.cut.covers_ears)
    return end - scene.chart.size / scene.chart.drop_mm *
                     (kFringe_mm * sample_border(scene.hangs, 0) *
                          (1 - smooth_step(kFront_deg, kSide_deg, azimuth)) +
                      kNape_mm * smooth_step(kCheek_deg, kNape_deg, azimuth));
  const double ear =
      smooth_step(kBefore_deg, kEar_deg, azimuth) - smooth_step(kBehind_deg, kPast_deg, azimuth);
  return std::lerp(end, line, ear);
}

// Behind an ear that is free, down to the nape: one line, straight as it is seen from the side.
double compute_nape_border(const HairScene& scene, double azimuth_deg) {
  constexpr double kFuller = 0.85;  // a power; 1: straight
  const auto find_depth = [](double degree) { return -std::cos(degree * kRadiansPerDegree); };
  const double first = find_depth(kBehindEar_deg);
  const double share = std::max(0.0, (find_depth(azimuth_deg) - first) / (1 - first));
  return std::lerp(compute_knotted_border(scene, kBehindEar_deg), compute_knotted_border(scene, 180),
                   std::pow(share, kFuller));
}

// The border without the corners that it has at its knots: an outline shows them.
double compute_plain_border(const HairScene& scene, double azimuth_deg) {
  constexpr int kReach_deg = 5;
  constexpr double kEarFirst_deg = 68, kEarLast_deg = 112;  // it comes no nearer to an ear
  constexpr double kSoft_deg = 6;
  double sum = 0, weights = 0;
  for (int i = -kReach_deg; i <= kReach_deg; ++i) {
    const double weight = kReach_deg + 1 - std::abs(i);
    sum += weight * compute_knotted_border(scene, wrap_azimuth(azimuth_deg + i));
    weights += weight;
  }
  const double azimuth = std::abs(azimuth_deg), smooth = sum / weights;
  if (scene.cut.covers_ears || azimuth <= kEarFirst_deg) return smooth;
  const double knotted = compute_knotted_border(scene, azimuth);
  if (!scene.ends.empty()) return azimuth < kEarLast_deg ? std::min(smooth, knotted) : smooth;
  const double border =
      std::lerp(smooth, compute_nape_border(scene, azimuth),
                smooth_step(kBehindEar_deg - kSoft_deg, kBehindEar_deg + kSoft_deg, azimuth));
  return azimuth < kBehindEar_deg - kSoft_deg ? std::min(border, knotted) : border;
}

// Where hair comes down the furthest before an ear.
double find_sideburn_deg(const HairScene& scene) {
  constexpr int kFirst_deg = 54, kLast_deg = 76;
  int lowest = kFirst_deg;
  for (int degree = kFirst_deg; degree <= kLast_deg; ++degree)
    if (compute_plain_border(scene, degree) > compute_plain_border(scene, lowest)) lowest = degree;
  return lowest;
}

// The same with sideburns that end in a point.
double compute_drawn_border(const HairScene& scene, double azimuth_deg) {
  constexpr double kWide_deg = 12, kPointed = 0.035;  // to both sides of the point; ways a degree
  const double plain = compute_plain_border(scene, azimuth_deg);
  if (scene.cut.covers_ears || scene.cut.ink.lock_mm <= 0) return plain;
  const double tip_deg = find_sideburn_deg(scene), away_deg = std::abs(std::abs(azimuth_deg) - tip_deg);
  if (away_deg > kWide_deg) return plain;
  const double beside = std::max(compute_plain_border(scene, tip_deg - kWide_deg),
                                 compute_plain_border(scene, tip_deg + kWide_deg));
  return std::min(plain, std::max(beside, compute_plain_border(scene, tip_deg) - kPointed * away_deg));
}

// How deep locks are parted at an azimuth, mm: at the front, the sides and the back.
double compute_lock_depth_mm(const HairScene& scene, double azimuth_deg) {
  const HairInk& ink = scene.cut.ink;
  const double azimuth = std::abs(azimuth_deg);
  const double side = smooth_step(44, 58, azimuth), back = smooth_step(112, 140, azimuth);
  return std::lerp(std::lerp(ink.tips_mm[0], ink.tips_mm[1], side), ink.tips_mm[2], back);
}

}  // namespace

double wrap_azimuth(double turn_deg) { return turn_deg - 360 * std::floor((turn_deg + 180) / 360); }

Fall find_fall(const HairScene& scene) {
  constexpr double kFirst = 0.015, kWhole = 0.9;  // of how much longer it gets
  constexpr double kLast_deg = 110, kLeast = 0.25;
  if (!scene.cut.covers_ears) return {};
  const double front = compute_drawn_border(scene, 0);
  double most = front;
  for (int degree = 0; degree < kLast_deg; ++degree)
    most = std::max(most, compute_drawn_border(scene, degree));
  if (most - front < kLeast) return {};
  Fall fall{0, kLast_deg, true};
  for (int degree = 0; degree < kLast_deg; ++degree) {
    const double share = (compute_drawn_border(scene, degree) - front) / (most - front);
    if (share < kFirst) fall.from_deg = degree;
    if (share > kWhole) {
      fall.to_deg = degree;
      break;
    }
  }
  return fall;
}

namespace {

// Which way tips lean, -1..1 along the degrees: the fringe away from where it is parted, which is not in its
// middle; all else toward the face.
double compute_lean(const HairScene& scene, double azimuth_deg) {
  constexpr double kFront_deg = 50, kSoft_deg = 8, kSkull_mm = 100, kBeside_deg = 13;
  const double part_deg =
      std::max(kBeside_deg, std::atan2(scene.cut.comb.side_mm, kSkull_mm) / kRadiansPerDegree);
  const double away = std::clamp((azimuth_deg - part_deg) / kSoft_deg, -1.0, 1.0);
  const double toward = azimuth_deg > 0 ? -1 : 1;
  return std::lerp(away, toward,
                   smooth_step(kFront_deg - kSoft_deg, kFront_deg + kSoft_deg, std::abs(azimuth_deg)));
}

// Locks of about the cut's width from one degree to another: broad ones, and narrow ones between them, which
// are shorter.
void append_drawn_locks(const HairScene& scene, double from_deg, double to_deg,
                        std::vector<DrawnLock>& locks) {
  constexpr double kRadius_mm = 95;                     // of the adult's hair: what its width is told on
  constexpr double kNarrowest = 0.5, kMore = 1.1;       // no two neighbours are alike
  constexpr double kAside = 0.13, kScattered = 0.07;    // of its breadth: how far off its middle a tip is
  constexpr double kBend = 0.26, kBendScattered = 0.1;  // of its breadth
  constexpr double kShorter = 0.42, kMoreShort = 0.16;  // of how deep it is parted
  constexpr double kFringe = 0.7, kFront_deg = 60;      // locks of a fringe: of its width
  const bool is_fringe = std::abs(wrap_azimuth(0.5 * (from_deg + to_deg))) < kFront_deg;
  const double width_deg = scene.cut.ink.lock_mm / (kRadius_mm * kRadiansPerDegree) *
                           (scene.cut.covers_ears && is_fringe ? kFringe : 1);
  const int count = std::max(1, static_cast<int>(std::lround((to_deg - from_deg) / width_deg)));
  std::vector<double> sizes, ends{0};
  const auto first = static_cast<std::uint32_t>(locks.size());
  for (int i = 0; i < count; ++i) {
    sizes.push_back(step_golden(static_cast<std::uint32_t>(i), scatter(kDrawnSeries, first, kBreadth)));
    ends.push_back(ends.back() + kNarrowest + kMore * sizes.back());
  }
  for (int i = 0; i < count; ++i) {
    const auto index = static_cast<std::uint32_t>(locks.size());
    const auto at = [&](int end) {
      return std::lerp(from_deg, to_deg, ends[static_cast<std::size_t>(end)] / ends.back());
    };
    DrawnLock lock{at(i), 0, at(i + 1)};
    const double middle = 0.5 * (lock.from_deg + lock.to_deg), wide = lock.to_deg - lock.from_deg;
    lock.lean = compute_lean(scene, wrap_azimuth(middle));
    const auto scatter_about = [&](double about, double most, DrawnChannel channel) {
      return about + most * (2 * scatter(kDrawnSeries, index, channel) - 1);
    };
    lock.tip_deg = middle + wide * scatter_about(kAside * lock.lean, kScattered, kTipAside);
    lock.bent_deg = wide * scatter_about(kBend * lock.lean, kBendScattered, kBent);
    const double narrow = 1 - sizes[static_cast<std::size_t>(i)];
    lock.tip_mm = compute_lock_depth_mm(scene, wrap_azimuth(lock.tip_deg)) *
                  (kShorter * narrow * narrow + kMoreShort * scatter(kDrawnSeries, index, kShort));
    locks.push_back(lock);
  }
}

// Where locks part, each as deep from both sides, and never lower than a tip.
void part_locks(const HairScene& scene, const Fall& fall, std::vector<DrawnLock>& locks) {
  constexpr double kFrame = 1.2, kSame_deg = 0.5, kShallowest = 0.75, kDeeper = 0.6,
                   kOver = 0.3;  // of how deep the cut says
  constexpr double kHem = 0.3, kSplit = 1.3,
                   kFramed = 0.9;  // the same where hair hangs: a few deep ones in one calm hem
  for (std::size_t i = 0; i < locks.size(); ++i) {
    DrawnLock& before = locks[(i + locks.size() - 1) % locks.size()];
    const double deep = compute_lock_depth_mm(scene, wrap_azimuth(locks[i].from_deg));
    const double at = scatter(kDrawnSeries, static_cast<std::uint32_t>(i), kDeep);
    const bool is_fringe = std::abs(wrap_azimuth(locks[i].from_deg)) < fall.from_deg;
    const double share = fall.is_there && !is_fringe ? kHem + kSplit * at * at : kShallowest + kDeeper * at;
    double& beside_mm = before.to_mm;
    beside_mm = std::max(deep * share, std::max(before.tip_mm, locks[i].tip_mm) + kOver * deep);
    // The one that frames the face ends in a point of its own.
    const auto frames = [&](const DrawnLock& lock) { return fall.is_there && lock.lean == 0; };
    if (frames(before) != frames(locks[i])) beside_mm = std::max(beside_mm, kFramed * deep);
    // What frames the face begins well over the forehead, or there is a step.
    if (fall.is_there && std::abs(std::abs(wrap_azimuth(locks[i].from_deg)) - fall.from_deg) < kSame_deg)
      beside_mm = kFrame * deep;
    locks[i].from_mm = beside_mm;
  }
}

}  // namespace

std::vector<DrawnLock> list_drawn_locks(const HairScene& scene) {
  std::vector<DrawnLock> locks;
  if (scene.cut.ink.lock_mm <= 0) return locks;
  const Fall fall = find_fall(scene);
  if (!fall.is_there) {
    // Before each ear one ends in a point.
    constexpr double kTemple_deg = 48, kEar_deg = 80;
    const double tip_deg = find_sideburn_deg(scene);
    locks.push_back({kTemple_deg, tip_deg, kEar_deg});
    append_drawn_locks(scene, kEar_deg, 360 - kEar_deg, locks);
    locks.push_back({360 - kEar_deg, 360 - tip_deg, 360 - kTemple_deg});
    append_drawn_locks(scene, 360 - kTemple_deg, 360 + kTemple_deg, locks);
    part_locks(scene, fall, locks);
    return locks;
  }
  // The one that frames the face has its tip where hair is as long as it gets.
  constexpr double kFrame = 1.5;  // of the way till there: its end
  const double end_deg = fall.from_deg + kFrame * (fall.to_deg - fall.from_deg);
  constexpr double kForward_deg = 13;
  locks.push_back({fall.from_deg, fall.to_deg, end_deg, 0, 0, 0, -kForward_deg});
  append_drawn_locks(scene, end_deg, 360 - end_deg, locks);
  locks.push_back({360 - end_deg, 360 - fall.to_deg, 360 - fall.from_deg, 0, 0, 0, kForward_deg});
  append_drawn_locks(scene, 360 - fall.from_deg, 360 + fall.from_deg, locks);
  part_locks(scene, fall, locks);
  return locks;
}

namespace {

// Toward a lock's tip an edge only goes down, and away from it up, whatever the border does between.
void ease_edge(std::vector<DrawnEdge>& edge, const std::vector<std::size_t>& tips) {
  const std::size_t count = edge.size();
  for (std::size_t t = 0; t < tips.size(); ++t) {
    const std::size_t tip = tips[t], next = tips[(t + 1) % tips.size()];
    const std::size_t end = tip + (next + count - tip - 1) % count + 1;  // the next one, a turn on perhaps
    // Where two locks part is the highest place between their tips.
    std::size_t high = tip;
    for (std::size_t i = tip; i <= end; ++i)
      if (edge[i % count].way < edge[high % count].way) high = i;
    for (std::size_t i = tip + 1; i < high; ++i)
      edge[i % count].way = std::min(edge[i % count].way, edge[(i - 1) % count].way);
    for (std::size_t i = end - 1; i > high; --i)
      edge[i % count].way = std::min(edge[i % count].way, edge[(i + 1) % count].way);
  }
}

// From the last tip of the fringe down to the point before an ear in one line: neither up again between the
// two nor along the border with its corners.
void sweep_temples(std::vector<DrawnEdge>& edge, const std::vector<DrawnLock>& locks,
                   const std::vector<std::size_t>& tips) {
  constexpr double kHollow = 1.7, kBent = 0.5;  // a power, 1: straight; of the way: till there it is bent
  const std::size_t count = locks.size();
  for (std::size_t l = 0; l < count; ++l) {
    if (locks[l].lean != 0) continue;  // between the temples
    const bool is_left = locks[l].tip_deg < 180;
    const std::size_t beside = (is_left ? l + count - 1 : l + 1) % count;
    const DrawnEdge from = edge[tips[beside]], tip = edge[tips[l]];
    const double whole_deg = wrap_azimuth(tip.turn_deg - from.turn_deg);
    for (DrawnEdge& at : edge) {
      const double toward = is_left ? at.across : -at.across;
      if (!(at.lock == l && toward < 0) && !(at.lock == beside && toward > 0)) continue;
      const double share = std::clamp(wrap_azimuth(at.turn_deg - from.turn_deg) / whole_deg, 0.0, 1.0);
      at.way = std::lerp(from.way, tip.way, std::pow(share, kHollow));
      at.bent_deg = from.bent_deg * (1 - smooth_step(0, kBent, share));
      at.deep_mm = 0;
    }
  }
}

}  // namespace

std::vector<DrawnEdge> trace_drawn_edge(const HairScene& scene) {
  constexpr double kStep_deg = 2.2;                  // between columns of the mass at most
  constexpr int kLeastSteps = 6;                     // from a tip to where locks part: its outline is a curve
  constexpr double kCurved_mm = 2;                   // less deep, and there is nothing to see of it
  constexpr double kBellied = 0.85, kFuller = 0.42;  // of its outline, as a power; 1: straight
  constexpr double kCloser = 1.35;                   // columns toward where locks part, as a power
  constexpr double kBentDeep_mm = 12;                // so deep, and its tip is bent aside all the way
  constexpr double kLifted_mm = 5;                   // deep locks stand off the skin
  constexpr double kNoLock_deg = 20;                 // of hair that ends in none: what it looks like above
  const double way_of_mm = scene.chart.size / scene.chart.drop_mm;
  std::vector<DrawnEdge> edge;
  const auto add = [&](double turn_deg, double up_mm) -> DrawnEdge& {
    const double azimuth = wrap_azimuth(turn_deg), deep = compute_lock_depth_mm(scene, azimuth);
    const double hangs = scene.cut.covers_ears ? sample_border(scene.hangs, azimuth) : 0;
    // What has no end of its own hangs over its border by its locks.
    const double over_mm = scene.ends.empty() ? deep : 0;
    return edge.emplace_back(DrawnEdge{turn_deg,
                                       compute_drawn_border(scene, azimuth) + (over_mm - up_mm) * way_of_mm,
                                       0, std::max(hangs, smooth_step(0, kLifted_mm, deep))});
  };
  const std::vector<DrawnLock> locks = list_drawn_locks(scene);
  std::vector<std::size_t> tips;
  if (locks.empty())
    for (int i = 0; i < 360 / kStep_deg; ++i) {
      DrawnEdge& at = add(i * kStep_deg, 0);
      at.lock = static_cast<std::size_t>(at.turn_deg / kNoLock_deg);
      at.across = 2 * (at.turn_deg / kNoLock_deg - static_cast<double>(at.lock)) - 1;
    }
  for (std::size_t l = 0; l < locks.size(); ++l) {
    const DrawnLock& lock = locks[l];
    const auto walk = [&](double from_deg, double to_deg, double up_mm, bool is_down) {
      const double deep_mm = up_mm - lock.tip_mm;
      const double power = kBellied * std::exp2((is_down ? -kFuller : kFuller) * lock.lean);
      const int steps = std::max(deep_mm > kCurved_mm ? kLeastSteps : 1,
                                 static_cast<int>(std::ceil(std::abs(to_deg - from_deg) / kStep_deg)));
      for (int i = 0; i < steps; ++i) {
        const double t = static_cast<double>(i) / steps, way = std::pow(is_down ? t : 1 - t, kCloser),
                     s = is_down ? way : 1 - way, low = std::pow(way, power);
        DrawnEdge& at = add(std::lerp(from_deg, to_deg, s), lock.tip_mm + deep_mm * (1 - low));
        at.bent_deg =
            (lock.lean == 0 ? low * low * low : low) * smooth_step(0, kBentDeep_mm, deep_mm) * lock.bent_deg;
        at.across = is_down ? way - 1 : 1 - way;
        at.deep_mm = deep_mm;
        at.lock = l;
      }
    };
    walk(lock.from_deg, lock.tip_deg, lock.from_mm, true);
    tips.push_back(edge.size());
    walk(lock.tip_deg, lock.to_deg, lock.to_mm, false);
  }
  ease_edge(edge, tips);
  if (!locks.empty() && !find_fall(scene).is_there) sweep_temples(edge, locks, tips);
  return edge;
}

}  // namespace mien

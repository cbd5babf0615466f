// The warps were made by hand against drawings of Tezuka's; what they leave uneven a thin plate over the cage
// carries smoothly from lids and lips, which are held, to all else (the Laplacian of the displacement is kept
// small).
#include "head/design.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/smooth.hpp"
#include "head/cage.hpp"
#include "head/form.hpp"
#include "head/least_squares.hpp"

namespace mien {

namespace {

// How much of something the points of the rings get, by the beginning of their names.
struct RingShare {
  std::string_view ring;
  double share;
};

template <std::size_t N>
double find_share(const std::array<RingShare, N>& shares, std::string_view name, double other = 0) {
  for (const RingShare& share : shares)
    if (has_prefix(name, share.ring)) return share.share;
  return other;
}

// What the warps are told by: the head before them, in the adult's millimetres about the height of its eyes.
struct Measures {
  double size = 1;  // of its eyeball against the adult's: all lengths below are an adult's
  double mouth_y = 0, corner_x = 0, corner_y = 0, corner_z = 0, lips_z = 0, nose_y = 0, chin_y = 0;
  glm::dvec3 tip{0}, eye{0};
};

constexpr double kAdultBall_mm = 13;

Measures measure(const Cage& cage, const HeadForm& form) {
  Measures m;
  m.size = form.eye.radius_mm / kAdultBall_mm;
  const auto at = [&](std::string_view name) {
    return (form.points[find_point(cage, name)] - glm::dvec3(0, form.eye.centre.y, 0)) / m.size;
  };
  m.mouth_y = at("M1_0").y;
  m.corner_x = at("M1_6").x;
  m.corner_y = at("M1_6").y;
  m.corner_z = at("M1_6").z;
  m.lips_z = 0.5 * (at("M5_0").z + at("M5_12").z);
  m.nose_y = at("M6_0").y;
  m.chin_y = at("m12_D1").y;
  m.tip = at("p_tip");
  m.eye = {form.eye.centre.x / m.size, 0, form.eye.centre.z / m.size};
  return m;
}

// Lower and flatter lips: their rings toward the mouth's line and back to the face.
void warp_lips(const DesignNumbers& d, const Measures& m, std::string_view name, const glm::dvec3& v,
               glm::dvec3& p) {
  constexpr std::array kLower{RingShare{"M0_", 0.7}, RingShare{"M1_", 1},    RingShare{"M2_", 1},
                              RingShare{"M3_", 1},   RingShare{"M4_", 0.75}, RingShare{"M5_", 0.35}};
  constexpr std::array kBack{RingShare{"M1_", 0.5}, RingShare{"M2_", 0.9}, RingShare{"M3_", 1},
                             RingShare{"M4_", 0.6}};
  constexpr double kCorner = 0.5;  // less at the very corner: its skin must not fold into it
  const double across = std::clamp(v.x / m.corner_x, 0.0, 1.0);
  const double line = glm::mix(m.mouth_y, m.corner_y, across);
  const double share = 1 - kCorner * smooth_step(0.7, 1.0, across);
  p.y -= (v.y - line) * find_share(kLower, name) * (1 - d.lip_height) * share;
  p.z -= find_share(kBack, name) * (1 - d.lip_fullness) * share *
         std::max(0.0, v.z - glm::mix(m.lips_z, m.corner_z, across));
}

// Narrow wings, the tip up and forth, so that the nose ends in a wedge.
void warp_nose(const DesignNumbers& d, const Measures& m, const glm::dvec3& v, glm::dvec3& p) {
  const glm::dvec3 from_wings = (v - m.tip - glm::dvec3(0, -2, -8)) / glm::dvec3(20, 20, 26);
  const double wings =
      1 - smooth_step(0.55, 1.35, glm::length(glm::dvec3(v.x / 20, from_wings.y, from_wings.z)));
  p.x *= 1 - (1 - d.nose_width) * wings;
  const glm::dvec3 from_tip = (v - m.tip) / glm::dvec3(16, 26, 30);
  const double tip = 1 - smooth_step(0.0, 1.25, glm::length(glm::dvec3(v.x / 16, from_tip.y, from_tip.z)));
  p += glm::dvec3(0, d.nose_up, d.nose_forward) * tip;
}

// A shorter lower face, narrower down to the chin, which may come forward, on a thin neck; fuller cheeks, so
// that the face is an egg.
void warp_lower_face(const DesignNumbers& d, const Measures& m, const glm::dvec3& v, glm::dvec3& p) {
  const double from = m.nose_y + 10, height = from - m.chin_y;
  const double down = std::max(0.0, (from - p.y) / height);  // 1 at the chin
  const double neck = d.neck_width / d.chin_width;
  p.x *= 1 - (1 - d.chin_width) * smooth_step(-0.35, 1.0, (from - p.y) / height);
  p.x *= 1 - (1 - neck) * smooth_step(1.0, 1.6, down);
  if (p.y < from) {
    const double below = 1 - (1 - std::min(1.0, d.face_height / 0.7)) * 0.1;  // the neck hardly gets shorter
    p.y = from - height * (down <= 1 ? d.face_height * down : d.face_height + (down - 1) * below);
  }
  p.z *= 1 - 0.65 * (1 - d.neck_width) * smooth_step(1.02, 1.6, down);
  const glm::dvec3 from_chin = (v - glm::dvec3(0, m.chin_y + 8, m.lips_z)) / glm::dvec3(38, 30, 62);
  p.z += d.chin_forward * (1 - smooth_step(0.15, 1.0, glm::length(from_chin)));
  const double cheek = 1 - smooth_step(0.0, 1.0, std::hypot((v.y - m.mouth_y - 8) / 42, (v.z - 58) / 50));
  p.x += d.cheeks * cheek * std::clamp(v.x / 45, 0.0, 1.0);
}

void warp_cranium(const DesignNumbers& d, const glm::dvec3& v, glm::dvec3& p) {
  p.y += (d.cranium_height - 1) * std::max(0.0, v.y - 10) * smooth_step(5.0, 60.0, v.y);
  p.x *= 1 + (d.cranium_width - 1) * smooth_step(-15.0, 55.0, v.y);
  p.z *= 1 + (d.cranium_depth - 1) * smooth_step(0.0, 50.0, v.y);
}

// Larger eyes, whose lids open along the ball, further out and back.
void warp_eyes(const DesignNumbers& d, const Measures& m, std::string_view name, const glm::dvec3& v,
               glm::dvec3& p) {
  constexpr std::array kLids{RingShare{"EB_", 1},  RingShare{"E0_", 1},   RingShare{"E1_", 1},
                             RingShare{"E2_", 1},  RingShare{"E3_", 0.8}, RingShare{"E4_", 0.5},
                             RingShare{"E5_", 0.2}};
  constexpr double kRim = 16, kFar = 60, kMostUp = 0.95;  // mm about the ball, and of the ball's height
  const double lid = find_share(kLids, name);
  const glm::dvec3 arm = p - m.eye;
  const double length = std::max(glm::length(arm), 1e-9);
  glm::dvec3 way = arm / length;
  const double share = std::max(1 - smooth_step(16.0, 46.0, length), lid);
  const double open =
      1 + (d.eye_opening - 1) * std::max(1 - smooth_step(13.0, 27.0, length), lid * (lid >= 0.8 ? 1 : 0.9));
  const double opened = way.y * open;
  const double held =
      std::lerp(opened, kMostUp * std::tanh(opened / kMostUp), std::min(1.0, std::abs(open - 1) / 0.3));
  const double up = std::lerp(way.y, held, share);
  const double level = std::sqrt(std::max(0.02, 1 - up * up) / std::max(1e-6, way.x * way.x + way.z * way.z));
  way = {way.x * level, up, way.z * level};
  const double grown = length < kRim
                           ? length * d.eye_size
                           : length + kRim * (d.eye_size - 1) * (1 - smooth_step(kRim, kFar, length));
  const double before_x = p.x;
  p = m.eye + way * grown;
  if (p.x < before_x && lid == 0) p.x = std::lerp(before_x, p.x, smooth_step(4.0, 20.0, v.x));
  const double carried = std::max(1 - smooth_step(18.0, 50.0, length), lid);
  p += carried * glm::dvec3(d.eye_out * std::clamp(v.x / 14, 0.0, 1.0), d.eye_up,
                            -d.eye_back * smooth_step(0.0, 25.0, v.z));
}

double compute_lift(const glm::dvec3& p, const Eye& eye) {
  return std::atan2(p.y - eye.centre.y, p.z - eye.centre.z);
}

// Lids that open further leave the fold over them less room, and an old one has hardly any: where less is
// left than `before` had, the fold goes up, and the hood over it too.
void keep_lid_room(const Cage& cage, double opening, const HeadForm& before, HeadForm& form) {
  constexpr double kRoom_rad = 0.06;
  constexpr std::array kCarried{RingShare{"E3_", 1}, RingShare{"E4_", 1}, RingShare{"E5_", 0.5}};
  if (opening <= 1) return;
  for (int i = 1; i < 8; ++i) {
    const auto find = [&](const char* ring) { return find_point(cage, ring + std::to_string(i)); };
    const std::uint32_t lid = find("E2_"), fold = find("E3_");
    const auto measure_room = [&](const HeadForm& one) {
      return compute_lift(one.points[fold], one.eye) - compute_lift(one.points[lid], one.eye);
    };
    const double wanted = std::min(kRoom_rad, measure_room(before) + kRoom_rad * (opening - 1));
    const double lift = wanted - measure_room(form);
    if (lift <= 0) continue;
    for (const RingShare& ring : kCarried) {
      glm::dvec3& p = form.points[find(ring.ring.data())];
      const double angle = compute_lift(p, form.eye) + ring.share * lift,
                   radius = std::hypot(p.y - form.eye.centre.y, p.z - form.eye.centre.z);
      p.y = form.eye.centre.y + radius * std::sin(angle);
      p.z = form.eye.centre.z + radius * std::cos(angle);
    }
  }
}

// The least uneven moves that come near to those asked for: lids and lips are held to theirs, all else may
// follow.
std::vector<glm::dvec3> smooth_moves(const Cage& cage, const std::vector<glm::dvec3>& moves) {
  constexpr std::array kHeld{RingShare{"EB_", 3},  RingShare{"E0_", 3},   RingShare{"E1_", 3},
                             RingShare{"E2_", 2},  RingShare{"E3_", 0.5}, RingShare{"M0_", 1},
                             RingShare{"M1_", 2},  RingShare{"M2_", 1},   RingShare{"M3_", 0.6},
                             RingShare{"k_", 0.5}, RingShare{"n", 0.3},   RingShare{"er", 0.05},
                             RingShare{"p_tip", 1}};
  constexpr double kOther = 0.18;
  LeastSquares problem;
  const std::vector<LinearRow> umbrellas = compute_umbrella_rows(cage);
  for (std::uint32_t i = 0; i < moves.size(); ++i) {
    const double held = find_share(kHeld, cage.names[i], kOther);
    problem.equations.push_back({{{i, 1.0}}, held * held, moves[i]});
    problem.equations.push_back({umbrellas[i], 1, glm::dvec3(0)});
  }
  return solve_least_squares(problem, moves.size());
}

// Round as it is, and its points lie far apart: drawn tight it would get corners.
bool is_cranium(std::string_view name) {
  constexpr std::array kBack{"s5_", "s6_", "s7_", "s8_", "s9_"};
  constexpr std::array kTop{"_F2", "_F3", "_F4"};
  return std::ranges::any_of(kBack, [&](const char* column) { return has_prefix(name, column); }) ||
         std::ranges::any_of(kTop, [&](const char* row) { return name.ends_with(row); });
}

// The skin between the features, drawn tight: each point some way toward the middle of its neighbours,
// several times.
void calm_skin(const Cage& adult, double calm, std::vector<glm::dvec3>& points) {
  constexpr std::array kFeatures{RingShare{"EB_", 0},   RingShare{"E0_", 0},   RingShare{"E1_", 0},
                                 RingShare{"E2_", 0},   RingShare{"E3_", 0.3}, RingShare{"MB", 0},
                                 RingShare{"M0_", 0},   RingShare{"M1_", 0},   RingShare{"M2_", 0},
                                 RingShare{"M3_", 0},   RingShare{"M4_", 0.3}, RingShare{"MA_", 0.6},
                                 RingShare{"n", 0},     RingShare{"k_", 0},    RingShare{"er", 0},
                                 RingShare{"p_tip", 0}, RingShare{"p_it", 0},  RingShare{"p_cb", 0},
                                 RingShare{"c1_", 0.3}, RingShare{"p_", 0.3},  RingShare{"s4_", 0.3}};
  constexpr int kRounds = 5;
  if (calm <= 0) return;
  Cage cage = adult;
  cage.points = points;
  const std::vector<LinearRow> umbrellas = compute_umbrella_rows(cage);
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<glm::dvec3> before = points;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!is_cranium(adult.names[i]))
        points[i] += 0.5 * calm * find_share(kFeatures, adult.names[i], 1) * sample_row(umbrellas[i], before);
  }
  mirror_half(adult, points);
}

// The bridge of the nose stays as wide as it was, nearly; nothing of the left half crosses the middle.
void keep_bridge(const Measures& m, const glm::dvec3& v, glm::dvec3& p) {
  constexpr double kLeast_mm = 0.02, kBridge = 0.85;
  if (v.x < 13 && v.y > m.nose_y + 14 && v.y < 40 && v.z > 60) p.x = std::max(p.x, kBridge * v.x);
  p.x = std::max(p.x, kLeast_mm);
}

}  // namespace

Mix compute_ages(const HeadSpec& spec) {
  if (spec.age != HeadSpec{}.age) return spec.age;
  if (spec.scan) return {};
  if (spec.mix.empty()) return spec.age;
  Mix ages;
  for (const HeadShare& share : spec.mix)
    for (const auto& [name, weight] : compute_ages(share.head)) ages[name] += share.weight * weight;
  return ages;
}

DesignNumbers compute_design(const HeadStock& stock, const HeadSpec& spec) {
  if (spec.design != HeadSpec{}.design || spec.mix.empty())
    return mix_designs(stock.data->designs, spec.design, compute_ages(spec));
  DesignNumbers sum;
  for (const DesignDial& dial : kDesignDials) sum.*dial.number = 0;
  for (const HeadShare& share : spec.mix) {
    const DesignNumbers own = compute_design(stock, share.head);
    for (const DesignDial& dial : kDesignDials) sum.*dial.number += share.weight * own.*dial.number;
  }
  return sum;
}

void apply_design(const Cage& adult, const DesignNumbers& design, const HeadForm& average, HeadForm& form) {
  Cage cage = adult;
  if (design.difference != 1) {
    HeadForm changed = average;
    add_form(changed, form, design.difference);
    add_form(changed, average, -design.difference);
    changed.hairline = form.hairline;
    changed.brow_thickness = form.brow_thickness;
    form = std::move(changed);
  }
  const HeadForm before = form;
  const Measures m = measure(cage, form);
  const glm::dvec3 middle(0, form.eye.centre.y, 0);
  std::vector<glm::dvec3> moves(form.points.size());
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (cage.mirror[i] < i) continue;
    const glm::dvec3 v = (form.points[i] - middle) / m.size;
    glm::dvec3 p = v;
    warp_lips(design, m, cage.names[i], v, p);
    warp_nose(design, m, v, p);
    warp_lower_face(design, m, v, p);
    warp_cranium(design, v, p);
    warp_eyes(design, m, cage.names[i], v, p);
    moves[i] = (p - v) * m.size;
    if (cage.mirror[i] == i) moves[i].x = 0;
  }
  mirror_half(cage, moves);
  cage.points = form.points;
  moves = smooth_moves(cage, moves);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (cage.mirror[i] < i) continue;
    const glm::dvec3 v = (form.points[i] - middle) / m.size;
    glm::dvec3 p = v + moves[i] / m.size;
    if (cage.mirror[i] != i) keep_bridge(m, v, p);
    form.points[i] = middle + m.size * p;
  }
  mirror_half(adult, form.points);
  calm_skin(adult, design.calm, form.points);
  form.eye.centre += m.size * glm::dvec3(design.eye_out, design.eye_up, -design.eye_back);
  form.eye.radius_mm *= design.eye_size;
  keep_lid_room(adult, design.eye_opening, before, form);
  mirror_half(adult, form.points);
}

}  // namespace mien

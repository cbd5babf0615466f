// The eyeball as a sculptor's recipe: a white with a well, a coloured cone in it, a clear cap over both.
// Sizes: ball and cornea after Gullstrand's schematic eye, enlarged to the ball of the cage (13 mm).
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

#include "config/part_numbers.hpp"
#include "core/smooth.hpp"
#include "head/binding.hpp"
#include "head/eye_rim.hpp"
#include "head/head.hpp"
#include "head/lids.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kScleraSpokes = 48;
constexpr int kIrisSpokes = 128;  // three to a fibre: fewer would draw polygons, more would not be seen
constexpr int kIrisRings = 13;
constexpr int kIrisRows = 22;    // colours from the pupil to the white
constexpr int kIrisLevels = 12;  // of each: a dark fibre below the upper lid to a bright one in the open

struct EyeFrame {
  glm::mat4 head_from_eye{1};  // from the ball's own frame at the adult size
  const EyeNumbers& numbers;
};

Ring make_circle(double radius, double z, int spokes) {
  Ring ring;
  for (int k = 0; k < spokes; ++k) {
    const double turn = 2 * kPi * k / spokes;
    ring.emplace_back(radius * std::cos(turn), radius * std::sin(turn), z);
  }
  return ring;
}

HeadPart make_ball_part(const std::string& name, const std::string& material) {
  HeadPart part;
  part.part.name = name;
  part.part.material = material;
  part.part.is_rigid = true;
  part.mount = Mount::eye_left;
  return part;
}

void move_into_head(Mesh& mesh, const EyeFrame& frame) {
  for (glm::vec3& p : mesh.positions) p = glm::vec3(frame.head_from_eye * glm::vec4(p, 1));
  for (glm::vec3& n : mesh.normals) n = glm::normalize(glm::vec3(frame.head_from_eye * glm::vec4(n, 0)));
}

// 1 under the upper lid, 0 in the open. The ball is painted so once, looking ahead.
double compute_lid_shadow(double up_mm) { return smooth_step(1.2, 5.4, up_mm); }
constexpr float kLidShadow = 0.46f;    // share of the light that is kept off
constexpr double kLowerShadow = 0.35;  // of that, above the lower lid

// The iris lies deeper, in the shadow from its middle on. Shares of the way from a palette's darkest fibre to
// its brightest: the plain one in the open, how far fibres go to either side of it, and the whole shadow.
double compute_iris_shadow(double up_mm) { return smooth_step(-0.4, 4.6, up_mm); }
constexpr double kIrisOpen = 0.68, kIrisFibres = 0.32, kIrisShadow = 0.62;

double sphere_z(double ball, double radius) {
  return std::sqrt(std::max(0.0, ball * ball - radius * radius));
}

// Warm white, pinker where it turns toward the corners, bluish-grey where it meets the iris, and darker
// above, where lid and lashes keep the light off it.
constexpr int kLimbusSteps = 6, kCornerSteps = 8, kLidSteps = 5;

std::vector<Shade> make_sclera_palette() {
  const glm::vec3 white(0.86f, 0.825f, 0.80f), pink(0.77f, 0.52f, 0.47f), grey(0.36f, 0.37f, 0.40f);
  std::vector<Shade> palette;
  for (int limbus = 0; limbus < kLimbusSteps; ++limbus)
    for (int corner = 0; corner < kCornerSteps; ++corner)
      for (int lid = 0; lid < kLidSteps; ++lid) {
        const glm::vec3 base = glm::mix(white, pink, static_cast<float>(corner) / (kCornerSteps - 1));
        const glm::vec3 lit = base * (1 - kLidShadow * static_cast<float>(lid) / (kLidSteps - 1));
        palette.push_back(
            {glm::mix(lit, grey, 0.8f * static_cast<float>(limbus) / (kLimbusSteps - 1)), 0.7f});
      }
  return palette;
}

HeadPart build_sclera(const EyeFrame& frame) {
  const EyeNumbers& eye = frame.numbers;
  HeadPart part = make_ball_part("eye_left", "sclera");
  const double floor = eye.iris_edge_mm[1] - 0.25, rim = std::asin(eye.limbus_mm / eye.ball_mm);
  std::vector<Ring> rings{
      make_circle(eye.limbus_mm - 0.12, floor, kScleraSpokes),
      make_circle(eye.limbus_mm - 0.06, sphere_z(eye.ball_mm, eye.limbus_mm) - 0.1, kScleraSpokes)};
  constexpr int kRows = 17;
  for (int i = 0; i < kRows; ++i) {
    const double angle = rim + (kPi - rim) * std::pow(static_cast<double>(i) / kRows, 1.7);
    rings.push_back(make_circle(eye.ball_mm * std::sin(angle), eye.ball_mm * std::cos(angle), kScleraSpokes));
  }
  // From front to back, so the circles run clockwise seen from the end: turn them round.
  for (Ring& ring : rings) std::reverse(ring.begin() + 1, ring.end());
  Mesh& mesh = part.part.rest;
  append_loft(mesh, {0, 0, floor}, rings, {0, 0, -eye.ball_mm});
  update_normals(mesh);

  part.part.palette = make_sclera_palette();
  for (const glm::vec3& p : mesh.positions) {
    const double radius = std::hypot(p.x, p.y);
    const double limbus = p.z > 0 ? 1 - smooth_step(eye.limbus_mm - 0.1, eye.limbus_mm + 1.3, radius) : 0;
    const double corner = smooth_step(0.5, 0.95, std::abs(p.x) / eye.ball_mm);
    const double lid = std::max(compute_lid_shadow(p.y), kLowerShadow * compute_lid_shadow(-p.y));
    const auto row = std::lround(limbus * (kLimbusSteps - 1)),
               column = std::lround(corner * (kCornerSteps - 1));
    part.part.shade.push_back(static_cast<std::uint16_t>((row * kCornerSteps + column) * kLidSteps +
                                                         std::lround(lid * (kLidSteps - 1))));
  }
  move_into_head(mesh, frame);
  return part;
}

// The iris at `share` of the way from the pupil to the white: a dark ruff, a warm bright wreath (the
// collarette), the plain colour, a dark limbal ring.
glm::vec3 compute_iris_colour(const glm::vec3& iris, double share) {
  static const std::vector<double> at{0, 0.05, 0.16, 0.27, 0.40, 0.68, 0.82, 0.92, 1.0};
  static const std::vector<double> brightness{0.22, 0.60, 0.94, 1.12, 0.98, 0.90, 0.68, 0.40, 0.26};
  const float grey = glm::dot(iris, glm::vec3(0.30f, 0.59f, 0.11f));
  const glm::vec3 warm = glm::vec3(1.25f, 0.95f, 0.58f) * (0.85f * grey + 0.06f);
  const auto warmth = static_cast<float>(0.6 * (1 - smooth_step(0.10, 0.36, share)));
  const glm::vec3 colour =
      glm::mix(iris, warm, warmth) * static_cast<float>(sample_stations(at, brightness, share));
  return glm::clamp(colour, 0.0f, 1.0f);
}

std::vector<Shade> make_iris_palette(const glm::vec3& iris) {
  std::vector<Shade> palette;
  for (int row = 0; row < kIrisRows; ++row)
    for (int level = 0; level < kIrisLevels; ++level) {
      const float fibre = 0.36f + 0.94f * static_cast<float>(level) / (kIrisLevels - 1);
      const glm::vec3 colour = compute_iris_colour(iris, static_cast<double>(row) / (kIrisRows - 1));
      palette.push_back({glm::clamp(colour * fibre, 0.0f, 1.0f), 0.15f});
    }
  palette.push_back({glm::vec3(0.012f), 0.0f});  // the pupil
  return palette;
}

// Fibres: streaks that waver a little, strongest in the middle of their way; a few broad light and dark
// sectors.
std::uint16_t compute_iris_shade(double turn, double share, double up_mm, int fibres) {
  const double cells = turn * fibres;
  const double waver = 0.45 * sample_noise(11, 4 * share, 64) + 0.3 * sample_noise(12, 9 * turn, 9);
  const double streak =
      0.62 * sample_noise(1, cells + waver, fibres) + 0.42 * sample_noise(2, 2 * cells, 2 * fibres);
  const double sector = 0.35 * sample_noise(3, turn * 7, 7);
  const double envelope = 0.45 + 0.55 * std::sin(kPi * std::clamp(share, 0.0, 1.0));
  const double fibre = kIrisFibres * std::clamp(streak * envelope + sector, -1.0, 1.0);
  const double level = std::clamp(kIrisOpen + fibre - kIrisShadow * compute_iris_shadow(up_mm), 0.0, 1.0);
  const double wreath = 0.05 * sample_noise(4, turn * 23, 23) * (1 - smooth_step(0.4, 0.7, share));
  const auto row = std::lround(std::clamp(share + wreath, 0.0, 1.0) * (kIrisRows - 1));
  return static_cast<std::uint16_t>(row * kIrisLevels + std::lround(level * (kIrisLevels - 1)));
}

HeadPart build_iris(const EyeFrame& frame, const glm::vec3& colour) {
  const EyeNumbers& eye = frame.numbers;
  HeadPart part = make_ball_part("iris_left", "iris");
  part.part.palette = make_iris_palette(colour);
  const auto black = static_cast<std::uint16_t>(part.part.palette.size() - 1);
  const auto [edge, edge_z] = eye.iris_edge_mm;
  const auto [inner, inner_z] = eye.iris_inner_mm;

  std::vector<Ring> rings{make_circle(inner - 0.10, eye.pupil_floor_mm, kIrisSpokes),
                          make_circle(inner - 0.05, inner_z - 0.06, kIrisSpokes)};
  part.part.shade.assign(1 + 2 * kIrisSpokes, black);
  for (int i = 0; i < kIrisRings; ++i) {
    const double way = static_cast<double>(i) / (kIrisRings - 1);
    const double radius = inner + (edge - inner) * way;
    rings.push_back(make_circle(radius, inner_z + (edge_z - inner_z) * way, kIrisSpokes));
    const double share = (radius - inner) / (eye.limbus_mm - inner);
    for (int k = 0; k < kIrisSpokes; ++k)
      part.part.shade.push_back(
          compute_iris_shade(static_cast<double>(k) / kIrisSpokes, share, rings.back()[k].y, eye.fibres));
  }
  part.part.shade.push_back(black);  // the hidden back
  for (Ring& ring : rings) std::reverse(ring.begin() + 1, ring.end());
  for (std::size_t first = 1; first + kIrisSpokes < part.part.shade.size(); first += kIrisSpokes)
    std::reverse(part.part.shade.begin() + first + 1, part.part.shade.begin() + first + kIrisSpokes);

  Mesh& mesh = part.part.rest;
  append_loft(mesh, {0, 0, eye.pupil_floor_mm}, rings, {0, 0, edge_z - 0.3});
  // Lit from above the cone is shaded as if it were a bowl: the cornea throws light across, so that the lower
  // half is the brighter one. Sideways it stays a cone: a normal that points away from the camera would be
  // black in profile.
  for (const glm::vec3& p : mesh.positions)
    mesh.normals.push_back(glm::normalize(glm::vec3(0.05f * p.x, -0.075f * p.y, 1)));
  move_into_head(mesh, frame);
  return part;
}

// A clear cap on the ball, highest over the pupil, that runs out smoothly on the white.
HeadPart build_cornea(const EyeFrame& frame) {
  const EyeNumbers& eye = frame.numbers;
  HeadPart part = make_ball_part("cornea_left", "cornea");
  part.part.is_printed = false;
  part.part.palette = {{glm::vec3(1), 1.0f}};
  Mesh& mesh = part.part.rest;
  constexpr int kSpokes = 40, kRings = 11;
  mesh.positions.emplace_back(0, 0, eye.ball_mm + eye.cornea_rise_mm);
  for (int r = 1; r <= kRings; ++r) {
    const double share = static_cast<double>(r) / kRings, radius = eye.cornea_edge_mm * share;
    const double rise = eye.cornea_rise_mm * std::pow(1 - share * share, kCorneaSwell) + kCorneaLift_mm;
    const Ring ring = make_circle(radius, sphere_z(eye.ball_mm, radius) + rise, kSpokes);
    mesh.positions.insert(mesh.positions.end(), ring.begin(), ring.end());
  }
  const auto vertex = [](int ring, int k) {
    return static_cast<std::uint32_t>(1 + (ring - 1) * kSpokes + k % kSpokes);
  };
  for (int k = 0; k < kSpokes; ++k) {
    mesh.triangles.push_back({0, vertex(1, k), vertex(1, k + 1)});
    for (int r = 1; r < kRings; ++r) {
      mesh.triangles.push_back({vertex(r, k), vertex(r + 1, k), vertex(r + 1, k + 1)});
      mesh.triangles.push_back({vertex(r, k), vertex(r + 1, k + 1), vertex(r, k + 1)});
    }
  }
  update_normals(mesh);
  move_into_head(mesh, frame);
  return part;
}

}  // namespace

std::vector<HeadPart> build_eyes(const NeutralHead& head, const Look& look) {
  const EyeNumbers& eye = head.data->parts.eye;
  const Lids lids = build_lids(head, eye.ball_mm);
  const auto turn = static_cast<float>(eye.outward_deg * kPi / 180);
  EyeFrame frame{glm::translate(glm::mat4(1), lids.centre), eye};
  frame.head_from_eye = glm::rotate(frame.head_from_eye, turn, glm::vec3(0, 1, 0));
  frame.head_from_eye = glm::scale(frame.head_from_eye, glm::vec3(static_cast<float>(lids.scale)));

  std::vector<HeadPart> parts;
  parts.push_back(build_sclera(frame));
  parts.push_back(build_iris(frame, look.iris));
  parts.push_back(build_cornea(frame));
  parts.push_back(build_tear(lids, eye.tear));
  parts.push_back(build_caruncle(lids, eye));
  const std::vector<HeadPart> right = mirror_parts(parts, head.skin);
  parts.insert(parts.end(), right.begin(), right.end());
  return parts;
}

}  // namespace mien

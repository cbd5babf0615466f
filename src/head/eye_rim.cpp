#include "head/eye_rim.hpp"

#include <cmath>
#include <numbers>

#include "head/tubes.hpp"

namespace mien {

namespace {

constexpr double kPi = std::numbers::pi;

// One knob of pink flesh on the ball, `mix` of the way from the inner corner to where the lids begin to part.
void append_knob(Mesh& mesh, const Lids& lids, const KnobNumbers& knob) {
  const glm::vec3 corner = compute_on_margin(lids, 0, 0);
  const glm::vec3 parted = (compute_on_margin(lids, 1, 0) + compute_on_margin(lids, 15, 0)) * 0.5f;
  const glm::vec3 at = glm::mix(corner, parted, static_cast<float>(knob.mix));
  const glm::vec3 out = glm::normalize(at - lids.centre);
  const glm::vec3 up = glm::normalize(compute_on_margin(lids, 1, 0) - compute_on_margin(lids, 15, 0));
  const glm::vec3 along = glm::normalize(glm::cross(up, out)), over = glm::cross(out, along);
  const auto scale = static_cast<float>(lids.scale);
  const glm::vec3 centre = lids.centre + out * (lids.radius_mm - scale * static_cast<float>(knob.sink_mm));
  const glm::vec3 half = scale * glm::vec3(knob.half_mm[0], knob.half_mm[1], knob.half_mm[2]);
  constexpr int kSpokes = 14, kRings = 7;
  std::vector<Ring> rings;
  for (int r = 1; r <= kRings; ++r) {
    const double angle = kPi * r / (kRings + 1);
    Ring ring;
    for (int k = 0; k < kSpokes; ++k) {
      const double turn = 2 * kPi * k / kSpokes;
      const glm::vec3 ball(std::cos(turn) * std::sin(angle), std::sin(turn) * std::sin(angle),
                           -std::cos(angle));
      ring.push_back(centre + along * (half.x * ball.x) + over * (half.y * ball.y) + out * (half.z * ball.z));
    }
    rings.push_back(ring);
  }
  append_loft(mesh, centre - out * half.z, rings, centre + out * half.z);
}

}  // namespace

HeadPart build_tear(const Lids& lids, const TearNumbers& tear) {
  HeadPart part;
  part.part.name = "tear_left";
  part.part.material = "tear";
  part.part.is_printed = false;
  part.part.palette = {{glm::vec3(0.95f, 0.93f, 0.92f), 1.0f}};
  part.mount = Mount::strands;
  const auto scale = static_cast<float>(lids.scale);
  const auto centre_at = [&](double t) {
    const glm::vec3 out = glm::normalize(compute_on_margin(lids, t, tear.mix) - lids.centre);
    return lids.centre + out * (lids.radius_mm + scale * static_cast<float>(tear.above_mm));
  };
  constexpr int kSides = 5;
  std::vector<Ring> rings;
  for (int i = 0; i < tear.rings; ++i) {
    const double way = static_cast<double>(i) / (tear.rings - 1),
                 t = tear.first + (tear.last - tear.first) * way;
    const glm::vec3 centre = centre_at(t), out = glm::normalize(centre - lids.centre);
    const glm::vec3 along = glm::normalize(centre_at(t + 0.05) - centre_at(t - 0.05));
    const glm::vec3 side = glm::cross(along, out);
    const auto radius = static_cast<float>(tear.radius_mm * lids.scale * (0.25 + 0.75 * std::sin(kPi * way)));
    Ring ring;
    for (int k = 0; k < kSides; ++k) {
      const auto turn = static_cast<float>(2 * kPi * k / kSides);
      ring.push_back(centre + radius * (std::cos(turn) * out + std::sin(turn) * side));
    }
    rings.push_back(ring);
  }
  append_loft(part.part.rest, centre_at(tear.first - 0.1), rings, centre_at(tear.last + 0.1));
  update_normals(part.part.rest);
  for (int i = 0; i < tear.rings; ++i) {
    const double t = tear.first + (tear.last - tear.first) * i / (tear.rings - 1);
    const SkinPlace place = find_nearest_place(lids.patch, compute_on_margin(lids, t, tear.mix));
    const bool is_end = i == 0 || i == tear.rings - 1;
    const std::uint32_t first = i == 0 ? 0 : static_cast<std::uint32_t>(1 + i * kSides);
    part.bindings.push_back(
        {place.triangle, place.barycentric, first, static_cast<std::uint32_t>(kSides + is_end)});
  }
  return part;
}

HeadPart build_caruncle(const Lids& lids, const EyeNumbers& eye) {
  HeadPart part;
  part.part.name = "caruncle_left";
  part.part.material = "caruncle";
  part.part.palette = {{glm::vec3(0.80f, 0.50f, 0.46f), 0.6f}, {glm::vec3(0.85f, 0.64f, 0.60f), 0.6f}};
  part.mount = Mount::strands;
  append_knob(part.part.rest, lids, eye.caruncle);
  part.part.shade.assign(part.part.rest.positions.size(), 0);
  append_knob(part.part.rest, lids, eye.plica);
  part.part.shade.resize(part.part.rest.positions.size(), 1);
  update_normals(part.part.rest);
  const SkinPlace place = find_nearest_place(lids.patch, compute_on_margin(lids, 0, 0));
  part.bindings = {
      {place.triangle, place.barycentric, 0, static_cast<std::uint32_t>(part.part.rest.positions.size())}};
  return part;
}

}  // namespace mien

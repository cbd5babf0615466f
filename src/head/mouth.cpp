// The mouth: two rows of teeth fitted behind the lips of one head, their gums, and a tongue at rest.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "head/binding.hpp"
#include "head/dental_arch.hpp"
#include "head/head.hpp"
#include "head/lids.hpp"
#include "head/part_numbers.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

constexpr double kBareHalf_mm = 16, kBareHeight_mm = 4.5;  // of what lips bare, from the middle of their line

double square(double value) { return value * value; }

// A low dome from the throat to behind the lower teeth, with a shallow groove along its middle.
HeadPart build_tongue(const DentalArch& arch) {
  const TongueNumbers& tongue = arch.numbers.tongue;
  const double scale = arch.scale;
  const double tip_z = arch.front_z_mm - scale * (arch.numbers.lower.inset_mm + tongue.tip_mm);
  const double top_y = arch.lips_y_mm - scale * tongue.top_mm, low_y = top_y - 7.0 * scale;
  constexpr int kTongueShades = 8, kRings = 16,
                kHalf = 10;  // points of half a ring, from the top to the bottom
  HeadPart part;
  std::vector<Ring> rings;
  const std::size_t sides = 2 * kHalf - 2;
  part.part.shade.push_back(kTongueShades - 1);
  for (int r = 0; r < kRings; ++r) {
    const double way = static_cast<double>(r) / (kRings - 1),
                 from_tip_mm = (1 - way) * (1 - way) * tongue.back_mm + 0.3;
    const double round = std::sqrt(1 - std::exp(-from_tip_mm / 4.5));
    const double z = tip_z - scale * from_tip_mm, half = scale * tongue.half_mm * round;
    const double dome = top_y + scale * (1.8 * smooth_step(0, 18, from_tip_mm) - 2.6 * (1 - round));
    Ring ring;
    for (int k = 0; k < kHalf; ++k) {
      const double turn = std::numbers::pi * k / (kHalf - 1), side = std::sin(turn), up = std::cos(turn);
      const double groove = 0.8 * scale * std::exp(-square(3.2 * side)) * std::max(0.0, up) * round;
      const double middle = 0.5 * (dome + low_y), reach = 0.5 * (dome - low_y) * round;
      ring.emplace_back(k == kHalf - 1 ? 0 : half * side, middle + reach * up - groove, z);
    }
    for (int k = kHalf - 2; k > 0; --k) ring.emplace_back(-ring[k].x, ring[k].y, ring[k].z);
    std::reverse(ring.begin() + 1, ring.end());  // counter-clockwise seen from the tip
    rings.push_back(ring);
    part.part.shade.insert(part.part.shade.end(), sides,
                           static_cast<std::uint16_t>(std::lround((kTongueShades - 1) * (1 - way))));
  }
  part.part.shade.push_back(0);
  Mesh& mesh = part.part.rest;
  append_loft(mesh, find_middle(rings.front()), rings,
              find_middle(rings.back()) + glm::vec3(0, 0, 0.25f * scale));
  for (glm::vec3* end : {&mesh.positions.front(), &mesh.positions.back()}) end->x = 0;
  update_normals(mesh);
  part.part.name = "tongue";
  part.part.material = "tongue";
  for (int i = 0; i < kTongueShades; ++i) {
    const float back = static_cast<float>(i) / (kTongueShades - 1);
    part.part.palette.push_back(
        {glm::mix(glm::vec3(0.76f, 0.43f, 0.42f), glm::vec3(0.34f, 0.15f, 0.15f), back), 0.6f});
  }
  part.part.is_rigid = true;
  part.mount = Mount::jaw;
  return part;
}

DentalArch fit_arch(const NeutralHead& head, const MouthNumbers& numbers) {
  DentalArch arch{numbers};
  const glm::vec3 middle = find_named_point(head, "M0_0"), side = find_named_point(head, "M0_4");
  arch.scale = find_named_point(head, "M1_6").x / numbers.corner_mm;
  arch.lips_y_mm = 0.5 * (find_named_point(head, "M1_0").y + find_named_point(head, "M1_12").y);
  arch.curve = (middle.z - side.z) / (side.x * side.x);
  arch.front_z_mm = middle.z - arch.scale * numbers.setback_mm;
  arch.growth = smooth_step(numbers.grown_mm[0], numbers.grown_mm[1], find_eye_to_chin_mm(head));
  return arch;
}

// How far a row comes too near to the back of the lips, mm. Only its bare part counts: toward the fold above
// and below, and in the cheeks, gum and flesh are one.
double find_intrusion_mm(const Mesh& row, const DentalArch& arch, const SkinPatch& lips) {
  double intrusion = 0;
  for (const glm::vec3& p : row.positions) {
    if (p.x < 0 || p.x > arch.scale * kBareHalf_mm ||
        std::abs(p.y - arch.lips_y_mm) > arch.scale * kBareHeight_mm)
      continue;
    const SkinPlace place = find_nearest_place(lips, p);
    const double free_mm = glm::dot(p - place.point, place.normal);
    intrusion = std::max(intrusion, arch.scale * arch.numbers.clearance_mm - free_mm);
  }
  return intrusion;
}

// Moves both rows back until the lips have room.
void make_room_for_lips(const NeutralHead& head, DentalArch& arch, const TeethRow& upper,
                        const TeethRow& lower) {
  const auto reach = static_cast<float>(arch.scale * arch.numbers.upper.half_mm);
  const glm::vec3 middle = find_named_point(head, "M0_0");
  const SkinPatch lips = build_skin_patch(head.skin, {middle - glm::vec3(2, reach, reach), middle + reach});
  for (int pass = 0; pass < 4; ++pass) {
    const Mesh teeth_above = build_teeth(arch, upper).part.rest;
    const Mesh teeth_below = build_teeth(arch, lower).part.rest;
    const double intrusion =
        std::max(find_intrusion_mm(teeth_above, arch, lips), find_intrusion_mm(teeth_below, arch, lips));
    if (intrusion < 0.01) return;
    arch.front_z_mm -= intrusion;
  }
}

}  // namespace

std::vector<HeadPart> build_mouth(const NeutralHead& head, const Look&) {
  const MouthNumbers numbers = load_part_numbers().mouth;
  DentalArch arch = fit_arch(head, numbers);
  const TeethRow upper{numbers.upper, 1}, lower{numbers.lower, -1};
  make_room_for_lips(head, arch, upper, lower);

  std::vector<HeadPart> parts;
  for (const TeethRow& row : {upper, lower}) {
    parts.push_back(build_teeth(arch, row));
    parts.push_back(build_gum(arch, row));
  }
  parts.push_back(build_tongue(arch));
  return parts;
}

}  // namespace mien

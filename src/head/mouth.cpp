// The mouth: two rows of teeth fitted behind the lips of one head, and their gums and tongue.
#include <algorithm>
#include <cmath>

#include "config/part_numbers.hpp"
#include "head/binding.hpp"
#include "head/dental_arch.hpp"
#include "head/head.hpp"
#include "head/lids.hpp"
#include "head/skin_look.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

constexpr double kBareHalf_mm = 16, kBareHeight_mm = 4.5;  // of what lips bare, from the middle of their line

// How old a head is: by its ages' names, or, if a scan does not say, by its size.
double compute_years(const NeutralHead& head, const MouthNumbers& numbers) {
  constexpr double kGrown = 20;
  if (head.ages.empty()) {
    std::vector<double> sizes_mm, years;
    for (const auto& [size_mm, age] : numbers.scan_years) {
      sizes_mm.push_back(size_mm);
      years.push_back(age);
    }
    return sample_stations(sizes_mm, years, compute_eye_to_chin_mm(head));
  }
  double sum = 0, weight = 0;
  for (const auto& [name, share] : head.ages) {
    const auto known = numbers.years.find(name);
    sum += share * (known == numbers.years.end() ? kGrown : known->second);
    weight += share;
  }
  return sum / weight;
}

DentalArch fit_arch(const NeutralHead& head, const MouthNumbers& numbers) {
  DentalArch arch{numbers};
  const glm::vec3 middle = find_named_point(head, "M0_0"), side = find_named_point(head, "M0_4");
  arch.scale = find_named_point(head, "M1_6").x / numbers.corner_mm;
  arch.lips_y_mm = 0.5 * (find_named_point(head, "M1_0").y + find_named_point(head, "M1_12").y);
  arch.front_z_mm = middle.z - arch.scale * numbers.setback_mm;
  arch.years = compute_years(head, numbers);
  arch.depth_mm = arch.scale * numbers.arch.depth_mm;
  // The superellipse that goes back by as much as the lips where they begin to turn.
  const double square = numbers.arch.square;
  const double rest = std::clamp(1 - (middle.z - side.z) / arch.depth_mm, 0.05, 0.99);
  const double half_mm = side.x / std::pow(1 - std::pow(rest, square), 1 / square);
  arch.half_mm =
      std::clamp(half_mm, arch.scale * numbers.arch.half_mm[0], arch.scale * numbers.arch.half_mm[1]);
  return arch;
}

// How far a row comes too near to the back of the lips, mm. Only its bare part counts: toward the fold above
// and below, and in the cheeks, gum and flesh are one.
double compute_intrusion_mm(const Mesh& row, const DentalArch& arch, const SkinPatch& lips) {
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
  const auto reach = static_cast<float>(arch.half_mm);
  const glm::vec3 middle = find_named_point(head, "M0_0");
  const SkinPatch lips = build_skin_patch(head.skin, {middle - glm::vec3(2, reach, reach), middle + reach});
  for (int pass = 0; pass < 4; ++pass) {
    const Mesh teeth_above = build_teeth(arch, upper).part.rest;
    const Mesh teeth_below = build_teeth(arch, lower).part.rest;
    const double intrusion = std::max(compute_intrusion_mm(teeth_above, arch, lips),
                                      compute_intrusion_mm(teeth_below, arch, lips));
    if (intrusion < 0.01) return;
    arch.front_z_mm -= intrusion;
  }
}

std::vector<HeadPart> build_parts(const NeutralHead& head, const glm::vec3& lip_srgb,
                                  HeadPart (*build_upper)(const DentalArch&, const TeethRow&)) {
  const MouthNumbers& numbers = head.data->parts.mouth;
  DentalArch arch = fit_arch(head, numbers);
  const TeethRow upper{numbers.upper, 1}, lower{numbers.lower, -1};
  make_room_for_lips(head, arch, upper, lower);

  std::vector<HeadPart> parts;
  for (const TeethRow& row : {upper, lower}) {
    parts.push_back(row.sign > 0 ? build_upper(arch, row) : build_teeth(arch, row));
    parts.push_back(build_gum(arch, row));
  }
  parts.push_back(build_tongue(arch));
  parts.push_back(build_lip_veil(head, arch.scale, lip_srgb));
  return parts;
}

}  // namespace

std::vector<HeadPart> build_mouth(const NeutralHead& head, const Look& look) {
  return build_parts(head, compute_inner_lip_srgb(look), build_teeth);
}

std::vector<HeadPart> build_drawn_mouth(const NeutralHead& head) {
  return build_parts(head, compute_inner_lip_srgb(Look{}), build_teeth_band);
}

}  // namespace mien

// A tongue at rest: its tip behind the lower teeth, round sides, a groove along its middle, its back rising
// toward the palate. It fills the lower arch but for a little room.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/smooth.hpp"
#include "head/dental_arch.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

constexpr int kDepthShades = 20, kGrooveShades = 4;
constexpr int kRings = kTongueRings,
              kHalf = kTonguePoints / 2 + 1;  // points of half a ring, from the top to the bottom
constexpr double kThick_mm = 9;               // of its sides; its underside is never seen
constexpr double kTip_mm = 11;                // over which it grows from its tip to its full width

double square(double value) { return value * value; }

// Half the free way between the lower teeth at a way behind the upper row's front, mm.
double compute_room_mm(const DentalArch& arch, double behind_mm) {
  const MouthNumbers& numbers = arch.numbers;
  const TeethRowNumbers& row = numbers.lower;
  const double inset = arch.scale * row.inset_mm, share = std::clamp(behind_mm / arch.depth_mm, 0.0, 1.0);
  const double thick = row.thick_mm[2] + (row.thick_mm[5] - row.thick_mm[2]) * smooth_step(0.2, 0.6, share);
  return compute_arch_half_mm(arch, behind_mm) - inset - arch.scale * (thick + numbers.tongue.room_mm);
}

}  // namespace

HeadPart build_tongue(const DentalArch& arch) {
  const TongueNumbers& tongue = arch.numbers.tongue;
  const double scale = arch.scale;
  const double tip_mm =
      scale * (arch.numbers.lower.inset_mm + tongue.tip_mm);  // behind the upper row's front
  const double top_y = arch.lips_y_mm - scale * tongue.top_mm;
  HeadPart part;
  std::vector<Ring> rings;
  const auto find_shade = [](double way, double groove) {
    return static_cast<std::uint16_t>(std::lround((kDepthShades - 1) * way) * kGrooveShades +
                                      std::lround((kGrooveShades - 1) * groove));
  };
  part.part.shade.push_back(find_shade(1, 0));
  for (int r = 0; r < kRings; ++r) {
    const double way = 1 - static_cast<double>(r) / (kRings - 1);  // 1 at the throat, 0 at the tip
    const double from_tip_mm = way * way * tongue.back_mm + 0.25;
    const double behind_mm = tip_mm + scale * from_tip_mm;
    const double tip = std::clamp(from_tip_mm / kTip_mm, 0.0, 1.0);
    const double round = std::sqrt(1 - square(1 - tip));  // a quarter of a circle
    const double widest =
        std::min(scale * tongue.half_mm, std::max(compute_room_mm(arch, behind_mm), 3 * scale));
    const double free = std::min(1.0, 0.8 + 0.2 * smooth_step(0, 16, from_tip_mm));
    const double half = widest * round * free;
    const double rise =
        tongue.rise_mm * smooth_step(2, 26, from_tip_mm) - 5 * smooth_step(28, tongue.back_mm, from_tip_mm);
    const double high = top_y + scale * rise - scale * 2.6 * (1 - round);
    const double low = top_y + scale * (std::max(0.0, rise) * 0.5 - kThick_mm);
    const double middle = 0.5 * (high + low), reach = 0.5 * (high - low) * std::max(round, 0.25);
    Ring ring;
    std::vector<std::uint16_t> shades;
    for (int k = 0; k < kHalf; ++k) {
      const double turn = std::numbers::pi * k / (kHalf - 1);
      // Flatter above than a circle, and fuller at the sides.
      const double side = std::pow(std::sin(turn), 0.62), up = std::cos(turn);
      const double lift = up > 0 ? std::pow(up, 0.75) : up;
      const double groove =
          std::exp(-square(4.2 * side)) * std::max(0.0, up) * smooth_step(2, 10, from_tip_mm);
      ring.emplace_back(k == 0 || k == kHalf - 1 ? 0 : half * side,
                        middle + reach * lift - 1.3 * scale * groove, arch.front_z_mm - behind_mm);
      shades.push_back(find_shade(smooth_step(0.25, 1, way), groove));
    }
    for (int k = kHalf - 2; k > 0; --k) {
      ring.emplace_back(-ring[k].x, ring[k].y, ring[k].z);
      shades.push_back(shades[k]);
    }
    std::reverse(ring.begin() + 1, ring.end());  // counter-clockwise seen from the tip
    std::reverse(shades.begin() + 1, shades.end());
    rings.push_back(ring);
    part.part.shade.insert(part.part.shade.end(), shades.begin(), shades.end());
  }
  part.part.shade.push_back(find_shade(0, 0));
  Mesh& mesh = part.part.rest;
  append_loft(mesh, compute_middle(rings.front()), rings,
              compute_middle(rings.back()) + glm::vec3(0, 0, 0.25f * scale));
  for (glm::vec3* end : {&mesh.positions.front(), &mesh.positions.back()}) end->x = 0;
  update_normals(mesh);
  part.part.name = "tongue";
  part.part.material = "tongue";
  const glm::vec3 front(0.80f, 0.46f, 0.45f), back(0.30f, 0.11f, 0.11f);
  for (int depth = 0; depth < kDepthShades; ++depth)
    for (int groove = 0; groove < kGrooveShades; ++groove) {
      const float far = static_cast<float>(depth) / (kDepthShades - 1);
      part.part.palette.push_back(
          {glm::mix(front, back, far) * (1 - 0.14f * static_cast<float>(groove) / (kGrooveShades - 1)),
           0.7f});
    }
  part.part.is_rigid = part.part.may_bend = true;
  part.mount = Mount::jaw;
  return part;
}

}  // namespace mien

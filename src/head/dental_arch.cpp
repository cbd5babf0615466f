// The arch has the lips' own curve, which is flatter than a dental arch, so that the far teeth still show in
// a smile. Widths of teeth: Wheeler, "Dental Anatomy".
#include "head/dental_arch.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "head/tubes.hpp"

namespace mien {

namespace {

double find_arch_depth(const DentalArch& arch, double x) {
  const double beyond = std::max(0.0, x - arch.scale * arch.numbers.bend_from_mm);
  return arch.curve * x * x + arch.numbers.bend / (arch.scale * arch.scale) * beyond * beyond * beyond;
}

struct ArchPoint {
  double x = 0, length_mm = 0;
};

std::vector<ArchPoint> measure_arch(const DentalArch& arch, double half_mm) {
  constexpr int kSteps = 160;
  std::vector<ArchPoint> points{{0, 0}};
  for (int i = 1; i <= kSteps; ++i) {
    const double x = arch.scale * half_mm * i / kSteps;
    const double run = x - points.back().x,
                 fall = find_arch_depth(arch, x) - find_arch_depth(arch, points.back().x);
    points.push_back({x, points.back().length_mm + std::hypot(run, fall)});
  }
  return points;
}

double find_arch_x(const std::vector<ArchPoint>& points, double length_mm) {
  std::size_t next = 1;
  while (next + 1 < points.size() && points[next].length_mm < length_mm) ++next;
  const ArchPoint &a = points[next - 1], &b = points[next];
  return a.x + (b.x - a.x) * (length_mm - a.length_mm) / (b.length_mm - a.length_mm);
}

}  // namespace

std::vector<ToothCut> cut_row(const DentalArch& arch, const TeethRow& row) {
  static constexpr std::array kCuts{0.0, 0.05, 0.14, 0.3, 0.5, 0.7, 0.86, 0.95};
  const std::vector<ArchPoint> points = measure_arch(arch, row.numbers.half_mm);
  // Cuts are counted along the adult's row and stretched onto this one: every head has as many.
  const double end_mm = row.numbers.row_mm, stretch = points.back().length_mm / end_mm;
  const auto& widths = arch.numbers.widths_mm;
  const auto& rises = arch.numbers.rise_mm;
  std::vector<ToothCut> cuts;
  double from_mm = 0;
  for (std::size_t tooth = 0; from_mm < end_mm; ++tooth) {
    const std::size_t kind = std::min(tooth, widths.size() - 1);
    const double width_mm = widths[kind] * row.numbers.width;
    for (const double at : kCuts) {
      const double length_mm = from_mm + at * width_mm;
      if (length_mm > end_mm) break;
      const double x = find_arch_x(points, stretch * length_mm), step = 0.05;
      const double slope = (find_arch_depth(arch, x + step) - find_arch_depth(arch, x - step)) / (2 * step);
      ToothCut cut;
      cut.at = glm::vec2(x, -find_arch_depth(arch, x));
      cut.out = glm::normalize(glm::vec2(x > 0 ? slope : 0.0, 1));
      cut.share = length_mm / end_mm;
      const double side = std::min(at, 1 - at);
      const double plain = 1 - smooth_step(0.4, 0.75, cut.share);  // far teeth are one band
      cut.gap = plain * (1 - smooth_step(0, 0.2, side));
      cut.belly = plain * smooth_step(0, 0.5, side);
      const std::size_t other = at < 0.5 ? (kind > 0 ? kind - 1 : 0) : std::min(kind + 1, widths.size() - 1);
      const double near = 0.5 * (1 - smooth_step(0, 0.3, side));
      cut.rise_mm = arch.scale * ((1 - near) * rises[kind] + near * rises[other]);
      cuts.push_back(cut);
    }
    from_mm += width_mm;
  }
  return cuts;
}

glm::vec3 place_in_row(const DentalArch& arch, const TeethRow& row, const ToothCut& cut, double height_mm,
                       double out_mm) {
  const glm::vec2 flat = cut.at + cut.out * static_cast<float>(out_mm - arch.scale * row.numbers.inset_mm);
  return {flat.x, arch.lips_y_mm + row.sign * height_mm, arch.front_z_mm + flat.y};
}

double find_lean_mm(const DentalArch& arch, const TeethRow& row, double height_mm) {
  const TeethRowNumbers& teeth = row.numbers;
  const double share =
      std::max(0.0, (height_mm / arch.scale + teeth.edge_mm) / (teeth.gum_mm + teeth.edge_mm));
  return arch.scale * teeth.lean_mm * share * share;
}

}  // namespace mien

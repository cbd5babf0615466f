// A row's outside is a superellipse that begins with the lips' own curve. Widths, heights and years of teeth:
// Nelson, "Wheeler's Dental Anatomy, Physiology and Occlusion".
#include "head/dental_arch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/smooth.hpp"
#include "head/tubes.hpp"

namespace mien {

namespace {

// Out of the gum by `full` years, begun `growing` years before.
double compute_growth(double years, double full, double growing) {
  return smooth_step(full - growing, full, years);
}

// What stands in a place at an age.
struct Dentition {
  double grown = 1, milk = 0;
};

Dentition compute_dentition(const MouthNumbers& mouth, const TeethRowNumbers& row, std::size_t kind,
                            double years) {
  const double lasting = compute_growth(years, row.years[kind], mouth.growing_years[1]);
  if (kind >= kMilkTeeth) return {lasting, 0};
  constexpr double kFall_years =
      0.1;  // a tooth is out at once; longer than 0, so that a morph of ages does not jump
  const double there = 1 - smooth_step(row.shed_years[kind], row.shed_years[kind] + kFall_years, years);
  const double milk = compute_growth(years, row.milk_years[kind], mouth.growing_years[0]) * there;
  return {std::max(milk, lasting), there};
}

}  // namespace

ArchLine trace_arch(const DentalArch& arch, const TeethRow& row) {
  constexpr int kSteps = 240;  // a quarter of a millimetre each
  const double n = 2 / arch.numbers.arch.square, inset = arch.scale * row.numbers.inset_mm;
  const auto outside = [&](double turn) {
    return glm::dvec2(arch.half_mm * std::pow(std::sin(turn), n),
                      arch.depth_mm * (std::pow(std::cos(turn), n) - 1));
  };
  ArchLine line;
  for (int i = 0; i <= kSteps; ++i) {
    const double turn = 0.5 * std::numbers::pi * i / kSteps, step = 1e-4;
    const glm::dvec2 before = outside(std::max(turn - step, 0.0)),
                     after = outside(std::min(turn + step, 0.5 * std::numbers::pi));
    const glm::dvec2 along = i == 0 ? glm::dvec2(1, 0) : glm::normalize(after - before);
    const glm::dvec2 p = outside(turn) - inset * glm::dvec2(-along.y, along.x);
    const glm::vec2 point(i == 0 ? 0 : p.x, p.y);
    line.length_mm.push_back(i == 0 ? 0 : line.length_mm.back() + glm::distance(line.points.back(), point));
    line.points.push_back(point);
  }
  return line;
}

ArchPlace compute_arch_place(const ArchLine& line, double length_mm) {
  const auto above = std::upper_bound(line.length_mm.begin() + 1, line.length_mm.end() - 1, length_mm);
  const auto next = static_cast<std::size_t>(above - line.length_mm.begin());
  const double step = line.length_mm[next] - line.length_mm[next - 1];
  const auto share = static_cast<float>((length_mm - line.length_mm[next - 1]) / step);
  ArchPlace place;
  place.at = glm::mix(line.points[next - 1], line.points[next], share);  // goes on straight beyond the end
  const std::size_t from = next > 2 ? next - 3 : 0, to = std::min(next + 2, line.points.size() - 1);
  place.along = glm::normalize(line.points[to] - line.points[from]);
  if (length_mm <= 0) place.along = {1, 0};
  place.out = {-place.along.y, place.along.x};
  return place;
}

std::vector<Tooth> lay_teeth(const DentalArch& arch, const TeethRow& row, const ArchLine& line) {
  const MouthNumbers& mouth = arch.numbers;
  const TeethRowNumbers& numbers = row.numbers;
  std::vector<Tooth> teeth(kTeeth);
  double sum_mm = 0;
  for (std::size_t kind = 0; kind < kTeeth; ++kind) {
    Tooth& tooth = teeth[kind];
    const Dentition now = compute_dentition(mouth, numbers, kind, arch.years);
    tooth.kind = kind;
    tooth.grown = now.grown;
    tooth.milk = now.milk;
    tooth.free_mm = mouth.milk_space_mm * now.milk;
    const double small = kind < kMilkTeeth ? numbers.milk[kind] : 1;
    // What is not there yet has half its place: jaws grow at their far ends.
    const double place = kind < kMilkTeeth ? 1 : 0.4 + 0.6 * now.grown;
    tooth.width_mm = numbers.width_mm[kind] * place * (1 + (small - 1) * now.milk) + tooth.free_mm;
    sum_mm += tooth.width_mm;
  }
  const double stretch = line.length_mm.back() / sum_mm;
  double from_mm = 0;
  for (Tooth& tooth : teeth) {
    tooth.width_mm *= stretch;
    tooth.free_mm *= stretch;
    tooth.from_mm = from_mm;
    from_mm += tooth.width_mm;
    const double middle_mm = tooth.from_mm + 0.5 * tooth.width_mm;
    tooth.share = middle_mm / line.length_mm.back();
    tooth.place = compute_arch_place(line, middle_mm);
    const double edge = -numbers.edge_mm + numbers.rise_mm[tooth.kind];
    const double height =
        (numbers.gum_mm + numbers.neck_mm[tooth.kind] - edge) * (1 + (mouth.milk_height - 1) * tooth.milk);
    tooth.edge_mm = arch.scale * edge;
    tooth.neck_mm = arch.scale * (edge + height);
  }
  return teeth;
}

double compute_arch_half_mm(const DentalArch& arch, double behind_mm) {
  const double rest = 1 - std::clamp(behind_mm / arch.depth_mm, 0.0, 1.0);
  return arch.half_mm * std::pow(1 - std::pow(rest, arch.numbers.arch.square), 1 / arch.numbers.arch.square);
}

double compute_lean_mm(const DentalArch& arch, const TeethRow& row, double height_mm, double share) {
  constexpr double kUpright = 0.6;  // of the lean is gone at the row's end
  const TeethRowNumbers& teeth = row.numbers;
  const double up = std::max(0.0, (height_mm / arch.scale + teeth.edge_mm) / (teeth.gum_mm + teeth.edge_mm));
  return arch.scale * teeth.lean_mm * up * up * (1 - kUpright * share);
}

}  // namespace mien

#include "head/scan_frame.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace mien {

namespace {

[[noreturn]] void fail_scan(const Scan& scan, const std::string& message) {
  throw InputError(std::vector<Diagnostic>{{{scan.mesh.file, 0, 0}, message, "", false}});
}

}  // namespace

// Brings the marks' places together; complains if they are not a head's.
Similarity align_marks(const HeadStock& stock, const Scan& scan) {
  std::vector<glm::dvec3> ours, theirs;
  for (const ScanMark& mark : scan.marks) {
    ours.push_back(sample_row(mark.place, stock.adult.points));
    theirs.push_back(mark.at);
  }
  const auto find_misses = [&](const Similarity& similarity) {
    std::vector<double> misses;
    for (std::size_t i = 0; i < ours.size(); ++i)
      misses.push_back(glm::distance(apply_similarity(similarity, theirs[i]), ours[i]));
    return misses;
  };
  const Similarity similarity = fit_similarity(theirs, ours);
  if (!std::isfinite(similarity.scale) || similarity.scale <= 0)
    fail_scan(scan, "the landmarks lie in one place; expected them all over the head");
  const std::vector<double> misses = find_misses(similarity);
  const auto worst = std::ranges::max_element(misses) - misses.begin();
  constexpr double kMostMiss_mm = 30;  // an infant's landmarks miss by 12
  if (misses[worst] <= kMostMiss_mm) return similarity;
  // A mirrored head fits better if the sides were taken for each other.
  std::vector<glm::dvec3> swapped = ours;
  for (glm::dvec3& p : swapped) p.x = -p.x;
  std::swap(ours, swapped);
  const std::vector<double> mirrored = find_misses(fit_similarity(theirs, ours));
  if (*std::ranges::max_element(mirrored) < kMostMiss_mm)
    fail_scan(scan, "the landmarks' sides are swapped; expected _l on the character's own left");
  fail_scan(
      scan,
      fmt::format(
          "landmark '{}' is not where a head has it: {:.0f} mm off on a head of our size; expected {:.0f} "
          "at most",
          scan.marks[worst].name, misses[worst], kMostMiss_mm));
}

// How much larger the scanned head is than the one we wrapped, which was laid on the adult.
double compute_growth(const Scan& scan, double ours_per_unit) {
  const auto growth_of = [&](double unit_mm) { return unit_mm / ours_per_unit; };
  if (scan.unit_mm > 0) {
    constexpr double kLeast = 0.4, kMost = 2.5;  // an infant's head is 0.75 of the adult's
    const double growth = growth_of(scan.unit_mm);
    if (growth < kLeast || growth > kMost)
      fail_scan(
          scan,
          fmt::format(
              "with this unit the head is {:.3g} times as large as an adult's; expected {} to {}, or no "
              "unit at all",
              growth, kLeast, kMost));
    return growth;
  }
  double best = growth_of(1);
  for (const double unit_mm : {10.0, 25.4, 1000.0})
    if (std::abs(std::log(growth_of(unit_mm))) < std::abs(std::log(best))) best = growth_of(unit_mm);
  return best;
}

}  // namespace mien

#include "head/scan_frame.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace mien {

namespace {

// Where it is said, or for the scan as a whole.
[[noreturn]] void fail_at(const Scan& scan, const SaidAt& said, const std::string& message) {
  if (said.place.file.empty())
    throw InputError(std::vector<Diagnostic>{{{scan.mesh.file, 0, 0}, message, "", false}});
  throw InputError(std::vector<Diagnostic>{{said.place, message, said.line, false}});
}

double compute_square(const glm::dvec3& a, const glm::dvec3& b) { return glm::dot(a - b, a - b); }

// Two landmarks of which each lies where the other one should. The fit has taken some of it away, since it
// has no others to go by; noise and a head of other proportions move neighbours alike and not into each
// other's places.
void check_pairs(const Scan& scan, const std::vector<glm::dvec3>& ours,
                 const std::vector<glm::dvec3>& theirs) {
  // Of two landmarks 7 mm off each; nearer ones are a matter of taste.
  constexpr double kLeastGain_mm2 = 2 * 7 * 7;
  constexpr double kMostLeft = 0.3;    // of the misses' squares, after the exchange
  constexpr double kMostMiss_mm = 25;  // of either then: further off, more is wrong than these two
  std::size_t first = 0, second = 0;
  double most = kLeastGain_mm2;
  for (std::size_t i = 0; i < ours.size(); ++i)
    for (std::size_t j = i + 1; j < ours.size(); ++j) {
      if (scan.marks[i].weight < 1 || scan.marks[j].weight < 1) continue;  // nobody knows them so well
      const double now = compute_square(theirs[i], ours[i]) + compute_square(theirs[j], ours[j]);
      const double then = compute_square(theirs[j], ours[i]) + compute_square(theirs[i], ours[j]);
      if (then > kMostLeft * now || now - then <= most) continue;
      if (glm::distance(theirs[j], ours[i]) > kMostMiss_mm ||
          glm::distance(theirs[i], ours[j]) > kMostMiss_mm)
        continue;
      most = now - then, first = i, second = j;
    }
  if (second == 0) return;
  const std::string &a = scan.marks[first].name, &b = scan.marks[second].name;
  fail_at(scan, scan.marks[second].said,
          fmt::format(
              "landmarks '{}' and '{}' look exchanged: they lie {:.0f} and {:.0f} mm from their places on "
              "a head of our size, and {:.0f} and {:.0f} mm from each other's; expected each at its own",
              a, b, glm::distance(theirs[first], ours[first]), glm::distance(theirs[second], ours[second]),
              glm::distance(theirs[first], ours[second]), glm::distance(theirs[second], ours[first])));
}

// The tip of a nose stands before the line from its root to its base: on adults some 15 mm, on infants, at
// our size, half of it.
void check_nose(const Scan& scan, const std::vector<glm::dvec3>& placed) {
  constexpr double kLeast_mm = 4.5;
  const auto find = [&](const char* name) {
    return static_cast<std::size_t>(std::ranges::find(scan.marks, name, &ScanMark::name) -
                                    scan.marks.begin());
  };
  const std::size_t root = find("n"), tip = find("prn"), base = find("sn");
  if (std::max({root, tip, base}) >= placed.size()) return;
  const glm::dvec3 line = placed[base] - placed[root], way = placed[tip] - placed[root];
  const double share = glm::dot(way, line) / glm::dot(line, line);
  const double before_mm = (way - share * line).z;
  if (before_mm < kLeast_mm)
    fail_at(scan, scan.marks[tip].said,
            fmt::format(
                "landmark 'prn', the tip of the nose, stands {:.1f} mm before the line from 'n' to 'sn' on "
                "a head of our size; expected {} at least",
                std::round(10 * before_mm) / 10 + 0.0, kLeast_mm));
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
    fail_at(scan, scan.marks_said, "the landmarks lie in one place; expected them all over the head");
  const std::vector<double> misses = find_misses(similarity);
  const auto worst = std::ranges::max_element(misses) - misses.begin();
  constexpr double kMostMiss_mm = 30;  // an infant's landmarks miss by 12
  std::vector<glm::dvec3> placed;
  for (const glm::dvec3& p : theirs) placed.push_back(apply_similarity(similarity, p));
  if (misses[worst] <= kMostMiss_mm) {
    check_pairs(scan, ours, placed);
    check_nose(scan, placed);
    return similarity;
  }
  // A mirrored head fits better if the sides were taken for each other.
  std::vector<glm::dvec3> swapped = ours;
  for (glm::dvec3& p : swapped) p.x = -p.x;
  std::swap(ours, swapped);
  const std::vector<double> mirrored = find_misses(fit_similarity(theirs, ours));
  if (*std::ranges::max_element(mirrored) < kMostMiss_mm)
    fail_at(scan, scan.marks_said,
            "the landmarks' sides are swapped; expected _l on the character's own left");
  check_pairs(scan, swapped, placed);
  fail_at(
      scan, scan.marks[worst].said,
      fmt::format(
          "landmark '{}' is not where a head has it: {:.0f} mm off on a head of our size; expected {:.0f} "
          "at most",
          scan.marks[worst].name, misses[worst], kMostMiss_mm));
}

// How much larger the scanned head is than the one we wrapped, which was laid on the adult.
double compute_growth(const Scan& scan, double ours_per_unit) {
  const auto growth_of = [&](double unit_mm) { return unit_mm / ours_per_unit; };
  constexpr double kLeast = 0.4, kMost = 2.5;  // an infant's head is 0.75 of the adult's
  double growth = growth_of(scan.unit_mm > 0 ? scan.unit_mm : 1);
  if (scan.unit_mm == 0)
    for (const double unit_mm : {10.0, 25.4, 1000.0})
      if (std::abs(std::log(growth_of(unit_mm))) < std::abs(std::log(growth))) growth = growth_of(unit_mm);
  if (growth >= kLeast && growth <= kMost) return growth;
  if (scan.unit_mm > 0)
    fail_at(scan, scan.unit_said,
            fmt::format(
                "with this unit the head is {:.3g} times as large as an adult's; expected {} to {}, or no "
                "unit at all",
                growth, kLeast, kMost));
  fail_at(
      scan, scan.marks_said,
      fmt::format("in mm, cm, in and m alike the head is no head's size, at best {:.3g} times an adult's; "
                  "expected {} to {}",
                  growth, kLeast, kMost));
}

std::vector<Diagnostic> judge_growth(const Scan& scan, double growth) {
  constexpr double kLeast = 0.65, kMost = 1.3;
  if (scan.unit_mm > 0 || (growth >= kLeast && growth <= kMost)) return {};
  const SaidAt& said = scan.marks_said;
  return {{said.place.file.empty() ? Place{scan.mesh.file, 0, 0} : said.place,
           fmt::format(
               "the head is {:.3g} times as large as an adult's in the unit that fits best: say the scan's "
               "unit, such as unit: mm",
               growth),
           said.line, true}};
}

}  // namespace mien

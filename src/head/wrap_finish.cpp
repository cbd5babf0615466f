#include "head/wrap_finish.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "head/eye_fit.hpp"
#include "head/least_squares.hpp"
#include "head/nostrils.hpp"

namespace mien {

namespace {

// Columns of the mouth's rings: 0 the middle of the upper lip, a corner, the middle of the lower lip.
constexpr int kCorner = 6, kLast = 12;

// To its own size and to the origin of every head: pupils at height 0, ear canals at the adult's share.
void place_head(const HeadStock& stock, double growth, HeadForm& form) {
  const std::uint32_t ear = find_point(stock.adult, "er5_13");  // the tragion
  const glm::dvec3 origin(0, form.eye.centre.y, form.points[ear].z - stock.adult.points[ear].z);
  for (glm::dvec3& p : form.points) p = growth * (p - origin);
  form.eye.centre = growth * (form.eye.centre - origin);
  form.eye.radius_mm *= growth;
}

// Where the outside of a lip lies at a height, on the way through the points of a column of the rings M2 to
// M5.
double compute_lip_z(const Cage& cage, const std::vector<glm::dvec3>& points, int column, double y_mm) {
  constexpr std::array kRings{"M2_", "M3_", "M4_", "MA_", "M5_"};
  std::array<glm::dvec3, kRings.size()> line{};
  for (std::size_t i = 0; i < kRings.size(); ++i)
    line[i] = points[find_point(cage, kRings[i] + std::to_string(column))];
  if (line.front().y > line.back().y) std::ranges::reverse(line);
  std::size_t next = 1;
  while (next + 1 < line.size() && line[next].y < y_mm) ++next;
  const double way = line[next].y - line[next - 1].y;
  const double share = way <= 0 ? 1 : std::clamp((y_mm - line[next - 1].y) / way, 0.0, 1.0);
  return std::lerp(line[next - 1].z, line[next].z, share);
}

// A lip is as thick as the adult's: the bag carried as a whole would come out of a lower lip that falls back
// more than the adult's.
void keep_lips_thick(const Cage& cage, HeadForm& form) {
  const std::uint32_t corner = find_point(cage, "M1_6");
  const double scale = form.points[corner].x / cage.points[corner].x;
  for (const char* ring : {"M0_", "MB1_", "MB2_"})
    for (int column = 0; column <= kLast; ++column) {
      if (column == kCorner) continue;
      const std::uint32_t inside = find_point(cage, ring + std::to_string(column));
      const glm::dvec3& adult = cage.points[inside];
      const double thick_mm = scale * (compute_lip_z(cage, cage.points, column, adult.y) - adult.z);
      glm::dvec3& p = form.points[inside];
      p.z = std::min(p.z, compute_lip_z(cage, form.points, column, p.y) - thick_mm);
    }
  mirror_half(cage, form.points);
}

// The mouth's bag goes with the mouth as a whole: far behind the lips fairness would guess too much, and a
// bag of the adult's size would stick out of a child's throat.
void carry_mouth_bag(const Cage& cage, HeadForm& form) {
  std::vector<glm::dvec3> from, to;
  for (std::size_t i = 0; i < cage.points.size(); ++i)
    for (const char* ring : {"M3_", "M4_", "M5_", "M6_"})
      if (has_prefix(cage.names[i], ring)) {
        from.push_back(cage.points[i]);
        to.push_back(form.points[i]);
      }
  const Similarity carried = fit_similarity(from, to);
  for (std::size_t i = 0; i < cage.points.size(); ++i)
    if (has_prefix(cage.names[i], "MB")) form.points[i] = apply_similarity(carried, cage.points[i]);
  mirror_half(cage, form.points);
}

// Lips meet nearly as on the adult: hardly a scan shows the crease between them, where one lip alone would
// sink in.
void join_lips(const Cage& cage, const std::vector<glm::dvec3>& adult, HeadForm& form) {
  constexpr double kShare = 0.5;  // more of it would show on the lips' red
  for (const char* ring : {"M0_", "M1_"})
    for (int column = 0; column < kCorner; ++column) {
      const std::uint32_t upper = find_point(cage, ring + std::to_string(column)),
                          lower = find_point(cage, ring + std::to_string(kLast - column));
      const glm::dvec3 middle = (form.points[upper] + form.points[lower]) / 2.0,
                       apart = glm::mix(form.points[upper] - form.points[lower], adult[upper] - adult[lower],
                                        kShare) /
                               2.0;
      form.points[upper] = middle + apart;
      form.points[lower] = middle - apart;
    }
  mirror_half(cage, form.points);
}

}  // namespace

void finish_wrap(const HeadStock& stock, double growth, HeadForm& form) {
  keep_nostrils(stock.adult, stock.adult.points, form.points);
  carry_mouth_bag(stock.adult, form);
  join_lips(stock.adult, stock.adult.points, form);
  keep_lips_thick(stock.adult, form);
  close_lips(stock.adult, 1, form);
  fit_eye(stock, stock.adult.points, form);
  place_head(stock, growth, form);
}

}  // namespace mien

// Where a scan has its ears.
#pragma once

#include "head/form.hpp"
#include "head/placed_scan.hpp"

namespace mien {

// The ring of the ear that the point's name ("er5_13", its "R:" apart) says: 1 at the root, more outward over
// the rim and inward to the canal; 0 for points that are no ear's.
int find_ear_ring(std::string_view name);

// Where the ear's root carries the adult's ear when the cage's points are `points`.
Similarity carry_ear_by_root(const Cage& cage, const std::vector<glm::dvec3>& points);

struct EarFit {
  Similarity carried;  // the adult's ear laid on the scan's
  double share = 0;    // of both ears' surfaces that lie on the other's so: 1 our own ear, 0 none at all
  bool is_found = false;
};

// Looks for the scan's ears where they stand out from the side of the head that `points` (of the adult's
// cage) make; both sides of the scan count as one.
EarFit find_ear(const HeadStock& stock, const PlacedScan& scan, const std::vector<glm::dvec3>& points);

}  // namespace mien

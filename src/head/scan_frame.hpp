// Where a scan lies, and how large it is.
#pragma once

#include "head/eye_fit.hpp"
#include "head/scan.hpp"

namespace mien {

// The similarity that lays the scan's landmarks on the adult's. Throws InputError if they are not a head's,
// or if left and right are swapped.
Similarity align_marks(const HeadStock& stock, const Scan& scan);

// How much larger than the adult the scanned head is, laid on it with `ours_per_unit` mm for a unit of the
// scan. Throws InputError if the scan's own unit, or where it has none each that is known, would make a giant
// or a dwarf of it.
double compute_growth(const Scan& scan, double ours_per_unit);

// A warning if a unit was found for the scan and its head is larger or smaller than people are.
std::vector<Diagnostic> judge_growth(const Scan& scan, double growth);

}  // namespace mien

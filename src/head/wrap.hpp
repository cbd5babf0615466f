// The shipped head wrapped around a scan.
#pragma once

#include "head/scan.hpp"
#include "head/wrap_judge.hpp"

namespace mien {

// What came of it.
struct Wrap {
  HeadForm form;
  std::vector<std::string> kept;  // nothing of it was found in the scan, it is the shipped head's: "ears"
  WrapWorth worth;
  std::vector<Diagnostic> warnings;  // the scan's, and what the wrap says of itself
};

// A head with our points and the scan's shape, in its true size, eyes at height 0: one half that fits both
// sides best, and its mirror image. Holes, mouth and what the scan does not have are filled smoothly; ears
// take place, size and angle of the scan's and keep their own relief, nostrils keep their form within the
// scan's nose; the eyeball is fitted to the lids. The same scan gives the same head, always. About 3 s.
// Throws InputError if the landmarks are not a head's or the scan is no face, and Interrupted.
Wrap wrap_scan(const HeadStock& stock, const Scan& scan);

}  // namespace mien

// The shipped head wrapped around a scan.
#pragma once

#include "head/scan.hpp"

namespace mien {

// A head with our points and the scan's shape, in its true size, eyes at height 0: one half that fits both
// sides best, and its mirror image. Holes, mouth and what the scan does not have are filled smoothly; ears
// take place, size and angle of the scan's and keep their own relief, nostrils keep their form within the
// scan's nose; the eyeball is fitted to the lids. The same scan gives the same head, always. About 3 s.
// Throws InputError if the landmarks are not a head's.
HeadForm wrap_head(const HeadStock& stock, const Scan& scan);

// What wrap_head finds nothing of in the scan and keeps from the shipped head: "ears", or nothing. About 1 s;
// throws as wrap_head does.
std::vector<std::string> list_kept_parts(const HeadStock& stock, const Scan& scan);

}  // namespace mien

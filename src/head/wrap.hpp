// The shipped head wrapped around a scan.
#pragma once

#include "head/scan.hpp"

namespace mien {

// A head with our points and the scan's shape, in its true size, eyes at height 0: one half that fits both
// sides best, and its mirror image. Holes, mouth, nostrils and what the scan does not have are filled
// smoothly; the eyeball is fitted to the lids. The same scan gives the same head, always. About 3 s. Throws
// InputError if the landmarks are not a head's.
HeadForm wrap_head(const HeadStock& stock, const Scan& scan);

}  // namespace mien

// What lies between ball and lids: the wet line and the pink corner. Both follow the lids.
#pragma once

#include "config/part_numbers.hpp"
#include "head/lids.hpp"

namespace mien {

// The bead of water along the lower lid, on the ball.
HeadPart build_tear(const Lids& lids, const TearNumbers& tear);

// The caruncle in the inner corner and the fold (plica semilunaris) beside it.
HeadPart build_caruncle(const Lids& lids, const EyeNumbers& eye);

}  // namespace mien

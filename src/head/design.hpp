// A head redrawn: the form that a design gives it.
#pragma once

#include "config/design_data.hpp"
#include "head/shapes.hpp"

namespace mien {

struct HeadStock;

// The ages a head is made of: its own words, unless they are none and the heads it is made from say more.
Mix compute_ages(const HeadSpec& spec);

// The dials of the head's own design, or of those of the heads that it is mixed of.
DesignNumbers compute_design(const HeadStock& stock, const HeadSpec& spec);

// Warps the cage and the eye of a finished head as the dials say. `average` is the average head of the same
// age and size, which `difference` is told against; not looked at where that is 1.
void apply_design(const Cage& adult, const DesignNumbers& design, const HeadForm& average, HeadForm& form);

}  // namespace mien

// A drawing as a printable bust: one closed skin without a mouth bag, carved eyes, raised brows, teeth where
// they show.
#pragma once

#include <string>

#include "core/model.hpp"
#include "core/print.hpp"
#include "head/head.hpp"

namespace mien {

// The printed parts (Part::is_printed) of one drawing as closed solids at `height_mm`, the skin first. `head`
// is the neutral head that the model was built from; "skin", "eye_left", "iris_left", "brow_left" and their
// like are known by name, any other printed part is closed and taken as it is, a solid for each of its
// connected pieces, unless it is wholly hidden in the skin or does not touch it. Throws RunError "internal:
// ..." if the model does not fit.
BustPrint build_bust(const NeutralHead& head, const Model& model, const Drawing& drawing, double height_mm,
                     std::string title);

}  // namespace mien

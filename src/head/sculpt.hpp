// Local edits of a head by hand: places pushed and pulled.
#pragma once

#include "head/form.hpp"

namespace mien {

// Carries out the strokes one after another. The place of a stroke goes exactly where it was told; the skin
// around follows less and less, up to the radius, measured along the skin, so that one lip does not drag the
// other. Both sides are moved alike: the head stays its own mirror image. The eyeball follows its lids.
void sculpt_form(const HeadStock& stock, const std::vector<SculptStroke>& strokes, HeadForm& form);

}  // namespace mien

// The eyes as ink draws them: flat discs on a ball.
#pragma once

#include "head/head.hpp"

namespace mien {

// Of each side the white, the iris with its dark rim, the pupil and two lights, rigid with the ball; what a
// design's lens makes tall it makes of these too.
std::vector<HeadPart> build_ink_eyes(const NeutralHead& head, const Look& look);

}  // namespace mien

// One face of a clip: that of a time, or an expression.
#pragma once

#include <vector>

#include "clip/clip.hpp"
#include "frames/figure.hpp"

namespace mien {

// The pose that --express asks for, else the actor's at --at or at the clip's beginning; `held` becomes what
// limits hold back of it. `figure` is the actor's.
Moment compute_moment(const Options& options, const Clip& clip, const Actor& actor, const Figure& figure,
                      std::vector<Held>& held);

Drawing draw_moment(const Figure& figure, const Moment& moment);

}  // namespace mien

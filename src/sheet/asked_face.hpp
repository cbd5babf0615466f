// The face that a sheet of one head shows: at rest, or what --express or --at asks for.
#pragma once

#include <vector>

#include "clip/clip.hpp"
#include "config/ledger.hpp"
#include "config/stock.hpp"
#include "frames/resources.hpp"
#include "options.hpp"

namespace mien {

struct AskedFace {
  HeadSpec head;
  Pose pose;               // the head does not turn: a sheet sees it from where it wants
  std::string words;       // "smile", "at 1.2 s"; empty: at rest
  std::vector<Held> held;  // what limits hold back of it
};

// With --express the file's own head with that expression, with --at the head and the face of that time, as
// `mien still` has them. Throws InputError for an unknown expression, and if there are several actors and
// none is named.
AskedFace find_asked_face(const Options& options, const Clip& clip, const Resources& resources);

}  // namespace mien

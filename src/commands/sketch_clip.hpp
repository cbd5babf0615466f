// A clip of sketches, as `mien render --quality sketch` and `mien watch` make it.
#pragma once

#include <vector>

#include "clip/cast.hpp"
#include "clip/sketches.hpp"
#include "options.hpp"

namespace mien {

// A clip, and with --beside one for each design, which are shown side by side.
struct ClipParts {
  Clip clip;
  std::vector<Clip> parts;  // none: the clip itself
};

// Reads the file. Throws InputError with every mistake, those of --beside too.
ClipParts plan_parts(const Options& options, const Resources& resources);

// The heads of all that is shown.
std::vector<Cast> build_casts(const ClipParts& planned, const HeadStock& stock, FigureStore* store = nullptr);

// Traces what `store` has not, joins all to NAME_sketch.mp4 and writes what was made beside it; the folder is
// held. Tells what limits hold back, progress and the clip's path.
void sketch_clip(const Options& options, const ClipParts& planned, const std::vector<Cast>& casts,
                 const Resources& resources, SketchStore* store);

}  // namespace mien

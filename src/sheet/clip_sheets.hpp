// `mien sheet strip`, `exposure` and `contact`: a clip on paper, as its drawings and curves and as a list of
// its frames.
#pragma once

#include <filesystem>
#include <string>

#include "frames/resources.hpp"
#include "options.hpp"

namespace mien {

// Whether a kind of sheet is one of a clip, and made here.
bool is_clip_sheet(const std::string& kind);

// "strip": key drawings, drawings between them and the curves of each area as one SVG file; "exposure": each
// frame's drawing and what changed, as CSV; "contact": contact.hpp. To -o, else to out/NAME/strip.svg or
// out/NAME/exposure.csv; returns the path. --size is a picture's in the strip. Throws InputError before
// anything is written.
std::filesystem::path write_clip_sheet(const Options& options, const Resources& resources);

}  // namespace mien

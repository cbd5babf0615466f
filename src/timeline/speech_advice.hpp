// What an animator would say of lines that are said.
#pragma once

#include <vector>

#include "config/clip_spec.hpp"

namespace mien {

// Warnings at the lines: one that begins while another is said, and words that no drawing shows, as they are
// shorter than one is held, or most of its sounds. `drawn_s` are the times that the clip's frames show.
std::vector<Diagnostic> advise_speech(const ClipSpec& clip, const std::vector<double>& drawn_s);

}  // namespace mien

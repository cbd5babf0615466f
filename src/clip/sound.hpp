// What is heard of a clip, as one file.
#pragma once

#include <optional>

#include "clip/clip.hpp"
#include "render/video_kind.hpp"

namespace mien {

// Tells a sound that ffmpeg cannot read as a mistake of the file, before anything is drawn. Throws
// InputError.
void check_sound(const Clip& clip);

// The sound of all frames that are planned, from the first of them on. Several sounds are mixed into a file
// that is there as long as the program runs. Throws RunError with ffmpeg's words.
std::optional<Sound> find_sound(const Clip& clip);

}  // namespace mien

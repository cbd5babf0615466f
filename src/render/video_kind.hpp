// The kinds of clips by the endings of their names: how ffmpeg encodes each, and how it is judged.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "render/picture.hpp"

namespace mien {

// What a clip's name may end in: ".mp4", ".webm", ".mov" (ProRes 4444), ".gif", ".webp", ".apng".
const std::vector<std::string>& list_video_endings();

// Whether a name ends in one of them, in small or large letters.
bool is_video_name(const std::filesystem::path& path);

// A sound file under a clip's pictures.
struct Sound {
  std::filesystem::path file;  // absolute
  double at_s = 0;             // of the clip's own time, when it begins; below 0: so much of it is left out
};

// Whether clips of that ending can be heard: .mp4, .webm and .mov.
bool can_sound(const std::filesystem::path& clip);

// Whether the file has a sound that ffmpeg can read.
bool is_sound(const std::filesystem::path& file);

// What ffmpeg is told of a sound: what it reads besides the pictures, and how the sound is encoded (AAC,
// Opus, 16 bit). It ends with the pictures, silence goes before and after it.
std::vector<std::string> list_sound_input(const Sound& sound);
std::vector<std::string> list_sound_options(const Sound& sound, const std::filesystem::path& clip,
                                            double length_s);

// What ffmpeg is told between its input and the clip's name: filters, encoder, colours. Every kind loops for
// ever where it can say so (gif, webp, apng). `is_sketch`: quicker and coarser, where that is a choice. The
// same pictures give the same bytes, whatever the processor. Throws RunError for another ending.
std::vector<std::string> list_encoder_options(const std::filesystem::path& clip, const PictureSize& size,
                                              int fps, bool is_sketch);

// What is wrong with a finished clip: "ffmpeg made a clip of 4 frames, not 5", "... of 32x24 pixels, not
// 48x60", "... of 25/1 frames a second, not 24"; empty if nothing is. `file` is in `folder`. Throws RunError
// with ffprobe's words if it cannot read it. With `has_sound` also "... without sound", and "... whose sound
// is 1.20 s long, not 2.00".
std::string find_video_fault(const std::filesystem::path& folder, const std::string& file,
                             const PictureSize& size, int fps, std::size_t frame_count,
                             bool has_sound = false);

}  // namespace mien

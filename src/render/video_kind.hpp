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

// Whether it is a film: .mp4, .webm and .mov have sound and tags for their colours, and are shown once. The
// others are pictures that move.
bool is_film(const std::filesystem::path& clip);

// A sound file under a clip's pictures.
struct Sound {
  std::filesystem::path file;  // absolute
  double at_s = 0;             // of the clip's own time, when it begins; below 0: so much of it is left out
  // Where the clip shows its frames in rounds: how long one is, and how much of it is heard.
  int rounds = 1;
  double round_s = 0, heard_s = 0;  // 0: there is one round, all of which is heard
};

// What a clip is to be, whatever its kind.
struct VideoForm {
  PictureSize size;
  int fps = 24;
  bool has_alpha = false;  // its pictures are transparent in places; an .mp4 is white there
  bool is_sketch = false;  // quicker and coarser, where that is a choice
  int plays = 0;           // of a .gif, .webp or .apng: how often it plays; 0: for ever
};

// Whether the file has a sound that ffmpeg can read.
bool is_sound(const std::filesystem::path& file);

// What ffmpeg is told of a sound: what it reads besides the pictures, and how the sound is encoded (AAC,
// Opus, 16 bit). It ends with the pictures, silence goes before and after it.
std::vector<std::string> list_sound_input(const Sound& sound);
std::vector<std::string> list_sound_options(const Sound& sound, const std::filesystem::path& clip,
                                            double length_s);

// What ffmpeg is told between its input and the clip's name: filters, encoder, colours. The same pictures
// give the same bytes, whatever the processor. Throws RunError for another ending.
std::vector<std::string> list_encoder_options(const std::filesystem::path& clip, const VideoForm& form);

// What is wrong with a finished clip: "ffmpeg made a clip of 4 frames, not 5", "... of 32x24 pixels, not
// 48x60", "... of 25/1 frames a second, not 24", "... without transparency"; empty if nothing is. `file` is
// in `folder`. Throws RunError with ffprobe's words if it cannot read it. With `has_sound` also "... without
// sound", and "... whose sound is 1.20 s long, not 2.00".
std::string find_video_fault(const std::filesystem::path& folder, const std::string& file,
                             const VideoForm& form, std::size_t frame_count, bool has_sound = false);

}  // namespace mien

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

// What ffmpeg is told between its input and the clip's name: filters, encoder, colours. Every kind loops for
// ever where it can say so (gif, webp, apng). `is_sketch`: quicker and coarser, where that is a choice. The
// same pictures give the same bytes, whatever the processor. Throws RunError for another ending.
std::vector<std::string> list_encoder_options(const std::filesystem::path& clip, const PictureSize& size,
                                              int fps, bool is_sketch);

// What is wrong with a finished clip: "ffmpeg made a clip of 4 frames, not 5", "... of 32x24 pixels, not
// 48x60", "... of 25/1 frames a second, not 24"; empty if nothing is. `file` is in `folder`. Throws RunError
// with ffprobe's words if it cannot read it.
std::string find_video_fault(const std::filesystem::path& folder, const std::string& file,
                             const PictureSize& size, int fps, std::size_t frame_count);

}  // namespace mien

// From numbered pictures to a clip, through ffmpeg.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mien {

// frames/f0001.png.. -> an H.264 MP4 that plays everywhere: yuv420p, bt709 tags, faststart, sides padded to
// even. `pictures` are in order; a drawing held for two frames is named twice. Verified with ffprobe: throws
// RunError if the clip has not pictures.size() frames. Written beside and renamed.
void write_video(const std::vector<std::filesystem::path>& pictures, int fps,
                 const std::filesystem::path& clip);

}  // namespace mien

// From numbered pictures to a clip, through ffmpeg.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/picture.hpp"
#include "render/process.hpp"
#include "render/video_kind.hpp"
#include "render/work_folder.hpp"

namespace mien {

// Pictures -> a clip of the kind that its name ends in (video_kind.hpp): an .mp4 plays everywhere (H.264,
// yuv420p, bt709 tags, faststart, sides padded to even). `pictures` are in order; a drawing held for two
// frames is named twice. Verified: throws RunError if the clip has not pictures.size() frames of their size
// at this rate, or is not transparent where they are. Written beside and renamed.
// `sound` goes under the pictures of kinds that can be heard; the others stay silent. `plays` is VideoForm's.
void write_video(const std::vector<std::filesystem::path>& pictures, int fps,
                 const std::filesystem::path& clip, const std::optional<Sound>& sound = {}, int plays = 0);

// The same of pictures that never lie on a disk: given one after the other, encoded as they come, quicker and
// a little coarser.
struct VideoStream {
  std::filesystem::path clip;
  VideoForm form;
  std::size_t frame_count = 0;
  bool has_sound = false;
  std::vector<std::string> command;
  std::unique_ptr<WorkFolder> work;
  Process encoder;
};

// `frame_count` pictures will come; only their sound depends on it.
VideoStream start_video(const VideoForm& form, const std::filesystem::path& clip,
                        const std::optional<Sound>& sound = {}, std::size_t frame_count = 0);

// Throws RunError with ffmpeg's words if it has ended, or if a picture has another size.
void append_frame(VideoStream& video, const Pixels& picture);

// Verifies the clip and puts it in its place. Without this nothing is left of it.
void finish_video(VideoStream& video);

}  // namespace mien

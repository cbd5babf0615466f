// Which frames are asked for, which of them are drawings of their own, and where everything goes. Pure.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mien {

// The files of one clip: FOLDER/scenes/f0001.pov, FOLDER/frames/f0001.png, FOLDER/NAME.mp4, ...
struct ClipFiles {
  std::filesystem::path folder;
  std::string name;

  std::filesystem::path scenes() const { return folder / "scenes"; }
  std::filesystem::path scene(int frame) const;  // frames count from 1
  std::filesystem::path picture(int frame) const;
};

// "f0007", and more digits from frame 10000 on.
std::string name_frame(int frame);

// "h0007.inc": the parts of heads that change, as they are in frame 7.
std::string name_heads(int frame);

// Whether FOLDER/scenes and FOLDER/frames of a clip may hold a file of this name: "f0001.pov", "head.inc".
bool is_clip_file(const std::string& name);

// What is to be made. Frames count from 1.
struct FramePlan {
  std::vector<int> frames;  // asked for, ascending
  std::vector<int>
      drawn_as;  // for each of them the frame, itself or an earlier one asked for, that draws the same
  std::vector<int> drawings;  // the frames that draw themselves, ascending
};

// `drawing_of` gives for each frame of the clip (from 0) the first frame that shows the same. Throws
// InputError
// "--frames 90-120: the clip has 96 frames; expected A-B within 1-96" for a range outside the clip.
FramePlan plan_frames(const std::vector<int>& drawing_of, const std::optional<std::pair<int, int>>& range);

// Scenes and pictures of our own naming in the clip's folders whose number is above `frame_count`: left from
// a longer clip. Empty if the folders are not there.
std::vector<std::filesystem::path> find_stale_files(const ClipFiles& files, int frame_count);

}  // namespace mien

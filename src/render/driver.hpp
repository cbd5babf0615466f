// Frames through POV-Ray: as many processes at once as asked for, one thread each; only finished pictures
// stay.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "render/picture.hpp"
#include "render/process.hpp"

namespace mien {

// One frame to render.
struct FrameJob {
  int number = 1;                 // 1-based, names the frame in messages
  std::filesystem::path scene;    // the frame's .pov; its folder is searched for #include first
  std::filesystem::path picture;  // the .png to make
  std::string key;  // hash of all that the pixels depend on; kept inside the PNG; empty: render always
  std::filesystem::path told_scene = {};  // where the scene lies when all is over, if that is elsewhere
};

struct RenderSettings {
  int width_px = 480, height_px = 600;
  std::vector<std::string> povray_options;       // anti-aliasing and the like, from scene/povray
  std::vector<std::filesystem::path> libraries;  // folders for #include
  int jobs = 1;                                  // processes at once, one thread each
  std::filesystem::path work_parent = {};        // of the WorkFolder; empty: beside the first picture
};

// Told after each frame; `frame_number` was rendered, or kept because its picture is already right.
using FrameDone = std::function<void(int frame_number, bool was_kept)>;

// What the driver asks of who owns the frames, always from the thread that called it.
struct FrameHooks {
  FrameDone done;
  std::function<void(const FrameJob& job)> prepare = {};  // just before a frame is traced: writes its scene
  std::function<void(const FrameJob& job)> failed =
      {};  // once for each frame that failed, before that is told
};

// What a scene reads must not change while it is traced: the scenes of `frames` are their caller's alone.
// Renders what is missing or stale. Each frame: povray into a WorkFolder, checked
// (decodes, right size, not all one colour, scene not empty), stripped of its date, marked with its key,
// written beside its place and renamed. A failing frame is tried once more while the others go on; if no
// frame has worked yet, only the first that failed is, and nothing after it. At the end RunError tells the
// command and POV-Ray's last lines (unwrapped from 80 columns) of the first that failed twice, and which
// others did. One that hangs is ended when it has idled ten times as long as the slowest took, a minute at
// least. A full disk is one line, "cannot write PICTURE: No space left on device". Throws
// Interrupted on a signal with all children ended and no temporary files left. Folders may have any name.
void render_frames(const std::vector<FrameJob>& frames, const RenderSettings& settings,
                   const FrameHooks& hooks);

}  // namespace mien

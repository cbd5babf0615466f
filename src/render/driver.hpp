// Running POV-Ray, OpenSCAD and ffmpeg: the only place that starts a process.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace mien {

// What a program printed and how it ended.
struct ProcessResult {
  int exit_code = 0;   // 128 + n if signal n ended it
  std::string output;  // stdout and stderr together, as they came
  double wall_s = 0;
};

// Runs one program to its end in `folder`, with `environment` ("NAME=value") added to ours. The child is
// ended when we are asked to stop; then throws Interrupted. Throws RunError if it cannot be started.
ProcessResult run_process(const std::vector<std::string>& command, const std::filesystem::path& folder,
                          const std::vector<std::string>& environment = {});

// Throws RunError "povray is not installed; install it with: apt-get install povray" for the first of
// `programs` (program, Debian package) that PATH does not hold. Called before any work.
void require_programs(const std::vector<std::pair<std::string, std::string>>& programs);

// One frame to render.
struct FrameJob {
  int number = 1;                 // 1-based, names the frame in messages
  std::filesystem::path scene;    // the frame's .pov
  std::filesystem::path picture;  // the .png to make
  std::string key;                // hash of all that the pixels depend on; kept inside the PNG
};

struct RenderSettings {
  int width_px = 480, height_px = 600;
  std::vector<std::string> povray_options;       // anti-aliasing and the like, from scene/povray
  std::vector<std::filesystem::path> libraries;  // folders for #include
  int jobs = 1;                                  // processes at once, one thread each
};

// Told after each frame; `frame_number` was rendered, or kept because its picture is already right.
using FrameDone = std::function<void(int frame_number, bool was_kept)>;

// Renders what is missing or stale. Each frame: povray into a temporary name beside the picture, checked
// (decodes, right size, not all one colour, scene not empty), stripped of its date, marked with its key,
// renamed. A failing frame lets the running ones finish, keeps them, and throws RunError with the command and
// POV-Ray's last lines (unwrapped from 80 columns). Throws Interrupted on a signal with all children ended
// and no temporary files left.
void render_frames(const std::vector<FrameJob>& frames, const RenderSettings& settings,
                   const FrameDone& done);

// The key inside a finished picture; empty if there is no picture, it does not decode or it has no key.
std::string read_picture_key(const std::filesystem::path& picture);

}  // namespace mien

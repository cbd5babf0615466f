// A clip's way from a file to its frames: what every command about moving pictures shares.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "config/spec.hpp"
#include "frames/figure.hpp"
#include "pipeline.hpp"
#include "render/plan.hpp"
#include "scene/povray.hpp"
#include "timeline/performance.hpp"

namespace mien {

// The file as the command line wants it. Throws InputError with every mistake of the file.
Spec load_request(const Options& options, const std::filesystem::path& data_folder);

// Where a command's files go: -o, else out/NAME.
std::filesystem::path find_output(const Options& options, const Spec& spec);

// A clip planned: everything but work.
struct Clip {
  Spec spec;
  Performance performance;
  FramePlan plan;
  ClipFiles files;
  int frame_count = 0;  // of the whole clip, whatever --frames says
};

Clip plan_clip(const Options& options, const std::filesystem::path& data_folder);

// What a gaze must know of the figure and of the camera that looks at it.
EyeRig find_eyes(const Figure& figure, const RenderSpec& render);

// The camera of one moment. Distance 1 frames the whole face and neck of this head, whatever its size and
// whatever the angle: a long head from the side is framed wider than from the front. Between two angles the
// frame changes as smoothly as they do.
CameraView find_view(const Figure& figure, const CameraKey& camera, const RenderSpec& render);

// Writes the shared include, a scene for each frame asked for (a held drawing includes the one it repeats)
// and the .ini. Returns for each drawing of the plan the key of its picture: a hash of all that its pixels
// depend on.
std::vector<std::string> write_scenes(const Clip& clip, const Figure& figure, const Options& options,
                                      const std::filesystem::path& data_folder);

// Renders the drawings and gives every frame asked for its picture.
void render_pictures(const Clip& clip, const std::vector<std::string>& keys, const Options& options);

// What was made, for other programs: manifest.json.
std::string build_manifest(const Clip& clip, const std::vector<std::string>& keys);

}  // namespace mien

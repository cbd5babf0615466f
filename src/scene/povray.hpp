// POV-Ray scenes: one include for what never changes in a clip, one small file a frame, one .ini for all.
// The only place that knows POV-Ray is left-handed: z is negated on the way out.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "config/spec.hpp"
#include "core/model.hpp"

namespace mien {

// Where the camera stands and what it frames, all in mien's own space (mm, right-handed).
struct CameraView {
  double angle_deg = 0;
  double height_deg = 0;
  double distance = 1;
  glm::vec3 look_at{0, -20, 0};  // mm, the middle of the framed box
  double frame_width_mm = 240;   // the box that distance 1 just fits, whatever the picture's shape
  double frame_height_mm = 300;
};

// The text of scenes/head.inc: materials, lights and background from `templates_folder`, quality settings,
// each part's shades, faces and (for rigid parts) vertices. Throws RunError on a broken template.
std::string build_povray_include(const Model& model, const RenderSpec& render,
                                 const std::filesystem::path& templates_folder);

// Appends the text of one frame's file. `width_px` and `height_px` only shape the camera's frame.
void append_povray_frame(std::string& text, const Model& model, const Drawing& drawing,
                         const CameraView& view);

// The text of scenes/<name>.ini: `povray <name>.ini` alone renders all `frame_count` frames at this size and
// quality, to the same names as mien's own driver (frames/f0001.png, ...).
std::string build_povray_ini(const RenderSpec& render, const std::string& name, int frame_count);

// The command-line options that stand for a quality (anti-aliasing, threads), in POV-Ray's own words.
std::vector<std::string> list_quality_options(Quality quality);

}  // namespace mien

// POV-Ray scenes: one include for what never changes in a clip, one small file a frame, one .ini for all.
// The only place that knows POV-Ray is left-handed: z is negated on the way out.
//
// scenes/head.inc    build_povray_stage: templates/povray/head.inc with materials, lights, background, parts
// scenes/h0001.inc   build_povray_parts: of a head that changes, for frame 1 and those after it that share it
// scenes/f0001.pov   append_povray_start, _figure: camera, vertices of what deforms, places of what is rigid
// scenes/loop.pov    build_povray_loop: the frame that POV-Ray's own animation loop asks for
// scenes/NAME.ini    build_povray_ini: `povray out/NAME/scenes/NAME.ini` renders them all
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/model.hpp"
#include "core/staging.hpp"
#include "core/templates.hpp"

namespace mien {

// Where the camera stands and what it frames, all in mien's own space (mm, right-handed).
struct CameraView {
  double angle_deg = 0;
  double height_deg = 0;
  double distance = 1;
  glm::vec3 look_at{0, -20, 0};  // mm, the middle of the framed box
  double frame_width_mm = 240;   // the box that distance 1 just fits, whatever the picture's shape
  double frame_height_mm = 300;
  double lens_mm = kPortraitLens_mm;  // how far off it stands to frame that, as film of 24 x 36 has it
  bool is_orthographic = false;       // without perspective; `distance` only moves the camera then
};

// Lines and words drawn over a head in a picture without perspective. They lie in space as meshes do: what
// stands before them hides them.
struct OverlayLine {
  std::vector<std::array<glm::vec3, 2>> segments;  // mm
  std::vector<std::array<glm::vec3, 2>> tips;      // of arrows: from the middle of a tip's back to its point
  double radius_mm = 0.5;                          // of the line; a tip's back is kTipWidth times as wide
  glm::vec3 srgb{0};
};
struct OverlayWords {
  std::string words;
  glm::vec3 at{0};  // mm, of the line they stand on: the left end, or as `align` says
  double size_mm = 8;
  glm::vec3 srgb{0};
  double align = 0;  // 0: `at` is their left end, 0.5: their middle, 1: their right end
};
inline constexpr double kTipWidth = 3.2;  // narrower tips look like ends of lines, wider ones like flags
struct Overlay {
  std::vector<OverlayLine> lines;
  std::vector<OverlayWords> words;
};

// How far the camera stands from the middle of the framed box at distance 1, mm.
double compute_camera_distance_mm(const CameraView& view);

// A colour of a part's palette as a call of its material's macro.
std::string format_povray_texture(const Part& part, const Shade& shade);

// Each part's shades, faces and (for rigid parts) vertices, as frames refer to them by the parts' names. A
// material is the macro NAME_texture(Colour, Gloss) of materials.inc; NAME_object(), where there is one, adds
// words to the object, such as no_shadow. A part with a picture names the file beside the scene that the
// picture is in. Throws RunError on an unknown material and a part that does not fit together.
std::string build_povray_parts(const Model& model, const Templates& templates);

// Light sets and backgrounds of templates/povray that frames name, besides the studio and the render's own.
struct StageSets {
  std::set<std::string> lights, backgrounds;
};

// The text of scenes/head.inc: materials, lights and background from templates/povray, quality
// settings, and `parts` of all models that never change in the clip. Throws RunError on a broken template and
// an unknown background.
std::string build_povray_stage(const std::string& parts, const RenderSpec& render, const Templates& templates,
                               const StageSets& sets = {});

// The stage with one model's parts.
std::string build_povray_include(const Model& model, const RenderSpec& render, const Templates& templates);

// What a frame's file begins with.
struct FrameStart {
  std::vector<std::string> includes;         // further files that hold parts, besides head.inc
  std::vector<LightShare> lights;            // none: the studio
  std::vector<BackgroundShare> backgrounds;  // none: the render's own
  CameraView view;
  std::optional<InkLamp> lamp = {};  // of ink, instead of lights; none: its own
};

// The picture's shape is not asked: POV-Ray fits the camera's box to it.
void append_povray_start(std::string& text, const FrameStart& start);

// Appends one drawing. `casters`, which may be null, has a mesh a part that throws its shadow instead of it,
// or has no triangles. Throws RunError if the drawing does not fit the model or holds a number that is not
// finite.
void append_povray_figure(std::string& text, const Model& model, const Drawing& drawing,
                          const std::vector<Mesh>* casters = nullptr);

// Appends the whole text of a frame's file with one figure whose parts head.inc holds.
void append_povray_frame(std::string& text, const Model& model, const Drawing& drawing,
                         const CameraView& view);

// Appends what is drawn over the head to a frame's file. The words face the camera of `view`, whose height is
// to be 0.
void append_povray_overlay(std::string& text, const Overlay& overlay, const CameraView& view);

// The text of scenes/loop.pov, which includes the scene of the frame that is being rendered ("f0007.pov").
std::string build_povray_loop();

// The text of scenes/<name>.ini: POV-Ray alone renders all `frame_count` frames at this size and quality to
// frames/f0001.png, ..., mien's own names. `clip_folder` holds scenes/ and frames/, as seen from the folder
// in which povray will be started ("out/hello"), since POV-Ray takes no path relative to an .ini. Of all
// these frames only those from `range.first` to `range.second` if scenes were written for no others.
std::string build_povray_ini(const RenderSpec& render, const std::string& name, int frame_count,
                             const std::filesystem::path& clip_folder, std::pair<int, int> range);

// The command-line options that stand for a picture's quality (anti-aliasing, dithering) and for an alpha
// channel if nothing lies behind, in POV-Ray's own words.
std::vector<std::string> list_quality_options(const RenderSpec& render);

}  // namespace mien

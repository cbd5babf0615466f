#include "exchange/export_rig.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "clip/rig_take.hpp"
#include "core/text.hpp"
#include "exchange/skin_paint.hpp"
#include "exchange/target_sets.hpp"
#include "frames/figure_atlas.hpp"
#include "render/work_folder.hpp"
#include "scene/gltf.hpp"
#include "scene/title.hpp"
#include "scene/usd.hpp"
#include "scene/vrm.hpp"

namespace mien {

namespace {

RiggedClip build_rig_of(const ExportWork& work) {
  RigTakeRequest request;
  request.fps = work.fps();
  request.from_s = work.compute_time_s(work.first);
  request.frames = work.frame_count();
  request.is_exact = work.options.is_exact;
  if (!work.options.is_exact) request.poses = build_target_set(work.options.targets, work.clip.spec);
  return build_rigged_clip(work.figure, work.performance, request);
}

ExportNotes note_rig(const RiggedClip& clip) {
  const RigError& error = clip.error;
  return {fmt::format("{} joints, {} targets, {} of them corrections; {} poses", clip.rig.joints.size(),
                      clip.rig.targets.size(), clip.corrections, clip.take.poses.size()),
          fmt::format(
              "at most {:.2g} mm from the face itself ({} at {:.2f} s), {:.2g} mm between poses; {:.2g} mm "
              "without corrections",
              error.worst_mm, error.worst_part.empty() ? "skin" : error.worst_part, error.worst_s,
              error.between_mm, error.uncorrected_mm)};
}

// The painted skin as it is, if there is one.
GltfPaint paint_skin(const ExportWork& work, const Atlas& atlas) {
  if (work.head.look.texture) return {0, atlas, read_file(work.head.look.texture->path)};
  return {0, atlas, build_png(bake_colours(work.figure.model.parts.front(), atlas, kPaintSize_px))};
}

}  // namespace

ExportNotes export_gltf(const ExportWork& work, const std::filesystem::path& path) {
  const RiggedClip clip = build_rig_of(work);
  const Atlas atlas = build_figure_atlas(work.figure);
  const GltfPaint paint = paint_skin(work, atlas);
  write_file(path, build_gltf({work.figure.model, clip.rig, clip.take, work.title(), &paint},
                              find_ending(path) == ".glb"));
  return note_rig(clip);
}

ExportNotes export_usd(const ExportWork& work, const std::filesystem::path& path) {
  const RiggedClip clip = build_rig_of(work);
  write_file(path, build_usd({work.figure.model, clip.rig, clip.take, work.title(), work.fps()}));
  return note_rig(clip);
}

ExportNotes export_script(const ExportWork& work, const std::filesystem::path& path) {
  const std::filesystem::path glb = find_companion(path);
  const std::string name = glb.filename().string();
  const ExportNotes notes = export_gltf(work, glb);
  write_file(path, fill_template(work.templates, "blender/setup.py",
                                 {{"title", clean_title(work.title())},
                                  {"glb", clean_title(name)},
                                  {"script", clean_title(path.filename().string())},
                                  {"glb_string", nlohmann::json(name).dump(-1, ' ', true)},
                                  {"fps", format_number(work.fps(), 3)},
                                  {"last_frame", std::to_string(work.frame_count() - 1)}}));
  return notes;
}

ExportNotes export_vrm(const ExportWork& work, const std::filesystem::path& path) {
  const Figure& figure = work.figure;
  const Spec& spec = work.clip.spec;
  FigureRigRequest request;
  request.poses = build_target_set("vrm", spec);
  request.neck_steps = 2;
  const FigureRig rig = build_figure_rig(figure, request);
  const Atlas atlas = build_figure_atlas(figure);
  const GltfPaint paint = paint_skin(work, atlas);
  VrmScene scene{figure.model, rig.rig, work.title(), spec.author, spec.licence, &paint};
  scene.eye_up_deg = glm::degrees(figure.face.eye_up_rad);
  scene.eye_down_deg = glm::degrees(figure.face.eye_down_rad);
  scene.eye_side_deg = glm::degrees(figure.face.eye_side_rad);
  scene.eyes_mm = figure.head.eye.centre * glm::dvec3(0, 1, 1) + glm::dvec3(0, 0, figure.head.eye.radius_mm);
  write_file(path, build_vrm(scene));
  return {fmt::format("{} expressions: {}", rig.rig.targets.size(), join_names(rig.rig.targets))};
}

}  // namespace mien

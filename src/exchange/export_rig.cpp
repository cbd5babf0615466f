#include "exchange/export_rig.hpp"

#include <fmt/format.h>

#include "clip/rig_take.hpp"
#include "core/text.hpp"
#include "render/work_folder.hpp"
#include "scene/gltf.hpp"

namespace mien {

namespace {

RiggedClip build_rig_of(const ExportWork& work) {
  RigTakeRequest request;
  request.fps = work.fps();
  request.from_s = work.compute_time_s(work.first);
  request.frames = work.frame_count();
  request.is_exact = work.options.is_exact;
  return build_rigged_clip(work.figure, work.performance, request);
}

ExportNotes note_rig(const RiggedClip& clip) {
  const RigError& error = clip.error;
  return {fmt::format("{} joints, {} targets, {} of them corrections; {} poses", clip.rig.joints.size(),
                      clip.rig.targets.size(), clip.corrections, clip.take.poses.size()),
          fmt::format("at most {:.2g} mm from the face itself ({} at {:.2f} s), {:.2g} mm between poses; {:.2g} mm "
                      "without corrections",
                      error.worst_mm, error.worst_part.empty() ? "skin" : error.worst_part, error.worst_s,
                      error.between_mm, error.uncorrected_mm)};
}

}  // namespace

ExportNotes export_gltf(const ExportWork& work, const std::filesystem::path& path) {
  const RiggedClip clip = build_rig_of(work);
  write_file(path, build_gltf({work.figure.model, clip.rig, clip.take, work.title()},
                              find_ending(path) == ".glb"));
  return note_rig(clip);
}

}  // namespace mien

// `mien render`.
#include "clip/beside.hpp"
#include "clip/outputs.hpp"
#include "clip/pictures.hpp"
#include "clip/scenes.hpp"
#include "commands/hold.hpp"
#include "commands/report.hpp"
#include "commands/sketch_clip.hpp"
#include "commands/table.hpp"
#include "core/data.hpp"
#include "core/text.hpp"
#include "render/process.hpp"

namespace mien {

namespace {

// Scenes and pictures of a clip, whose folder is held.
std::vector<WrittenScene> make_pictures(const Options& options, const Clip& clip, const Cast& cast,
                                        const Resources& resources) {
  report_starts(options, list_heads(clip), resources.heads);
  report_clip_held(options, clip, cast, resources.heads);
  const std::size_t count = clip.plan.drawings.size();

  Progress scenes = start_progress(options, "scenes", count);
  std::vector<WrittenScene> written = write_scenes(clip, cast, resources, count_jobs(options),
                                                   [&](int frame) { scenes.advance(false, frame); });
  scenes.finish();

  Progress frames = start_progress(options, "frames", count);
  render_pictures(clip, written, count_jobs(options),
                  [&](int frame, bool was_kept) { frames.advance(was_kept, frame); });
  frames.finish();
  return written;
}

void finish_clip(const Options& options, const Clip& clip, const std::vector<WrittenScene>& written) {
  write_file(clip.files.folder / "manifest.json", build_manifest(clip, written));
  write_clip_video(clip);
  report_result(options, "clip", find_video_path(clip));
  const std::filesystem::path poster = clip.files.folder / "poster.png";
  write_poster(clip, poster);
  report_result(options, "poster", poster);
}

void render_clip(const Options& options, const ClipParts& planned, const std::vector<Cast>& casts,
                 const Resources& resources) {
  const Clip& clip = planned.clip;
  if (planned.parts.empty()) {
    finish_clip(options, clip, make_pictures(options, clip, casts.front(), resources));
    return;
  }
  std::vector<std::vector<WrittenScene>> written;
  for (std::size_t i = 0; i < planned.parts.size(); ++i) {
    const FolderLock part_lock = hold_folder(options, planned.parts[i].files.folder);
    written.push_back(make_pictures(options, planned.parts[i], casts[i], resources));
  }
  const Clip whole = widen_clip(clip, planned.parts.size());
  const std::vector<WrittenScene> scenes = join_scenes(written);
  join_pictures(planned.parts, whole, scenes);
  finish_clip(options, whole, scenes);
}

void check_folders(const Options& options, const ClipParts& planned) {
  if (is_sketch(planned.clip.spec.render)) return check_sketch_folder(options, planned.clip);
  check_clip_folder(options, planned.clip, true);
  for (const Clip& part : planned.parts) check_clip_folder(options, part, true);
}

void run_render(const Options& options) {
  const Resources resources = load_resources(find_data_folder());
  const ClipParts planned = plan_parts(options, resources);
  check_folders(options, planned);
  const bool is_sketched = is_sketch(planned.clip.spec.render);
  if (!is_sketched) require_programs({{"povray", "povray"}});
  require_programs({{"ffmpeg", "ffmpeg"}, {"ffprobe", "ffmpeg"}});
  const std::vector<Cast> casts = build_casts(planned, resources.heads);
  const FolderLock lock = hold_folder(options, planned.clip.files.folder);
  if (is_sketched)
    sketch_clip(options, planned, casts, resources, nullptr);
  else
    render_clip(options, planned, casts, resources);
}

}  // namespace

const CommandInfo command_render{
    "render",
    "Pictures",
    "FILE",
    "scenes, frames and clip into out/NAME/",
    "Computes every drawing of the clip, has POV-Ray render it and ffmpeg join the frames. Frames that\n"
    "are right already are kept: after an interruption the same command goes on where it stopped. --beside\n"
    "puts the performance on several designs of the head, side by side. With --quality sketch mien draws\n"
    "the frames itself, in a fraction of the time, and leaves NAME_sketch.mp4 and nothing else.",
    "beside",
    "mien render configs/hello.yaml --quality sketch\nmien render configs/hello.yaml\n"
    "mien render configs/hello.yaml --quality draft --size 240x300\n"
    "mien render configs/unison.yaml --beside real,comic",
    run_render};

}  // namespace mien

// `mien render`.
#include "clip/outputs.hpp"
#include "clip/pictures.hpp"
#include "clip/scenes.hpp"
#include "commands/hold.hpp"
#include "commands/report.hpp"
#include "commands/table.hpp"
#include "core/data.hpp"
#include "core/text.hpp"
#include "render/process.hpp"

namespace mien {

namespace {

void run_render(const Options& options) {
  const Resources resources = load_resources(find_data_folder());
  const Clip clip = plan_clip(options, *resources.stock.language);
  check_clip_folder(options, clip, true);
  require_programs({{"povray", "povray"}, {"ffmpeg", "ffmpeg"}, {"ffprobe", "ffmpeg"}});
  const Cast cast = build_cast(clip, resources.heads);
  const FolderLock lock = hold_folder(options, clip.files.folder);
  report_starts(options, list_heads(clip), resources.heads);
  report_clip_held(options, clip, cast, resources.heads);
  const std::size_t count = clip.plan.drawings.size();

  Progress scenes = start_progress(options, "scenes", count);
  const std::vector<WrittenScene> written = write_scenes(clip, cast, resources, count_jobs(options),
                                                         [&](int frame) { scenes.advance(false, frame); });
  scenes.finish();

  Progress frames = start_progress(options, "frames", count);
  render_pictures(clip, written, count_jobs(options),
                  [&](int frame, bool was_kept) { frames.advance(was_kept, frame); });
  frames.finish();

  write_file(clip.files.folder / "manifest.json", build_manifest(clip, written));
  write_clip_video(clip);
  report_result(options, "clip", find_video_path(clip));
  const std::filesystem::path poster = clip.files.folder / "poster.png";
  write_poster(clip, poster);
  report_result(options, "poster", poster);
}

}  // namespace

const CommandInfo command_render{
    "render",
    "Pictures",
    "FILE",
    "scenes, frames and clip into out/NAME/",
    "Computes every drawing of the clip, has POV-Ray render it and ffmpeg join the frames. Frames that\n"
    "are right already are kept: after an interruption the same command goes on where it stopped.",
    "",
    "mien render configs/hello.yaml\nmien render configs/hello.yaml --quality draft --size 240x300",
    run_render};

}  // namespace mien

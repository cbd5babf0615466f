// `mien render`.
#include "clip/beside.hpp"
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

void run_render(const Options& options) {
  const Resources resources = load_resources(find_data_folder());
  const Clip clip = plan_clip(options, *resources.stock.language);
  check_clip_folder(options, clip, true);
  std::vector<Clip> parts;  // none: the clip itself
  for (const std::string& design : options.beside) {
    parts.push_back(redesign_clip(clip, design, resources.stock.head->designs));
    check_clip_folder(options, parts.back(), true);
  }
  require_programs({{"povray", "povray"}, {"ffmpeg", "ffmpeg"}, {"ffprobe", "ffmpeg"}});
  std::vector<Cast> casts;
  for (const Clip& part : parts.empty() ? std::vector<Clip>{clip} : parts)
    casts.push_back(build_cast(part, resources.heads));
  const FolderLock lock = hold_folder(options, clip.files.folder);
  if (parts.empty()) {
    finish_clip(options, clip, make_pictures(options, clip, casts.front(), resources));
    return;
  }
  std::vector<std::vector<WrittenScene>> written;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const FolderLock part_lock = hold_folder(options, parts[i].files.folder);
    written.push_back(make_pictures(options, parts[i], casts[i], resources));
  }
  const Clip whole = widen_clip(clip, parts.size());
  const std::vector<WrittenScene> scenes = join_scenes(written);
  join_pictures(parts, whole, scenes);
  finish_clip(options, whole, scenes);
}

}  // namespace

const CommandInfo command_render{
    "render",
    "Pictures",
    "FILE",
    "scenes, frames and clip into out/NAME/",
    "Computes every drawing of the clip, has POV-Ray render it and ffmpeg join the frames. Frames that\n"
    "are right already are kept: after an interruption the same command goes on where it stopped. --beside\n"
    "puts the performance on several designs of the head, side by side.",
    "beside",
    "mien render configs/hello.yaml\nmien render configs/hello.yaml --quality draft --size 240x300\n"
    "mien render configs/unison.yaml --beside real,comic",
    run_render};

}  // namespace mien

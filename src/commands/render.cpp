// `mien render`.
#include "clip/beside.hpp"
#include "clip/outputs.hpp"
#include "clip/pictures.hpp"
#include "clip/scenes.hpp"
#include "clip/sketches.hpp"
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

// The same clip through POV-Ray's: scenes, pictures, video.
void render_clip(const Options& options, const Clip& clip, const std::vector<Clip>& parts,
                 const std::vector<Cast>& casts, const Resources& resources) {
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

// The clip without POV-Ray and without a picture on the disk.
void sketch_clip(const Options& options, const Clip& clip, const std::vector<Clip>& parts,
                 const std::vector<Cast>& casts, const Resources& resources) {
  std::vector<Staged> staged;
  for (std::size_t i = 0; i < casts.size(); ++i) {
    staged.push_back({parts.empty() ? &clip : &parts[i], &casts[i]});
    report_starts(options, list_heads(*staged.back().clip), resources.heads);
    report_clip_held(options, *staged.back().clip, casts[i], resources.heads);
  }
  const Clip whole = widen_clip(clip, staged.size());
  Progress progress = start_progress(options, "sketches", whole.plan.drawings.size());
  SketchVideo video = start_sketch_video(whole);
  sketch_drawings(staged, resources, count_jobs(options), [&](std::size_t drawing, const Pixels& picture) {
    append_drawing(video, drawing, picture);
    progress.advance(false, whole.plan.drawings[drawing]);
  });
  progress.finish();
  finish_video(video.stream);
  write_file(whole.files.folder / kSketchManifest, build_sketch_manifest(whole));
  report_result(options, "clip", find_video_path(whole));
}

void run_render(const Options& options) {
  const Resources resources = load_resources(find_data_folder());
  const Clip clip = plan_clip(options, *resources.stock.language);
  const bool is_sketched = is_sketch(clip.spec.render);
  const auto check_folder = [&](const Clip& part) {
    is_sketched ? check_sketch_folder(options, part) : check_clip_folder(options, part, true);
  };
  check_folder(clip);
  std::vector<Clip> parts;  // none: the clip itself
  for (const std::string& design : options.beside) {
    parts.push_back(redesign_clip(clip, design, resources.stock.head->designs));
    if (!is_sketched) check_folder(parts.back());
  }
  if (!is_sketched) require_programs({{"povray", "povray"}});
  require_programs({{"ffmpeg", "ffmpeg"}, {"ffprobe", "ffmpeg"}});
  std::vector<Cast> casts;
  for (const Clip& part : parts.empty() ? std::vector<Clip>{clip} : parts)
    casts.push_back(build_cast(part, resources.heads));
  const FolderLock lock = hold_folder(options, clip.files.folder);
  (is_sketched ? sketch_clip : render_clip)(options, clip, parts, casts, resources);
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

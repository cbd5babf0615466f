// `mien render`.
#include <fmt/format.h>
#include <cstdio>

#include "clip/beside.hpp"
#include "clip/outputs.hpp"
#include "clip/pictures.hpp"
#include "clip/scenes.hpp"
#include "clip/sound.hpp"
#include "clip/trace.hpp"
#include "commands/farm_clip.hpp"
#include "commands/hold.hpp"
#include "commands/report.hpp"
#include "commands/sketch_clip.hpp"
#include "commands/table.hpp"
#include "core/data.hpp"
#include "core/error.hpp"
#include "core/streams.hpp"
#include "core/text.hpp"
#include "render/process.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

constexpr const char* kPoster = "poster.png";
constexpr std::size_t kWorthPreview = 24;  // pictures to trace; fewer are there soon

void report_plan(const Options& options, const Clip& clip, std::size_t missing) {
  if (options.is_quiet) return;
  if (options.is_json)
    return write_stream(stderr, format_object({{"event", "plan"},
                                               {"frames", clip.plan.frames.size()},
                                               {"drawings", clip.plan.drawings.size()},
                                               {"to_trace", missing}}) +
                                    "\n");
  const auto count = [](std::size_t number, const char* what) {
    return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
  };
  write_stream(stderr, fmt::format("{}, {}, {} to trace\n", count(clip.plan.frames.size(), "frame"),
                                   count(clip.plan.drawings.size(), "drawing"), missing));
}

// It is there for as long as the work goes on: no result.
void report_preview(const Options& options, const fs::path& path) {
  if (options.is_quiet) return;
  write_stream(stderr, options.is_json ? format_object({{"event", "preview"}, {"path", path.string()}}) + "\n"
                                       : fmt::format("preview: {}\n", path.string()));
}

// Pictures of a clip, whose folder is held; the keys of its drawings. The plan of a farm is in `plan_folder`.
std::vector<std::string> make_pictures(const Options& options, const Clip& clip, const Cast& cast,
                                       const Resources& resources, const fs::path& plan_folder) {
  report_starts(options, list_heads(clip), resources.heads);
  report_clip_held(options, clip, cast, resources.heads);
  const int jobs = count_jobs(options);
  const std::size_t count = clip.plan.drawings.size();
  std::error_code ignored;
  for (const fs::path& stale : find_stale_files(clip.files, clip.frame_count)) fs::remove(stale, ignored);

  Progress scenes = start_progress(options, "scenes", count);
  const auto computed = [&](int frame) { scenes.advance(false, frame); };
  TraceRun run{{clip, cast, resources, jobs},
               find_store(clip, options.store_bytes.value_or(PictureStore::kStoreBytes)),
               {},
               {}};
  if (options.has_scenes)
    run.keys = write_scenes(clip, cast, resources, jobs, computed);
  else
    compute_keys(run, jobs, computed);
  scenes.finish();
  find_pictures(run);
  const std::size_t missing = count_missing(run);
  report_plan(options, clip, missing);
  if (options.farm.is_gathering) check_gathered(run, plan_folder, missing);

  Progress frames = start_progress(options, "frames", count);
  TraceHooks hooks{[&](int frame, bool was_kept) { frames.advance(was_kept, frame); }};
  const fs::path preview = find_preview_path(clip);
  if (missing >= kWorthPreview)
    hooks.pass_ended = [&](const std::vector<bool>& is_there) {
      write_preview(clip, is_there);
      write_poster(clip, clip.files.folder / kPoster);
      frames.clear();
      report_preview(options, preview);
    };
  trace_pictures(run, jobs, hooks);
  frames.finish();
  fs::remove(preview, ignored);
  return run.keys;
}

void finish_clip(const Options& options, const Clip& clip, const Resources& resources,
                 const std::vector<std::string>& keys) {
  write_file(clip.files.folder / "manifest.json", build_manifest(clip, keys));
  write_clip_videos(clip, find_letters(resources.stock.templates));
  for (const fs::path& video : list_video_paths(clip)) report_result(options, "clip", video);
  const fs::path poster = clip.files.folder / kPoster;
  write_poster(clip, poster);
  report_result(options, "poster", poster);
}

void render_clip(const Options& options, const ClipParts& planned, const std::vector<Cast>& casts,
                 const Resources& resources) {
  const Clip& clip = planned.clip;
  if (planned.parts.empty()) {
    finish_clip(options, clip, resources,
                make_pictures(options, clip, casts.front(), resources, clip.files.folder));
    return;
  }
  std::vector<std::vector<std::string>> keys;
  for (std::size_t i = 0; i < planned.parts.size(); ++i) {
    const FolderLock part_lock = hold_folder(options, planned.parts[i].files.folder);
    keys.push_back(make_pictures(options, planned.parts[i], casts[i], resources, clip.files.folder));
  }
  const Clip whole = widen_clip(clip, planned.parts.size());
  const std::vector<std::string> joined = join_keys(keys);
  join_pictures(planned.parts, whole, joined);
  finish_clip(options, whole, resources, joined);
}

void check_folders(const Options& options, const ClipParts& planned) {
  if (is_sketch(planned.clip.spec.render)) return check_sketch_folder(options, planned.clip);
  check_clip_folder(options, planned.clip, true);
  for (const Clip& part : planned.parts) check_clip_folder(options, part, true);
}

// Sketches are sooner drawn than a cluster has begun.
void check_no_farm(const Options& options) {
  if (options.farm.engine == Engine::slurm || options.farm.part || options.farm.is_gathering)
    throw InputError(
        "--engine slurm is for pictures of POV-Ray; the quality is sketch, expected draft, good or best");
}

// Who has others render needs no more than what asks them.
bool needs_ffmpeg(const Options& options) {
  return options.farm.engine == Engine::local && !options.farm.part;
}

void require_tools(const Options& options, bool is_sketched) {
  if (options.farm.engine == Engine::slurm) {
    if (options.farm.is_dry_run) return;
    for (const char* program : {"sbatch", "squeue", "scancel", "scontrol"})
      require_programs({{program, "slurm-client"}});
    return;
  }
  if (!is_sketched) require_programs({{"povray", "povray"}});
  if (needs_ffmpeg(options)) require_programs({{"ffmpeg", "ffmpeg"}, {"ffprobe", "ffmpeg"}});
}

void run_render(const Options& asked) {
  const Options options = take_videos(asked);
  if (options.nice) let_others_first(*options.nice);
  const Resources resources = load_resources(find_data_folder());
  const ClipParts planned = plan_parts(options, resources);
  check_folders(options, planned);
  const bool is_sketched = is_sketch(planned.clip.spec.render);
  if (is_sketched) check_no_farm(options);
  require_tools(options, is_sketched);
  if (needs_ffmpeg(options)) check_sound(planned.clip);
  const std::vector<Cast> casts = build_casts(planned, resources.heads);
  if (options.farm.engine == Engine::slurm) return farm_clip(options, planned, casts, resources);
  if (options.farm.part) return farm_part(options, planned, casts, resources);
  const FolderLock lock = hold_folder(options, planned.clip.files.folder);
  if (is_sketched)
    sketch_clip(options, planned, casts, resources, nullptr);
  else
    render_clip(options, planned, casts, resources);
  if (options.farm.is_gathering) tell_gathered(planned.clip.files.folder);
}

}  // namespace

const CommandInfo command_render{
    "render",
    "Pictures",
    "FILE",
    "frames and clip into out/NAME/",
    "Computes every drawing of the clip, has POV-Ray trace it and ffmpeg join the frames. What was traced\n"
    "once is kept in a store: after an interruption the same command goes on where it stopped, and keys\n"
    "that are moved, repeated or cut trace nothing that exists. --beside puts the performance on several\n"
    "designs of the head, side by side. With --quality sketch mien draws the frames itself, in a fraction\n"
    "of the time, and leaves NAME_sketch.mp4 and nothing else. -o names the folder, or the clip itself by\n"
    "its ending: .mp4, .webm, .mov (ProRes 4444), .gif, .webp or .apng; several clips may be asked for.\n"
    "With background: none in the file's render: frames and clips are transparent, but .mp4, which is white.",
    "loop boomerang slate nice beside keep-scenes store engine partition chunk time no-wait dry-run part",
    "mien render configs/hello.yaml --quality sketch\nmien render configs/hello.yaml\n"
    "mien render configs/hello.yaml --quality draft --size 240x300\n"
    "mien render configs/hello.yaml -o hello.webm -o hello.gif\n"
    "mien render configs/unison.yaml --beside real,comic",
    run_render};

}  // namespace mien

// `mien frames`.
#include "clip/outputs.hpp"
#include "clip/scenes.hpp"
#include "commands/hold.hpp"
#include "commands/report.hpp"
#include "commands/table.hpp"
#include "core/data.hpp"
#include "core/error.hpp"

namespace mien {

namespace {

void run_frames(const Options& options) {
  const Resources resources = load_resources(find_data_folder());
  const Clip clip = plan_clip(options, *resources.stock.language);
  if (is_sketch(clip.spec.render))
    throw InputError(
        "quality 'sketch' is mien's own drawing, without scenes; expected --quality draft, good or best");
  check_clip_folder(options, clip, false);
  const Cast cast = build_cast(clip, resources.heads);
  const FolderLock lock = hold_folder(options, clip.files.folder);
  report_starts(options, list_heads(clip), resources.heads);
  report_clip_held(options, clip, cast, resources.heads);
  Progress progress = start_progress(options, "scenes", clip.plan.drawings.size());
  write_scenes(clip, cast, resources, count_jobs(options),
               [&](int frame) { progress.advance(false, frame); });
  progress.finish();
  report_result(options, "scenes", clip.files.scenes());
}

}  // namespace

const CommandInfo command_frames{
    "frames",
    "Pictures",
    "FILE",
    "scenes only, for POV-Ray alone",
    "Writes the scenes and an .ini that POV-Ray alone renders to the same frames.",
    "",
    "mien frames configs/hello.yaml && povray out/hello/scenes/hello.ini",
    run_frames};

}  // namespace mien

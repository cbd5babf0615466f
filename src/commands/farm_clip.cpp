#include "commands/farm_clip.hpp"

#include <fmt/format.h>

#include "clip/pictures.hpp"
#include "commands/farm_jobs.hpp"
#include "commands/report.hpp"
#include "core/clock.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostTasksUnasked = 1000;  // where nobody can be asked: Slurm's default
constexpr std::size_t kMostNamed = 20;           // frames that a message names

void report_farm_plan(const Options& options, const Clip& clip, const Farm& farm, std::size_t drawings) {
  say_event(
      options,
      {{"event", "plan"},
       {"frames", clip.plan.frames.size()},
       {"drawings", drawings},
       {"to_trace", farm.missing}},
      fmt::format("{} frames, {} drawings, {} to trace", clip.plan.frames.size(), drawings, farm.missing));
}

// Scripts may be wanted where no cluster is.
std::size_t find_most_tasks_here(const Options& options) {
  if (!options.farm.is_dry_run) return ask_most_tasks();
  try {
    return ask_most_tasks();
  } catch (const RunError&) {
    return kMostTasksUnasked;
  }
}

}  // namespace

void farm_clip(const Options& options, const ClipParts& planned, const std::vector<Cast>& casts,
               const Resources& resources) {
  const std::size_t most_tasks = find_most_tasks_here(options);
  const std::vector<FarmClip> clips = list_farm_clips(planned, casts);
  Options telling = options;
  telling.is_quiet |= options.farm.is_dry_run;  // the scripts are all that is to be read
  std::size_t total = 0;
  for (const FarmClip& each : clips) {
    report_starts(telling, list_heads(*each.clip), resources.heads);
    report_clip_held(telling, *each.clip, *each.cast, resources.heads);
    total += each.clip->plan.drawings.size();
  }
  Progress scenes = start_progress(telling, "scenes", total);
  std::vector<FarmDrawing> drawings = list_farm_drawings(clips, resources, count_jobs(options),
                                                         [&](int frame) { scenes.advance(false, frame); });
  scenes.finish();
  const Farm farm = plan_farm(options, planned, drawings, most_tasks);
  if (options.farm.is_dry_run) return print_farm(farm);
  report_farm_plan(options, planned.clip, farm, total);
  const SlurmJobs jobs = ensure_jobs(options, farm);
  if (!options.farm.has_wait)
    return say_event(options, {{"event", "left"}, {"jobs", jobs.numbers()}}, describe_going_on(jobs));
  await_clip(options, farm, clips, drawings, jobs);
  for (const fs::path& video : list_video_paths(planned.clip)) report_result(options, "clip", video);
  report_result(options, "poster", planned.clip.files.folder / "poster.png");
}

void farm_part(const Options& options, const ClipParts& planned, const std::vector<Cast>& casts,
               const Resources& resources) {
  const FarmFiles files(planned.clip.files.folder);
  const PartPlan plan = read_part_plan(files.plan());
  const auto [part, count] = *options.farm.part;
  if (static_cast<std::size_t>(count) != plan.parts.size())
    throw RunError(fmt::format("{} has {} parts; expected {}, as --part {}/{} says; submit again",
                               files.plan().string(), plan.parts.size(), count, part, count));
  const std::vector<PartDrawing>& drawings = plan.parts[static_cast<std::size_t>(part) - 1];
  const int jobs = count_jobs(options);
  const double begun_s = read_clock_s();
  int traced = 0;
  Progress frames = start_progress(options, "frames", drawings.size());
  trace_part(drawings, list_farm_clips(planned, casts), resources, jobs, files.work(part),
             [&](int frame, bool was_kept) {
               frames.advance(was_kept, frame);
               traced += was_kept ? 0 : 1;
             });
  frames.finish();
  std::error_code ignored;
  fs::remove(files.work(part), ignored);  // it is empty
  const Clip& clip = planned.parts.empty() ? planned.clip : planned.parts.front();
  if (traced > 0)
    write_file(files.cost(), build_drawing_cost(describe_drawing_kind(clip.spec.render),
                                                (read_clock_s() - begun_s) * jobs / traced));
}

void check_gathered(const TraceRun& run, const fs::path& clip_folder, std::size_t missing) {
  const FarmFiles files(clip_folder);
  if (missing <= read_part_plan(files.plan()).size) return;
  std::string frames;
  std::size_t named = 0, count = 0;
  for (std::size_t i = 0; i < run.is_there.size(); ++i) {
    if (run.is_there[i]) continue;
    if (++count <= kMostNamed)
      frames += fmt::format("{}{}", named++ > 0 ? ", " : "", run.scenes.clip.plan.drawings[i]);
  }
  if (count > named) frames += fmt::format(" and {} more", count - named);
  throw RunError(fmt::format(
      "{} of {} drawings are missing: frame{} {}; why is in the logs of the tasks, {}; run again to go on",
      count, run.is_there.size(), count == 1 ? "" : "s", frames, (files.folder / "*.log").string()));
}

void tell_gathered(const fs::path& clip_folder) {
  const FarmFiles files(clip_folder);
  const PartPlan plan = read_part_plan(files.plan());
  remove_work(files, plan.parts.size());
  write_file(files.done(), plan.identity + "\n");
}

}  // namespace mien

#include "commands/farm_clip.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <set>
#include <sstream>
#include <thread>

#include "clip/farm.hpp"
#include "clip/pictures.hpp"
#include "commands/farm_words.hpp"
#include "commands/hold.hpp"
#include "commands/report.hpp"
#include "core/clock.hpp"
#include "core/error.hpp"
#include "core/streams.hpp"
#include "core/text.hpp"
#include "render/process.hpp"
#include "render/slurm.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

constexpr double kChunk_s = 300;  // a task's start costs some seconds, and no scheduler likes many short ones
constexpr std::size_t kMostTasksUnasked = 1000;  // where nobody can be asked: Slurm's default
constexpr double kLook_s = 1;                    // between two looks into the store
constexpr double kAsk_s = 5;                     // between two questions to the scheduler, which serves many
constexpr double kSilent_s = 600;                // after which a scheduler that does not answer is given up
constexpr double kLate_s = 20;          // what a network disk may take to show a file of another machine
constexpr std::size_t kMostNamed = 20;  // frames that a message names

std::vector<FarmClip> list_farm_clips(const ClipParts& planned, const std::vector<Cast>& casts) {
  std::vector<FarmClip> clips;
  if (planned.parts.empty()) clips.push_back({&planned.clip, &casts.front()});
  for (std::size_t i = 0; i < planned.parts.size(); ++i) clips.push_back({&planned.parts[i], &casts[i]});
  return clips;
}

void say(const Options& options, const nlohmann::ordered_json& event, const std::string& words) {
  if (options.is_quiet) return;
  write_stream(stderr, (options.is_json ? format_object(event) : words) + "\n");
}

// "job 13", "jobs 12 and 13".
std::string name_jobs(const SlurmJobs& jobs) {
  const std::vector<std::string> numbers = jobs.numbers();
  return fmt::format("job{} {}", numbers.size() == 1 ? "" : "s", fmt::join(numbers, " and "));
}

// What is submitted, ready to be.
struct Farm {
  FarmFiles files;
  PartPlan plan;
  std::size_t missing = 0;
  SlurmScript tasks, clip;
};

std::size_t count_part_size(const Options& options, const Clip& clip, const FarmFiles& files) {
  if (options.farm.chunk_drawings) return static_cast<std::size_t>(*options.farm.chunk_drawings);
  const RenderSpec& render = clip.spec.render;
  double drawing_s = read_drawing_cost_s(files.cost(), describe_drawing_kind(render));
  if (drawing_s <= 0) drawing_s = guess_drawing_s(render);
  const double drawings = options.farm.chunk_s.value_or(kChunk_s) * std::max(options.jobs, 1) / drawing_s;
  return static_cast<std::size_t>(std::max(1.0, std::floor(drawings)));
}

// "8 tasks of 6 drawings", "3 tasks of 3 to 4 drawings".
std::string describe_parts(const PartPlan& plan) {
  if (plan.parts.empty()) return "no tasks";
  const std::size_t most = plan.parts.front().size(), least = plan.parts.back().size();
  return fmt::format("{} task{} of {} drawing{}", plan.parts.size(), plan.parts.size() == 1 ? "" : "s",
                     least == most ? fmt::format("{}", most) : fmt::format("{} to {}", least, most),
                     most == 1 ? "" : "s");
}

Farm plan_farm(const Options& options, const ClipParts& planned, const std::vector<FarmDrawing>& drawings,
               std::size_t most_tasks) {
  const fs::path folder = planned.clip.files.folder;
  const FarmWords words = list_farm_words(options);
  Farm farm{FarmFiles(folder), {}, 0, {}, {}};
  const Clip& first = planned.parts.empty() ? planned.clip : planned.parts.front();
  farm.plan = plan_parts_of(drawings, count_part_size(options, first, farm.files), most_tasks, words.asked);
  for (const auto& part : farm.plan.parts) farm.missing += part.size();

  SlurmScript job;
  job.name = name_farm_jobs(planned.clip.files.name, fs::absolute(folder));
  job.folder = fs::current_path();
  job.cores = std::max(options.jobs, 1);
  job.partition = options.farm.partition;
  job.time_limit = options.farm.time_limit;
  farm.tasks = farm.clip = job;
  const fs::path logs = fs::absolute(farm.files.folder).lexically_normal();
  farm.tasks.log = logs / "%a.log";
  farm.tasks.tasks = farm.plan.parts.size();
  farm.tasks.note = fmt::format("{}: each traces its part of plan.json", describe_parts(farm.plan));
  farm.tasks.command = words.tasks;
  farm.tasks.command.insert(farm.tasks.command.end(),
                            {"--part", fmt::format("{}/{}", kTask, farm.plan.parts.size())});
  farm.clip.name += "_clip";
  farm.clip.log = logs / farm.files.clip_log().filename();
  farm.clip.note = "when all tasks have ended: looks whether every drawing is there, and makes the clip";
  farm.clip.command = words.clip;
  farm.clip.command.insert(farm.clip.command.end(), {"--part", "gather"});
  return farm;
}

void print_farm(const Farm& farm) {
  const auto print = [](const fs::path& path, const SlurmScript& script) {
    fmt::print("# {}\n{}\n", path.string(), build_slurm_script(script));
  };
  const bool has_tasks = !farm.plan.parts.empty();
  if (has_tasks) print(farm.files.tasks_script(), farm.tasks);
  print(farm.files.clip_script(), farm.clip);
  if (has_tasks) fmt::print("# sbatch --parsable {}\n", quote_word(farm.files.tasks_script().string()));
  fmt::print("# sbatch --parsable {}{}\n", has_tasks ? "--dependency=afterany:JOB " : "",
             quote_word(farm.files.clip_script().string()));
}

bool is_same_plan(const Farm& farm) {
  std::error_code ignored;
  if (!fs::is_regular_file(farm.files.plan(), ignored)) return false;
  return read_part_plan(farm.files.plan()).identity == farm.plan.identity;
}

// Until nothing of an earlier call can begin any more.
void cancel_and_wait(const Options& options, const Farm& farm, const SlurmJobs& jobs) {
  say(options, {{"event", "cancelled"}, {"jobs", jobs.numbers()}},
      fmt::format("cancelled {} of an earlier call, which asked for something else", name_jobs(jobs)));
  cancel_slurm_jobs(jobs.numbers());
  const double begun_s = read_clock_s();
  while (find_slurm_jobs(farm.tasks.name, farm.clip.name).is_there()) {
    if (read_clock_s() - begun_s > kSilent_s)
      throw RunError(
          fmt::format("{} of an earlier call will not end; look with: squeue --me", name_jobs(jobs)));
    throw_if_interrupted();
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
  }
}

// What tasks that were killed left half-made.
void remove_work(const FarmFiles& files, std::size_t parts) {
  std::error_code ignored;
  for (std::size_t part = 1; part <= parts; ++part)
    fs::remove_all(files.work(static_cast<int>(part)), ignored);
}

// Logs are appended to, as a task may begin anew elsewhere: those of an earlier call go.
void write_farm(const Farm& farm) {
  std::error_code ignored;
  fs::remove(farm.files.done(), ignored);
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(farm.files.folder, ignored))
    if (entry.path().extension() == ".log" && is_farm_file(entry.path().filename().string()))
      old.push_back(entry.path());
  for (const fs::path& log : old) fs::remove(log, ignored);
  write_file(farm.files.plan(), build_part_plan(farm.plan));
  write_file(farm.files.tasks_script(), build_slurm_script(farm.tasks));
  write_file(farm.files.clip_script(), build_slurm_script(farm.clip));
}

// The plan lies there, and nobody else of ours writes one now.
SlurmJobs submit_farm(const Options& options, const Farm& farm) {
  SlurmJobs jobs;
  {
    const FolderLock lock(farm.files.folder.parent_path());
    if (find_slurm_jobs(farm.tasks.name, farm.clip.name).is_there())
      throw RunError(fmt::format("{}: another call has just submitted jobs for this folder",
                                 farm.files.folder.parent_path().string()));
    write_farm(farm);
    if (!farm.plan.parts.empty()) jobs.tasks = submit_script(farm.tasks, farm.files.tasks_script(), {});
  }
  jobs.clip = submit_script(farm.clip, farm.files.clip_script(), jobs.tasks);
  const std::string array =
      jobs.tasks.empty() ? "" : fmt::format("job {}, {}, and ", jobs.tasks, describe_parts(farm.plan));
  say(options,
      {{"event", "submitted"}, {"tasks", farm.plan.parts.size()}, {"array", jobs.tasks}, {"clip", jobs.clip}},
      fmt::format("submitted {}job {}, which makes the clip; logs in {}", array, jobs.clip,
                  farm.files.folder.string()));
  return jobs;
}

// How to look, to cancel and to go on.
std::string describe_going_on(const SlurmJobs& jobs) {
  const std::vector<std::string> numbers = jobs.numbers();
  return fmt::format(
      "look with: squeue -j {}; cancel with: scancel {}; wait for the clip with the same command",
      fmt::join(numbers, ","), fmt::join(numbers, " "));
}

// The jobs that make this clip: those of an earlier call, or new ones.
SlurmJobs ensure_jobs(const Options& options, const Farm& farm) {
  SlurmJobs jobs = find_slurm_jobs(farm.tasks.name, farm.clip.name);
  if (jobs.is_there() && is_same_plan(farm)) {
    if (jobs.clip.empty()) jobs.clip = submit_script(farm.clip, farm.files.clip_script(), jobs.tasks);
    say(options, {{"event", "found"}, {"array", jobs.tasks}, {"clip", jobs.clip}},
        fmt::format("going on with {} of an earlier call", name_jobs(jobs)));
    return jobs;
  }
  if (jobs.is_there()) cancel_and_wait(options, farm, jobs);
  return submit_farm(options, farm);
}

// Names in the stores of these clips.
std::vector<std::set<std::string>> list_stores(const std::vector<FarmClip>& clips) {
  std::vector<std::set<std::string>> stores;
  for (const FarmClip& each : clips) {
    std::set<std::string>& names = stores.emplace_back();
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(find_store(*each.clip).folder, ignored))
      names.insert(entry.path().filename().string());
  }
  return stores;
}

// Counts what has come into the stores; `drawings` know what is there.
void count_new(const std::vector<FarmClip>& clips, std::vector<FarmDrawing>& drawings, Progress& frames) {
  const std::vector<std::set<std::string>> stores = list_stores(clips);
  for (FarmDrawing& each : drawings) {
    if (each.is_there) continue;
    each.is_there = stores[static_cast<std::size_t>(each.drawing.clip)].contains(each.drawing.key + ".png");
    if (each.is_there) frames.advance(false, each.drawing.frame);
  }
}

bool has_ended_well(const Farm& farm) {
  std::error_code ignored;
  // Listing a folder asks a network disk for what is new in it; asking for one file may not.
  for (const auto& entry : fs::directory_iterator(farm.files.folder, ignored))
    if (entry.path().filename() == farm.files.done().filename())
      return read_file(entry.path()) == farm.plan.identity + "\n";
  return false;
}

// The last lines that the last job said.
std::string read_log_end(const fs::path& log) {
  constexpr std::size_t kMost = 12;  // lines
  std::error_code ignored;
  if (!fs::is_regular_file(log, ignored))
    return fmt::format("\n  there is no {}: do all machines of the cluster have this folder?", log.string());
  std::istringstream in(read_file(log));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  std::string text = fmt::format("\n  {} ends with:", log.string());
  for (std::size_t i = lines.size() - std::min(lines.size(), kMost); i < lines.size(); ++i)
    text += "\n  " + lines[i];
  return text;
}

void tell_not_made(const Farm& farm, const std::vector<FarmDrawing>& drawings, const SlurmJobs& jobs) {
  const auto missing =
      std::ranges::count_if(drawings, [](const FarmDrawing& each) { return !each.is_there; });
  throw RunError(fmt::format("{} ended without the clip; {} of {} drawings are missing; run again to go on{}",
                             name_jobs(jobs), missing, drawings.size(), read_log_end(farm.files.clip_log())));
}

// Tells why nothing has begun, once for each reason.
void tell_waiting(const Options& options, const SlurmJobs& state, Progress& frames, std::string& told) {
  if (state.running > 0 || state.reason.empty() || state.reason == told || state.reason == "None" ||
      state.reason == "Dependency")
    return;
  told = state.reason;
  frames.clear();
  say(options, {{"event", "waiting"}, {"reason", told}}, fmt::format("waiting for the cluster: {}", told));
}

// Until the jobs have ended.
void watch_jobs(const Options& options, const Farm& farm, const std::vector<FarmClip>& clips,
                std::vector<FarmDrawing>& drawings, Progress& frames) {
  double asked_s = read_clock_s(), heard_s = asked_s;
  std::string told;
  while (true) {
    for (double begun_s = read_clock_s(); read_clock_s() - begun_s < kLook_s;) {
      throw_if_interrupted();
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    count_new(clips, drawings, frames);
    const bool is_made = has_ended_well(farm);
    if (!is_made && read_clock_s() - asked_s < kAsk_s) continue;
    asked_s = read_clock_s();
    try {
      const SlurmJobs state = find_slurm_jobs(farm.tasks.name, farm.clip.name);
      heard_s = asked_s;
      if (is_made || !state.is_there()) return;
      tell_waiting(options, state, frames, told);
    } catch (const RunError& error) {  // a controller that restarts is back in minutes
      if (asked_s - heard_s > kSilent_s) throw;
    }
  }
}

void await_clip(const Options& options, const Farm& farm, const std::vector<FarmClip>& clips,
                std::vector<FarmDrawing>& drawings, const SlurmJobs& jobs) {
  Progress frames = start_progress(options, "frames", drawings.size());
  for (const FarmDrawing& each : drawings)
    if (each.is_there) frames.advance(true, each.drawing.frame);
  try {
    watch_jobs(options, farm, clips, drawings, frames);
  } catch (const Interrupted&) {
    frames.clear();
    throw Interrupted(fmt::format("interrupted; the jobs go on; {}", describe_going_on(jobs)));
  }
  for (const double begun_s = read_clock_s(); !has_ended_well(farm) && read_clock_s() - begun_s < kLate_s;) {
    std::error_code ignored;
    if (fs::is_regular_file(farm.files.clip_log(), ignored) &&
        read_file(farm.files.clip_log()).find("error: ") != std::string::npos)
      break;
    throw_if_interrupted();
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
  count_new(clips, drawings, frames);
  frames.clear();
  if (!has_ended_well(farm)) tell_not_made(farm, drawings, jobs);
  frames.finish();
}

void report_farm_plan(const Options& options, const Clip& clip, const Farm& farm, std::size_t drawings) {
  say(options,
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
    return say(options, {{"event", "left"}, {"jobs", jobs.numbers()}}, describe_going_on(jobs));
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

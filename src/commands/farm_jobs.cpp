#include "commands/farm_jobs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <sstream>
#include <thread>

#include "clip/pictures.hpp"
#include "commands/hold.hpp"
#include "commands/report.hpp"
#include "core/clock.hpp"
#include "core/error.hpp"
#include "core/streams.hpp"
#include "core/text.hpp"
#include "render/process.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

constexpr double kLook_s = 1;      // between two looks into the store
constexpr double kAsk_s = 5;       // between two questions to the scheduler, which serves many
constexpr double kSilent_s = 600;  // after which a scheduler that does not answer is given up
constexpr double kLate_s = 20;     // what a network disk may take to show a file of another machine

// "job 13", "jobs 12 and 13".
std::string name_jobs(const SlurmJobs& jobs) {
  const std::vector<std::string> numbers = jobs.numbers();
  return fmt::format("job{} {}", numbers.size() == 1 ? "" : "s", fmt::join(numbers, " and "));
}

// Until nothing of an earlier call can begin any more.
void cancel_and_wait(const Options& options, const Farm& farm, const SlurmJobs& jobs) {
  say_event(options, {{"event", "cancelled"}, {"jobs", jobs.numbers()}},
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
  say_event(
      options,
      {{"event", "submitted"}, {"tasks", farm.plan.parts.size()}, {"array", jobs.tasks}, {"clip", jobs.clip}},
      fmt::format("submitted {}job {}, which makes the clip; logs in {}", array, jobs.clip,
                  farm.files.folder.string()));
  return jobs;
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
  say_event(options, {{"event", "waiting"}, {"reason", told}},
            fmt::format("waiting for the cluster: {}", told));
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

}  // namespace

void say_event(const Options& options, const nlohmann::ordered_json& event, const std::string& words) {
  if (options.is_quiet) return;
  write_stream(stderr, (options.is_json ? format_object(event) : words) + "\n");
}

std::string describe_going_on(const SlurmJobs& jobs) {
  const std::vector<std::string> numbers = jobs.numbers();
  return fmt::format(
      "look with: squeue -j {}; cancel with: scancel {}; wait for the clip with the same command",
      fmt::join(numbers, ","), fmt::join(numbers, " "));
}

SlurmJobs ensure_jobs(const Options& options, const Farm& farm) {
  SlurmJobs jobs = find_slurm_jobs(farm.tasks.name, farm.clip.name);
  if (jobs.is_there() && is_same_plan(farm)) {
    if (jobs.clip.empty()) jobs.clip = submit_script(farm.clip, farm.files.clip_script(), jobs.tasks);
    say_event(options, {{"event", "found"}, {"array", jobs.tasks}, {"clip", jobs.clip}},
              fmt::format("going on with {} of an earlier call", name_jobs(jobs)));
    return jobs;
  }
  if (jobs.is_there()) cancel_and_wait(options, farm, jobs);
  return submit_farm(options, farm);
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

}  // namespace mien

#include "commands/farm_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "clip/pictures.hpp"
#include "commands/farm_words.hpp"
#include "core/text.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

constexpr double kChunk_s = 300;  // a task's start costs some seconds, and no scheduler likes many short ones

std::size_t count_part_size(const Options& options, const Clip& clip, const FarmFiles& files) {
  if (options.farm.chunk_drawings) return static_cast<std::size_t>(*options.farm.chunk_drawings);
  const RenderSpec& render = clip.spec.render;
  double drawing_s = read_drawing_cost_s(files.cost(), describe_drawing_kind(render));
  if (drawing_s <= 0) drawing_s = guess_drawing_s(render);
  const double drawings = options.farm.chunk_s.value_or(kChunk_s) * std::max(options.jobs, 1) / drawing_s;
  return static_cast<std::size_t>(std::max(1.0, std::floor(drawings)));
}

}  // namespace

std::vector<FarmClip> list_farm_clips(const ClipParts& planned, const std::vector<Cast>& casts) {
  std::vector<FarmClip> clips;
  if (planned.parts.empty()) clips.push_back({&planned.clip, &casts.front()});
  for (std::size_t i = 0; i < planned.parts.size(); ++i) clips.push_back({&planned.parts[i], &casts[i]});
  return clips;
}

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

void remove_work(const FarmFiles& files, std::size_t parts) {
  std::error_code ignored;
  for (std::size_t part = 1; part <= parts; ++part)
    fs::remove_all(files.work(static_cast<int>(part)), ignored);
}

void write_farm(const Farm& farm) {
  // Logs are appended to, as a task may begin anew elsewhere.
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

bool has_ended_well(const Farm& farm) {
  std::error_code ignored;
  // Listing a folder asks a network disk for what is new in it; asking for one file may not.
  for (const auto& entry : fs::directory_iterator(farm.files.folder, ignored))
    if (entry.path().filename() == farm.files.done().filename())
      return read_file(entry.path()) == farm.plan.identity + "\n";
  return false;
}

}  // namespace mien

// POV-Ray 3.7: options and exit statuses, reference manual 3.2; include files are looked for in the working
// folder and then in the library paths. Measured on 3.7.0.10: names with blanks or letters outside ASCII
// break +I, +L and +O, so that it runs in a work folder and knows
// all by short relative names.
#include "render/driver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <list>
#include <map>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "render/povray_output.hpp"
#include "render/work_folder.hpp"

namespace mien {

namespace {

// Without a file of our own POV-Ray takes any povray.ini that it finds. It wants one line at least.
constexpr const char* kIniName = "povray.ini";
constexpr const char* kIniText = "Work_Threads=1\n";

// What POV-Ray may need of the disk for one pixel: its state file and the picture.
constexpr std::size_t kDiskPerPixel = 16;  // bytes

// A frame that waits, or one that failed.
struct Attempt {
  const FrameJob* job;
  bool is_second = false;
  std::string what = {};    // went wrong, if it has failed
  bool has_second = false;  // it failed, and its second try waits or runs already
  int late_starts = 0;
};

// One frame on its way.
struct Rendering {
  Attempt attempt;
  std::filesystem::path raw;  // what povray writes
  Process process;
};

// What is the same for every frame of a call.
struct Run {
  explicit Run(const RenderSettings& run_settings, const std::filesystem::path& folder);

  const RenderSettings& settings;
  WorkFolder work;
  int link_count = 0;
  std::vector<std::string> libraries;  // named as povray, running in the work folder, can read them
};

bool is_plain(const std::string& name) {
  return std::ranges::all_of(name, [](char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
           (letter >= '-' && letter <= '9') || letter == '_';  // '-' to '9' holds . and / and the digits
  });
}

// A name of `path` for POV-Ray's command line: relative to the work folder, or a link in it if that is not
// plain.
std::string build_plain_name(const std::filesystem::path& path, Run& run) {
  const std::string relative = std::filesystem::relative(path, run.work.path).string();
  if (!relative.empty() && is_plain(relative)) return relative;
  const std::string name =
      fmt::format("link{}{}", ++run.link_count, path.extension() == ".pov" ? ".pov" : "");
  std::error_code error;
  std::filesystem::create_symlink(std::filesystem::absolute(path), run.work.path / name, error);
  if (error) throw RunError(fmt::format("cannot write in {}: {}", run.work.path.string(), error.message()));
  return name;
}

Run::Run(const RenderSettings& run_settings, const std::filesystem::path& folder)
    : settings(run_settings), work(folder) {
  write_file(work.path / kIniName, kIniText);
  for (const auto& library : settings.libraries) libraries.push_back(build_plain_name(library, *this));
}

std::vector<std::string> build_options(const RenderSettings& settings) {
  std::vector<std::string> options{fmt::format("+W{}", settings.width_px),
                                   fmt::format("+H{}", settings.height_px), "-D", "+WT1", "+FN8"};
  options.insert(options.end(), settings.povray_options.begin(), settings.povray_options.end());
  return options;
}

Rendering start_rendering(const Attempt& attempt, std::size_t index, Run& run) {
  const FrameJob& job = *attempt.job;
  const std::filesystem::path folder = job.scene.parent_path();
  const std::string raw = fmt::format("{}.png", index);
  std::vector<std::string> command{"povray", "+I" + build_plain_name(job.scene, run), "+O" + raw};
  const std::string scene_folder = build_plain_name(folder.empty() ? "." : folder, run);
  command.push_back("+L" + scene_folder);
  for (const std::string& library : run.libraries)
    if (library != scene_folder) command.push_back("+L" + library);
  for (std::string& option : build_options(run.settings)) command.push_back(std::move(option));
  const std::string ini = fmt::format("POVINI={}", kIniName);
  return {attempt, run.work.path / raw, start_process(command, run.work.path, {ini})};
}

// The command for a person to repeat: as we ran it, but seen from the scene's folder, since the work folder
// is gone.
std::string describe_command(const FrameJob& job, const RenderSettings& settings) {
  const std::filesystem::path& scene = job.told_scene.empty() ? job.scene : job.told_scene;
  const std::filesystem::path folder = scene.has_parent_path() ? scene.parent_path() : ".";
  std::vector<std::string> command{"povray", "+I" + scene.filename().string()};
  for (const auto& library : settings.libraries) {
    std::error_code ignored;
    if (!std::filesystem::equivalent(library, job.scene.parent_path(), ignored) &&
        !std::filesystem::equivalent(library, folder, ignored))
      command.push_back("+L" + std::filesystem::absolute(library).lexically_normal().string());
  }
  for (std::string& option : build_options(settings)) command.push_back(std::move(option));
  return fmt::format("cd {} && {}", quote_command({folder.string()}), quote_command(command));
}

// What went wrong with an ended frame; empty and `png` filled if nothing did.
std::string find_fault(const Rendering& rendering, const RenderSettings& settings, std::string& png) {
  const ProcessResult& result = rendering.process.result;
  if (result.exit_code != 0) return describe_end("povray", result);
  if (is_empty_scene(result.output)) return "povray found no objects in the scene";
  if (!std::filesystem::exists(rendering.raw)) return "povray wrote no picture";
  png = read_file(rendering.raw);
  const std::string fault = find_picture_fault(png, {settings.width_px, settings.height_px});
  return fault.empty() ? "" : "povray's picture " + fault;
}

// Puts the finished picture in its place, or throws RunError.
void finish_rendering(const Rendering& rendering, const Run& run) {
  const RenderSettings& settings = run.settings;
  std::string png;
  const std::string fault = find_fault(rendering, settings, png);
  std::error_code ignored;
  std::filesystem::remove(rendering.raw, ignored);
  std::filesystem::remove(std::filesystem::path(rendering.raw).replace_extension("pov-state"), ignored);
  const FrameJob& job = *rendering.attempt.job;
  if (fault.empty()) return write_file(job.picture, mark_picture(png, job.key));

  const std::size_t pixel_count = static_cast<std::size_t>(settings.width_px) * settings.height_px;
  require_space(run.work.path, pixel_count * kDiskPerPixel, job.picture);
  throw RunError(format_failure(fmt::format("frame {}: {}", job.number, fault),
                                describe_command(job, settings),
                                find_povray_reason(rendering.process.result)));
}

// Takes those that have ended out of `running`.
std::list<Rendering> take_ended(std::list<Rendering>& running) {
  std::vector<Process*> processes;
  for (Rendering& rendering : running) processes.push_back(&rendering.process);
  wait_for_any(processes);
  std::list<Rendering> ended;
  for (auto at = running.begin(); at != running.end();) {
    const auto next = std::next(at);
    if (at->process.id == 0) ended.splice(ended.end(), running, at);
    at = next;
  }
  return ended;
}

// What is still to do, what went wrong, and what has been learnt on the way.
struct Progression {
  std::deque<Attempt> waiting;
  std::map<int, Attempt> failures;  // by frame: the first is told, whichever came first
  bool has_worked = false;          // a frame of this call at least
  std::size_t failed_in_a_row = 0;
  double slowest_s = 0;  // of those that worked
};

// A frame is tried once more, behind those that wait. Before any has worked only the first that failed is: a
// povray that fails at all is not asked for hundreds.
void note_failure(const Attempt& failed, Progression& progression) {
  ++progression.failed_in_a_row;
  const Attempt again{failed.job, true, failed.what};
  if (!failed.is_second && progression.has_worked) return progression.waiting.push_back(again);
  const bool is_first_failure = !failed.is_second && progression.failures.empty();
  if (is_first_failure) progression.waiting.push_front(again);
  Attempt& kept = progression.failures.insert_or_assign(failed.job->number, failed).first->second;
  kept.has_second = is_first_failure;
}

// A machine too busy for povray to start on is no fault of the frame: the same attempt is made again, as
// often as it takes for a passing load. False once it is the machine that does not recover.
bool put_off_late_start(const Rendering& rendering, Progression& progression) {
  constexpr int kMostLateStarts = 5;
  const ProcessResult& result = rendering.process.result;
  if (result.exit_code == 0 || rendering.attempt.late_starts >= kMostLateStarts ||
      !is_late_start(result.output))
    return false;
  // In front: where nothing has worked yet, nothing else is begun before a second try.
  progression.waiting.push_front(rendering.attempt);
  ++progression.waiting.front().late_starts;
  return true;
}

// povray can work: who failed before that is tried again.
void note_success(const FrameJob& job, double wall_s, Progression& progression) {
  progression.has_worked = true;
  progression.failed_in_a_row = 0;
  progression.slowest_s = std::max(progression.slowest_s, wall_s);
  progression.failures.erase(job.number);
  std::erase_if(progression.failures, [&](const auto& entry) {
    const Attempt& failed = entry.second;
    if (failed.is_second) return false;
    if (!failed.has_second) progression.waiting.push_back({failed.job, true, failed.what});
    return true;
  });
}

// While nothing has worked and something failed, only a second try is begun, alone. After some failures in a
// row (a full disk, a povray that was taken away) nothing is.
bool may_begin(const Progression& progression, std::size_t running, std::size_t jobs) {
  constexpr std::size_t kMostInARow = 6;
  if (progression.waiting.empty() || progression.failed_in_a_row >= std::max(kMostInARow, 2 * jobs))
    return false;
  if (progression.has_worked || progression.failures.empty()) return true;
  return running == 0 && progression.waiting.front().is_second;
}

// A frame that hangs is told by how long the others took: what it may idle is far longer than they worked.
void limit_idling(Process& process, double slowest_s) {
  constexpr double kShortest_s = 60, kTimesTheSlowest = 10;
  if (slowest_s <= 0 || process.limit_s <= 0) return;
  process.limit_s = std::min(process.limit_s, std::max(kShortest_s, kTimesTheSlowest * slowest_s));
}

[[noreturn]] void tell_failures(const std::map<int, Attempt>& failures) {
  constexpr std::size_t kMostNamed = 20;
  std::string text = failures.begin()->second.what;
  if (failures.size() > 1) {
    std::string others = "\n  failed, too:";
    std::size_t named = 0;
    for (auto failure = std::next(failures.begin()); failure != failures.end() && named < kMostNamed;
         ++failure)
      others += fmt::format("{} frame {}", named++ > 0 ? "," : "", failure->first);
    if (failures.size() - 1 > kMostNamed)
      others += fmt::format(" and {} more", failures.size() - 1 - kMostNamed);
    // Behind the command, before what povray said.
    const std::size_t command = text.find('\n');
    text.insert(command == text.npos ? text.size() : std::min(text.find('\n', command + 1), text.size()),
                others);
  }
  throw RunError(text);
}

}  // namespace

void render_frames(const std::vector<FrameJob>& frames, const RenderSettings& settings,
                   const FrameHooks& hooks) {
  std::optional<Run> run;  // made when the first frame needs it: where all is kept, nothing is written
  const std::size_t jobs = static_cast<std::size_t>(std::max(settings.jobs, 1));
  Progression progression;
  for (const FrameJob& job : frames) progression.waiting.push_back({&job});
  std::list<Rendering> running, ended;
  while (true) {
    // Those that failed among the ended are judged below, before anything is begun after them.
    const bool is_clouded = std::ranges::any_of(
        ended, [](const Rendering& rendering) { return rendering.process.result.exit_code != 0; });
    while (!is_clouded && running.size() < jobs && may_begin(progression, running.size(), jobs)) {
      throw_if_interrupted();
      const Attempt next = progression.waiting.front();
      progression.waiting.pop_front();
      const FrameJob& job = *next.job;
      if (!job.key.empty() && read_picture_key(job.picture) == job.key) {
        hooks.done(job.number, true);
        continue;
      }
      if (!run)
        run.emplace(settings, settings.work_parent.empty() ? frames.front().picture.parent_path()
                                                           : settings.work_parent);
      if (hooks.prepare) hooks.prepare(job);
      const auto index = static_cast<std::size_t>(&job - frames.data()) + 1;
      try {
        running.push_back(start_rendering(next, index, *run));
      } catch (const RunError& error) {  // povray has not even begun: a second try is no use
        note_failure({&job, true, error.what()}, progression);
        continue;
      }
      limit_idling(running.back().process, progression.slowest_s);
    }
    // Pictures are judged while the frames after them render, so that no core waits for us.
    for (const Rendering& rendering : ended) {
      const FrameJob& job = *rendering.attempt.job;
      if (put_off_late_start(rendering, progression)) continue;
      try {
        finish_rendering(rendering, *run);
      } catch (const RunError& error) {
        note_failure({&job, rendering.attempt.is_second, error.what()}, progression);
        continue;
      }
      note_success(job, rendering.process.result.wall_s, progression);
      hooks.done(job.number, false);
    }
    ended.clear();
    if (!running.empty())
      ended = take_ended(running);
    else if (!may_begin(progression, 0, jobs))
      break;
  }
  for (const Attempt& left : progression.waiting)
    if (left.is_second) progression.failures.emplace(left.job->number, left);
  if (progression.failures.empty()) return;
  for (const auto& [number, failure] : progression.failures)
    if (hooks.failed) hooks.failed(*failure.job);
  tell_failures(progression.failures);
}

}  // namespace mien

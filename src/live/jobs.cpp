#include "live/jobs.hpp"

#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "render/process.hpp"

namespace mien {

namespace {

constexpr std::size_t kMostKept = 20;     // jobs that a page may still look at
constexpr std::size_t kMostWaiting = 10;  // a hand that slipped on a button
constexpr std::size_t kMostLines = 60;    // of a job: a mistake each, seldom more

bool is_over(const Job& job) { return job.state > JobState::running; }

void add_line(Job& job, std::string line) {
  job.lines.push_back(std::move(line));
  if (job.lines.size() > kMostLines) job.lines.pop_front();
}

// A mistake, warning or note, as a terminal would have it.
std::string format_finding(const nlohmann::json& object) {
  std::string text = object.value("file", "");
  for (const char* number : {"line", "column"})
    if (object.contains(number)) text += fmt::format(":{}", object[number].dump());
  if (!text.empty()) text += ": ";
  text += object.value("kind", "") + ": ";
  if (object.contains("message")) return text + object.value("message", "");
  return text + fmt::format("{} {} asks {}, held at {}", object.value("area", ""), object.value("move", ""),
                            object.value("asked", 0.0), object.value("held", 0.0));
}

void read_event(Job& job, const nlohmann::json& object) {
  job.stage = object.value("stage", job.stage);
  if (object.contains("total")) job.all = object.value("total", 0);
  if (object.contains("done")) job.finished = object.value("done", 0);
}

void read_output(Jobs& jobs, Job& job, std::string& output) {
  const std::lock_guard lock(jobs.mutex);
  std::size_t end;
  while ((end = output.find('\n')) != std::string::npos) {
    read_job_line(job, output.substr(0, end));
    output.erase(0, end + 1);
    ++jobs.version;
  }
  jobs.changed.notify_all();
}

// To the end of the job. The thread that starts a program must live as long as the program does: prctl(2).
void run_job(Jobs& jobs, Job& job) {
  int exit_code = 1;
  bool is_stopping = false;
  try {
    Process process = start_process(job.command, ".");
    while (wait_for_output(process)) {
      read_output(jobs, job, process.result.output);
      const std::lock_guard lock(jobs.mutex);
      if (!job.is_to_stop || is_stopping) continue;
      ::kill(-process.id, SIGINT);  // it keeps what it has finished
      is_stopping = true;
    }
    process.result.output += '\n';
    read_output(jobs, job, process.result.output);
    exit_code = process.result.exit_code;
  } catch (const RunError& error) {
    const std::lock_guard lock(jobs.mutex);
    add_line(job, error.what());
  } catch (const Interrupted&) {
    is_stopping = true;
  }
  const std::lock_guard lock(jobs.mutex);
  job.state = is_stopping ? JobState::stopped : exit_code == 0 ? JobState::done : JobState::failed;
}

Job* find_next(Jobs& jobs) {
  const auto found = std::ranges::find(jobs.jobs, JobState::waiting, &Job::state);
  return found == jobs.jobs.end() ? nullptr : &*found;
}

void work(Jobs& jobs) {
  std::unique_lock lock(jobs.mutex);
  while (true) {
    jobs.changed.wait(lock, [&] { return jobs.is_ending || find_next(jobs) != nullptr; });
    if (jobs.is_ending) return;
    Job& job = *find_next(jobs);  // a deque leaves it where it is, and it is not taken away while it runs
    job.state = JobState::running;
    ++jobs.version;
    jobs.changed.notify_all();
    lock.unlock();
    run_job(jobs, job);
    lock.lock();
    ++jobs.version;
    jobs.changed.notify_all();
  }
}

}  // namespace

void read_job_line(Job& job, const std::string& line) {
  if (line.empty()) return;
  const auto object = nlohmann::json::parse(line, nullptr, false);
  if (!object.is_object()) return add_line(job, line);
  if (object.contains("event")) return read_event(job, object);
  if (object.contains("kind")) return add_line(job, format_finding(object));
  for (const auto& [kind, path] : object.items()) {
    if (!path.is_string()) continue;
    add_line(job, fmt::format("{:<7} {}", kind, path.get<std::string>()));
    std::error_code error;
    if (std::filesystem::is_regular_file(path.get<std::string>(), error))
      job.results.emplace_back(path.get<std::string>());
  }
}

Jobs::Jobs() : worker([this] { work(*this); }) {}

Jobs::~Jobs() {
  end_jobs(*this);
  worker.join();
}

int add_job(Jobs& jobs, const std::string& kind, const std::string& title,
            const std::vector<std::string>& command) {
  const std::lock_guard lock(jobs.mutex);
  const auto waiting = std::ranges::count(jobs.jobs, JobState::waiting, &Job::state);
  if (static_cast<std::size_t>(waiting) >= kMostWaiting)
    throw InputError(fmt::format("{} are waiting; expected some of them to end first", waiting));
  while (jobs.jobs.size() >= kMostKept && is_over(jobs.jobs.front())) jobs.jobs.pop_front();
  Job job;
  job.id = ++jobs.count;
  job.kind = kind;
  job.title = title;
  job.command = command;
  jobs.jobs.push_back(std::move(job));
  ++jobs.version;
  jobs.changed.notify_all();
  return jobs.count;
}

void stop_job(Jobs& jobs, int id) {
  const std::lock_guard lock(jobs.mutex);
  const auto found = std::ranges::find(jobs.jobs, id, &Job::id);
  if (found == jobs.jobs.end() || is_over(*found)) return;
  found->is_to_stop = true;
  if (found->state == JobState::waiting) found->state = JobState::stopped;
  ++jobs.version;
  jobs.changed.notify_all();
}

void end_jobs(Jobs& jobs) {
  const std::lock_guard lock(jobs.mutex);
  jobs.is_ending = true;
  for (Job& job : jobs.jobs) job.is_to_stop = true;
  jobs.changed.notify_all();
}

}  // namespace mien

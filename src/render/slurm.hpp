// Slurm, a cluster's scheduler: the scripts that it is given, and what it is asked. Needs sbatch, squeue,
// scancel and scontrol, and no accounting database.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace mien {

// A job, or an array of tasks that differ by their number.
struct SlurmScript {
  std::string name;                   // of letters, digits and "_-."
  std::filesystem::path folder;       // absolute, where it runs
  std::filesystem::path log;          // absolute; of an array "%a" stands for a task's number
  std::size_t tasks = 0;              // numbered from 1; 0: no array
  int cores = 1;                      // of each task
  std::string partition, time_limit;  // empty: the cluster's own
  std::string note;                   // what it does, in one line
  std::vector<std::string> command;   // words; kTask in one stands for the task's number
};

inline constexpr const char* kTask = "{task}";

// A script of sh(1) for sbatch(1). Throws RunError for a path with a line's end in it.
std::string build_slurm_script(const SlurmScript& script);

// `text` as one word of sh(1).
std::string quote_word(const std::string& text);

// The most tasks that an array numbered from 1 may have: MaxArraySize - 1 of `config`, which `scontrol show
// config` prints. Throws RunError if it says none, or that there are no arrays.
std::size_t find_most_tasks(const std::string& config);
std::size_t ask_most_tasks();

// Gives a script, which lies in `file` as text, to sbatch; to begin once `after` (a job's number, or empty)
// has ended, well or not. Returns the job's number. Throws RunError with what sbatch says.
std::string submit_script(const SlurmScript& script, const std::filesystem::path& file,
                          const std::string& after);

// Jobs of ours that wait or run, by their names.
struct SlurmJobs {
  std::string tasks, clip;  // the numbers of the array and of the job after it; empty: has ended
  std::size_t running = 0;  // tasks and jobs
  std::string reason;       // why those that wait do so: "Resources"; empty: none waits
  bool is_there() const { return !tasks.empty() || !clip.empty(); }
  std::vector<std::string> numbers() const;
};

// Of what `squeue` prints in kSqueueFormat; jobs of other names are left out.
inline constexpr const char* kSqueueFormat = "%F|%j|%T|%r";
SlurmJobs read_slurm_jobs(const std::string& listed, const std::string& tasks_name,
                          const std::string& clip_name);

// Asks squeue for jobs of these names. Throws RunError with what it says.
SlurmJobs find_slurm_jobs(const std::string& tasks_name, const std::string& clip_name);

// Throws RunError with what scancel says.
void cancel_slurm_jobs(const std::vector<std::string>& numbers);

}  // namespace mien

// sbatch(1), squeue(1), scancel(1) and scontrol(1) of Slurm 22.05. Options in a script's "#SBATCH" lines give
// way to variables such as SBATCH_PARTITION, which therefore are set to the same.
#include "render/slurm.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "core/error.hpp"
#include "core/text.hpp"
#include "render/process.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

// As sbatch reads the words of its lines.
std::string quote_sbatch(const std::string& text) {
  if (text.find('\n') != text.npos)
    throw RunError(fmt::format("'{}' has a line's end in its name, which sbatch cannot take", text));
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' || c == '\\' ? fmt::format("\\{}", c) : std::string(1, c);
  return quoted + "\"";
}

// In the name of a log "%" begins a pattern.
std::string build_log_pattern(const fs::path& log) {
  std::string pattern;
  for (const char c : log.parent_path().string()) pattern += c == '%' ? "%%" : std::string(1, c);
  return quote_sbatch(pattern + "/" + log.filename().string());
}

std::string build_command(const std::vector<std::string>& words) {
  std::string line = "exec";
  for (const std::string& word : words) {
    const std::size_t task = word.find(kTask);
    line += task == word.npos ? " " + quote_word(word)
                              : fmt::format(" {}\"$SLURM_ARRAY_TASK_ID\"{}", word.substr(0, task),
                                            word.substr(task + std::string(kTask).size()));
  }
  return line + "\n";
}

// What a program of Slurm prints.
std::string ask_slurm(const std::vector<std::string>& command,
                      const std::vector<std::string>& environment = {}) {
  const ProcessResult result = run_process(command, {}, environment);
  if (result.exit_code == 0) return result.output;
  std::string said = result.output.substr(0, result.output.find_last_not_of(" \n") + 1);
  std::ranges::replace(said, '\n', ' ');
  throw RunError(fmt::format("{}: {}", describe_end(command.front(), result), said));
}

std::vector<std::string> split_fields(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, '|');) fields.push_back(field);
  return fields;
}

}  // namespace

std::string quote_word(const std::string& text) {
  const bool is_plain = !text.empty() && std::ranges::all_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '+' && c <= '9') || c == '_' || c == '=';
  });
  if (is_plain) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

std::string build_slurm_script(const SlurmScript& script) {
  std::string text = "#!/bin/sh\n";
  const auto add = [&](const char* option, const std::string& value) {
    text += fmt::format("#SBATCH --{}={}\n", option, value);
  };
  add("job-name", script.name);
  if (script.tasks > 0) add("array", fmt::format("1-{}", script.tasks));
  add("ntasks", "1");
  add("cpus-per-task", std::to_string(script.cores));
  if (!script.partition.empty()) add("partition", script.partition);
  if (!script.time_limit.empty()) add("time", script.time_limit);
  add("chdir", quote_sbatch(script.folder.string()));
  add("output", build_log_pattern(script.log));
  add("open-mode", "append");
  text += "#SBATCH --requeue\n";
  return text + fmt::format("# {}\n", script.note) + build_command(script.command);
}

std::size_t find_most_tasks(const std::string& config) {
  constexpr std::string_view kName = "MaxArraySize";
  std::istringstream lines(config);
  for (std::string line, name, sign; std::getline(lines, line);) {
    std::istringstream in(line);
    std::size_t size = 0;
    if (!(in >> name >> sign >> size) || name != kName) continue;
    if (size < 2) throw RunError("this cluster runs no job arrays: its MaxArraySize is 0");
    return size - 1;
  }
  throw RunError("'scontrol show config' says no MaxArraySize");
}

std::size_t ask_most_tasks() { return find_most_tasks(ask_slurm({"scontrol", "show", "config"})); }

std::string submit_script(const SlurmScript& script, const fs::path& file, const std::string& after) {
  std::vector<std::string> environment{"SBATCH_JOB_NAME=" + script.name};
  if (!script.partition.empty()) environment.push_back("SBATCH_PARTITION=" + script.partition);
  if (!script.time_limit.empty()) environment.push_back("SBATCH_TIMELIMIT=" + script.time_limit);
  std::vector<std::string> command{"sbatch", "--parsable"};
  if (!after.empty()) command.push_back("--dependency=afterany:" + after);
  command.push_back(fs::absolute(file).string());
  const std::string said =
      ask_slurm(command, environment);  // "12", or "12;cluster", and maybe warnings before it
  std::istringstream lines(said);
  std::string number;
  for (std::string line; std::getline(lines, line);)
    if (const std::string first = line.substr(0, line.find(';'));
        !first.empty() && first.find_first_not_of("0123456789") == first.npos)
      number = first;
  if (number.empty()) throw RunError(fmt::format("sbatch gave no job's number: {}", said));
  return number;
}

std::vector<std::string> SlurmJobs::numbers() const {
  std::vector<std::string> all;
  for (const std::string& number : {tasks, clip})
    if (!number.empty()) all.push_back(number);
  return all;
}

SlurmJobs read_slurm_jobs(const std::string& listed, const std::string& tasks_name,
                          const std::string& clip_name) {
  SlurmJobs jobs;
  std::istringstream lines(listed);
  for (std::string line; std::getline(lines, line);) {
    const std::vector<std::string> fields = split_fields(line);
    if (fields.size() < 3 || (fields[1] != tasks_name && fields[1] != clip_name)) continue;
    const bool is_tasks = fields[1] == tasks_name;
    (is_tasks ? jobs.tasks : jobs.clip) = fields[0];
    if (fields[2] != "PENDING")
      ++jobs.running;
    else if (is_tasks || jobs.reason.empty())
      jobs.reason = fields.size() > 3 ? fields[3] : "";
  }
  return jobs;
}

SlurmJobs find_slurm_jobs(const std::string& tasks_name, const std::string& clip_name) {
  return read_slurm_jobs(
      ask_slurm({"squeue", "--me", "--noheader", fmt::format("--name={},{}", tasks_name, clip_name),
                 fmt::format("--format={}", kSqueueFormat)}),
      tasks_name, clip_name);
}

void cancel_slurm_jobs(const std::vector<std::string>& numbers) {
  if (numbers.empty()) return;
  std::vector<std::string> command{"scancel"};
  command.insert(command.end(), numbers.begin(), numbers.end());
  ask_slurm(command);
}

}  // namespace mien

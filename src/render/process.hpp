// Programs that mien runs: started, heard, waited for and, whatever happens, ended. The only place that makes
// a process.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "render/failure.hpp"

namespace mien {

// What a program printed and how it ended.
struct ProcessResult {
  int exit_code = 0;   // 128 + n if signal n ended it
  std::string output;  // stdout and stderr together, as they came; of a flood only the last megabyte or two
  double wall_s = 0;
};

// From now on SIGINT (Ctrl-C), SIGTERM and SIGHUP make waiting functions end their children and throw
// Interrupted; a second signal ends us at once. Forgets a signal that came before. For main.cpp, once.
void install_signal_handlers();

// Throws Interrupted if a signal came. For long loops that wait for no process.
void throw_if_interrupted();

// Runs one program to its end in `folder`, with `environment` ("NAME=value") added to ours. It reads nothing
// on its stdin. It is ended when we are asked to stop; then throws Interrupted. Throws RunError if it cannot
// be started.
ProcessResult run_process(const std::vector<std::string>& command, const std::filesystem::path& folder,
                          const std::vector<std::string>& environment = {});

// Throws RunError "povray is not installed; install it with: apt-get install povray" for the first of
// `programs` (program, Debian package) that PATH does not hold. Called before any work.
void require_programs(const std::vector<std::pair<std::string, std::string>>& programs);

// A running program. It leads a process group of its own, which is killed when this object goes while it
// runs; the kernel kills the program if we die first. Only moved.
struct Process {
  Process() = default;
  Process(Process&& other) noexcept;
  Process& operator=(Process&& other) noexcept;
  ~Process();

  pid_t id = 0;          // 0: it has ended, `result` is complete
  int output_file = -1;  // where its stdout and stderr come; -1: closed
  double started_s = 0;
  ProcessResult result;
};

// As run_process, without waiting.
Process start_process(const std::vector<std::string>& command, const std::filesystem::path& folder,
                      const std::vector<std::string>& environment = {});

// Sleeps until at least one of `running` (not empty) has ended, usually noticing it within a millisecond, and
// collects the output of all meanwhile. Throws Interrupted if a signal came; ending the others is then their
// owner's affair.
void wait_for_any(const std::vector<Process*>& running);

}  // namespace mien

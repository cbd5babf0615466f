// Programs that mien runs: started, heard, waited for and, whatever happens, ended. The only place that makes
// a process.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/signals.hpp"
#include "render/failure.hpp"

namespace mien {

// What a program printed and how it ended.
struct ProcessResult {
  int exit_code = 0;   // 128 + n if signal n ended it
  std::string output;  // stdout and stderr together, as they came; of a flood only the last megabyte or two
  double wall_s = 0;
  double stalled_s = 0;  // above 0: it hung, did nothing for so long, and was ended with its children
};

// How long a program may do nothing before it counts as hung, in seconds; 0: for ever. A program does nothing
// while it says nothing and it and its children use less than a fiftieth of a processor without being ready
// to use more (or waiting for a disk) most of the time: one that computes, however slowly or seldom a busy
// machine lets it, and one that talks are waited for without limit. Ten minutes, or what the variable
// MIEN_STALL_LIMIT says; throws InputError if that is no number of seconds.
double read_stall_limit_s();

// As describe_end of failure.hpp, and of a program that hung what can be done.
std::string describe_end(const std::string& program, const ProcessResult& result);

// Runs one program to its end in `folder`, with `environment` ("NAME=value") added to ours. It reads nothing
// on its stdin. It is ended when it hangs, and when we are asked to stop; then throws Interrupted. Throws
// RunError if it cannot be started.
ProcessResult run_process(const std::vector<std::string>& command, const std::filesystem::path& folder,
                          const std::vector<std::string>& environment = {});

// This program and all that it starts from here on make way for others: `niceness` as nice(1) has it, from 1
// to 19.
void let_others_first(int niceness);

// The file that PATH has for a program; empty: none.
std::filesystem::path find_program(const std::string& program);

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
  int input_file = -1;   // what it reads, where it was started to be fed; -1: nothing, or closed
  double started_s = 0;
  ProcessResult result;

  // For noticing that it hangs.
  double limit_s = 0;              // read_stall_limit_s() at its start
  double idle_s = 0;               // how long it has done nothing
  double looked_s = 0;             // when that was last looked at
  double cpu_s = 0;                // what it had used of the processors when it last did something
  int looks = 0, ready_looks = 0;  // since then: all, and those that found it ready to work
  bool has_spoken = false;         // since it was last looked at
};

// As run_process, without waiting.
Process start_process(const std::vector<std::string>& command, const std::filesystem::path& folder,
                      const std::vector<std::string>& environment = {});

// The same of a program that reads what feed_process gives it.
Process start_fed_process(const std::vector<std::string>& command, const std::filesystem::path& folder);

// Gives the program `size` bytes to read, waiting for it as long as that takes; false if it has ended, closed
// its input, or hung and was ended. Throws Interrupted if a signal came.
bool feed_process(Process& process, const void* data, std::size_t size);

// The program reads no more than it was given.
void close_input(Process& process);

// Sleeps until the program has said something more, at most a moment; what it has said is in `result.output`,
// from which its reader may take it away. False once it has ended. Ends it when it hangs. Throws Interrupted
// if a signal came.
bool wait_for_output(Process& process);

// Sleeps until at least one of `running` (not empty) has ended, usually noticing it within a millisecond, and
// collects the output of all meanwhile. Ends those that hang. Throws Interrupted if a signal came; ending the
// others is then their owner's affair.
void wait_for_any(const std::vector<Process*>& running);

}  // namespace mien

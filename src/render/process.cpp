// Children are noticed without SIGCHLD and without spinning: the kernel closes a dying child's end of its
// output pipe, which wakes poll(), and the child can be waited for a moment later. See pipe(7), waitpid(2),
// prctl(2).
#include "render/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "core/error.hpp"

namespace mien {

namespace {

// The one thing a signal handler may touch, and any thread may ask.
std::atomic<bool> signal_came = false;
static_assert(std::atomic<bool>::is_always_lock_free);

constexpr std::size_t kOutputKept = 1
                                    << 20;  // bytes; the end of a program's output is what explains a failure
constexpr int kPoll_ms = 50;  // how late a signal to another thread or a daemonised child is noticed
constexpr int kReap_ms = 1;   // between the closed pipe and the ended process

extern "C" void note_signal(int) { signal_came = true; }

double read_clock_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::vector<char*> list_pointers(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

// Our environment with `additions` in place of variables of the same name.
std::vector<std::string> build_environment(const std::vector<std::string>& additions) {
  std::vector<std::string> all = additions;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view variable(*entry);
    const std::string_view name = variable.substr(0, variable.find('=') + 1);
    const bool is_replaced = std::ranges::any_of(
        additions, [&](const std::string& addition) { return addition.starts_with(name); });
    if (!is_replaced) all.emplace_back(variable);
  }
  return all;
}

// What the child does between fork and exec: only calls that are safe there (signal-safety(7)). Reports an
// error number through `report` if it cannot become the program.
[[noreturn]] void become_program(char** arguments, char** environment, const char* folder, int output,
                                 int report, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(127);  // the parent died before the line above
  ::setpgid(0, 0);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::signal(SIGPIPE, SIG_DFL);
  const int nothing = ::open("/dev/null", O_RDONLY);
  if (::chdir(folder) == 0 && nothing >= 0 && ::dup2(nothing, 0) >= 0 && ::dup2(output, 1) >= 0 &&
      ::dup2(output, 2) >= 0)
    ::execvpe(arguments[0], arguments, environment);
  const int error = errno;
  [[maybe_unused]] const ssize_t written = ::write(report, &error, sizeof error);
  ::_exit(127);
}

// Reads what has come, without waiting; closes the file at its end.
void collect_output(Process& process) {
  std::array<char, 65536> buffer;
  while (process.output_file >= 0) {
    const ssize_t count = ::read(process.output_file, buffer.data(), buffer.size());
    if (count > 0) {
      std::string& output = process.result.output;
      output.append(buffer.data(), static_cast<std::size_t>(count));
      if (output.size() > 2 * kOutputKept) output.erase(0, output.size() - kOutputKept);
    } else if (count < 0 && errno == EINTR) {
      continue;
    } else if (count < 0 && errno == EAGAIN) {
      return;
    } else {
      ::close(process.output_file);
      process.output_file = -1;
    }
  }
}

// Notes the end of a process that has ended; true if so.
bool reap(Process& process, int options) {
  int status = 0;
  pid_t ended;
  do ended = ::waitpid(process.id, &status, options);
  while (ended < 0 && errno == EINTR);
  if (ended != process.id) return false;
  process.id = 0;
  collect_output(process);
  if (process.output_file >= 0) ::close(process.output_file);  // a grandchild may hold the other end
  process.output_file = -1;
  process.result.exit_code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  process.result.wall_s = read_clock_s() - process.started_s;
  return true;
}

bool is_on_path(const std::string& program) {
  const char* variable = std::getenv("PATH");
  std::string_view path = variable != nullptr ? variable : "/usr/bin:/bin";
  while (true) {
    const std::size_t end = path.find(':');
    const std::filesystem::path candidate = std::filesystem::path(path.substr(0, end)) / program;
    std::error_code ignored;
    if (!std::filesystem::is_directory(candidate, ignored) && ::access(candidate.c_str(), X_OK) == 0)
      return true;
    if (end == std::string_view::npos) return false;
    path.remove_prefix(end + 1);
  }
}

}  // namespace

void install_signal_handlers() {
  signal_came = false;
  struct sigaction action {};
  action.sa_handler = note_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND);  // no SA_RESTART: poll() shall wake
  ::sigemptyset(&action.sa_mask);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) ::sigaction(number, &action, nullptr);
}

void throw_if_interrupted() {
  if (signal_came) throw Interrupted();
}

Process::Process(Process&& other) noexcept { *this = std::move(other); }

Process& Process::operator=(Process&& other) noexcept {
  std::swap(id, other.id);
  std::swap(output_file, other.output_file);
  std::swap(started_s, other.started_s);
  std::swap(result, other.result);
  return *this;
}

Process::~Process() {
  if (id == 0) return;
  ::kill(-id, SIGKILL);
  reap(*this, 0);
}

Process start_process(const std::vector<std::string>& command, const std::filesystem::path& folder,
                      const std::vector<std::string>& environment) {
  std::vector<std::string> arguments = command, variables = build_environment(environment);
  std::vector<char*> argument_list = list_pointers(arguments), variable_list = list_pointers(variables);
  const std::filesystem::path place = folder.empty() ? "." : folder;

  std::array<int, 2> output{-1, -1}, report{-1, -1};
  if (::pipe2(output.data(), O_CLOEXEC) != 0)
    throw RunError(fmt::format("cannot start {}: {}", command.front(), std::strerror(errno)));
  int error = ::pipe2(report.data(), O_CLOEXEC) == 0 ? 0 : errno;

  Process process;
  process.started_s = read_clock_s();
  process.output_file = output[0];
  const pid_t parent = ::getpid();
  const pid_t child = error == 0 ? ::fork() : -1;
  if (child == 0)
    become_program(argument_list.data(), variable_list.data(), place.c_str(), output[1], report[1], parent);
  if (child < 0 && error == 0) error = errno;
  ::close(output[1]);
  if (report[1] >= 0) ::close(report[1]);
  process.id = std::max(child, 0);

  // The child's exec closes its end of `report`: nothing comes, and the program runs.
  if (error == 0) {
    ssize_t count;
    do count = ::read(report[0], &error, sizeof error);
    while (count < 0 && errno == EINTR);
  }
  if (report[0] >= 0) ::close(report[0]);
  if (error != 0) {
    if (process.id != 0) reap(process, 0);
    if (process.output_file >= 0) ::close(process.output_file);
    throw RunError(
        fmt::format("cannot start {} in {}: {}", command.front(), place.string(), std::strerror(error)));
  }
  ::fcntl(process.output_file, F_SETFL, O_NONBLOCK);
  return process;
}

void wait_for_any(const std::vector<Process*>& running) {
  while (true) {
    bool has_ended = false, is_closing = false;
    std::vector<pollfd> files;
    for (Process* process : running) {
      collect_output(*process);
      if (process->id == 0 || reap(*process, WNOHANG)) has_ended = true;
      is_closing |= process->output_file < 0;
      files.push_back({process->output_file, POLLIN, 0});
    }
    throw_if_interrupted();
    if (has_ended) return;
    ::poll(files.data(), files.size(), is_closing ? kReap_ms : kPoll_ms);
  }
}

ProcessResult run_process(const std::vector<std::string>& command, const std::filesystem::path& folder,
                          const std::vector<std::string>& environment) {
  throw_if_interrupted();
  Process process = start_process(command, folder, environment);
  wait_for_any({&process});
  return std::move(process.result);
}

void require_programs(const std::vector<std::pair<std::string, std::string>>& programs) {
  for (const auto& [program, package] : programs)
    if (!is_on_path(program))
      throw RunError(
          fmt::format("{} is not installed; install it with: apt-get install {}", program, package));
}

}  // namespace mien

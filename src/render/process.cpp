// Children are noticed without SIGCHLD and without spinning: the kernel closes a dying child's end of its
// output pipe, which wakes poll(), and the child can be waited for a moment later. See pipe(7), waitpid(2),
// prctl(2).
#include "render/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>
#include <thread>

#include "core/clock.hpp"
#include "core/error.hpp"

namespace mien {

namespace {

constexpr std::size_t kOutputKept = 1
                                    << 20;  // bytes; the end of a program's output is what explains a failure
constexpr int kPoll_ms = 50;  // how late a signal to another thread or a daemonised child is noticed
constexpr int kReap_ms = 1;   // between the closed pipe and the ended process

constexpr double kStallLimit_s = 600;  // what no disk and no swapping keeps an honest program from any work
// Of a processor: measured, POV-Ray whose parser waits for ever uses 0.004, as its other threads wake a
// hundred times a second to look.
constexpr double kIdleShare = 0.02;
// Of the looks at it: on a machine so busy that an honest program is left less than that share, it is found
// ready to run, or waiting for a disk, each time; one that only wakes to look, seldom.
constexpr double kReadyShare = 0.75;
constexpr double kLook_s = 5;       // between two looks at a program, at most
constexpr double kLeastLooks = 20;  // in the time that it may do nothing
constexpr double kEnd_s = 5;        // after SIGKILL a program that a dead disk holds fast may still not end

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
[[noreturn]] void become_program(char** arguments, char** environment, const char* folder, int input,
                                 int output, int report, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(127);  // the parent died before the line above
  ::setpgid(0, 0);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::signal(SIGPIPE, SIG_DFL);
  const int read = input >= 0 ? input : ::open("/dev/null", O_RDONLY);
  if (::chdir(folder) == 0 && read >= 0 && ::dup2(read, 0) >= 0 && ::dup2(output, 1) >= 0 &&
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
      process.has_spoken = true;
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

// The words of a stat file of proc(5) from the state on: after the name, which stands in brackets and may
// hold anything.
std::istringstream read_stat(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string text;
  std::getline(file, text);
  const std::size_t bracket = text.rfind(')');
  return std::istringstream(bracket == text.npos ? "" : text.substr(bracket + 1));
}

std::vector<std::filesystem::path> list_numbered(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> numbered;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    if (entry->path().filename().string().find_first_not_of("0123456789") == std::string::npos)
      numbered.push_back(entry->path());
  return numbered;
}

// The processes that a program became: its group and all that descend from it, whatever groups those made.
std::vector<pid_t> list_family(pid_t program) {
  struct Member {
    pid_t id = 0, parent = 0;
    bool is_ours = false;
  };
  std::vector<Member> all;
  for (const std::filesystem::path& process : list_numbered("/proc")) {
    std::istringstream fields = read_stat(process / "stat");
    Member member{static_cast<pid_t>(std::atoi(process.filename().c_str())), 0, false};
    std::string state;
    pid_t group = 0;
    if (!(fields >> state >> member.parent >> group)) continue;
    member.is_ours = group == program || member.id == program;
    all.push_back(member);
  }
  for (bool has_grown = true; has_grown;) {
    has_grown = false;
    for (Member& child : all) {
      const auto is_parent = [&](const Member& other) { return other.is_ours && other.id == child.parent; };
      if (child.is_ours || std::ranges::none_of(all, is_parent)) continue;
      child.is_ours = has_grown = true;
    }
  }
  std::vector<pid_t> family;
  for (const Member& member : all)
    if (member.is_ours) family.push_back(member.id);
  return family;
}

// What a family of processes does.
struct Activity {
  double cpu_s = 0;       // that they and the children they waited for have used
  bool is_ready = false;  // one of their threads runs, waits for a processor or waits for a disk
};

// Nothing if it cannot be told.
std::optional<Activity> measure_activity(pid_t program) {
  static const double ticks = static_cast<double>(::sysconf(_SC_CLK_TCK));
  std::optional<Activity> sum;
  for (const pid_t id : list_family(program)) {
    const std::filesystem::path process = fmt::format("/proc/{}", id);
    std::istringstream fields = read_stat(process / "stat");
    if (!sum) sum.emplace();
    std::string word;
    for (int i = 3; i < 14; ++i) fields >> word;  // fields 3 to 13
    double used = 0;
    for (int i = 0; i < 4 && fields >> used; ++i) sum->cpu_s += used / ticks;  // its own, its children's
    for (const std::filesystem::path& thread : list_numbered(process / "task"))
      if (read_stat(thread / "stat") >> word; word == "R" || word == "D") sum->is_ready = true;
  }
  return sum;
}

// Whether a program has done nothing for as long as it may. Time that passed between two looks counts only
// as far as looks are apart: whoever stopped us or the machine stopped the program too.
bool has_stalled(Process& process) {
  if (process.limit_s <= 0) return false;
  const double look_s = std::min(kLook_s, process.limit_s / kLeastLooks);
  const double now_s = read_clock_s(), passed_s = now_s - process.looked_s;
  if (passed_s < look_s) return false;
  process.looked_s = now_s;
  const std::optional<Activity> activity = measure_activity(process.id);
  process.idle_s += std::min(passed_s, 2 * look_s);
  ++process.looks;
  if (activity && activity->is_ready) ++process.ready_looks;
  const bool is_late = process.idle_s >= process.limit_s;
  const bool has_worked = !activity || activity->cpu_s < process.cpu_s ||
                          activity->cpu_s - process.cpu_s > kIdleShare * process.limit_s ||
                          (is_late && process.ready_looks > kReadyShare * process.looks);
  if (has_worked || process.has_spoken) {
    process.idle_s = 0;
    process.looks = process.ready_looks = 0;
    process.cpu_s = activity.value_or(Activity{}).cpu_s;
  }
  process.has_spoken = false;
  return process.idle_s >= process.limit_s;
}

// Ends a program that hangs, and its children.
void end_stalled(Process& process) {
  const std::vector<pid_t> family = list_family(process.id);
  ::kill(-process.id, SIGKILL);
  for (const pid_t id : family) ::kill(id, SIGKILL);
  for (const double begun_s = read_clock_s(); !reap(process, WNOHANG) && read_clock_s() - begun_s < kEnd_s;)
    std::this_thread::sleep_for(std::chrono::milliseconds(kReap_ms));
  if (process.id != 0) {
    if (process.output_file >= 0) ::close(process.output_file);
    process.output_file = -1;
    process.id = 0;  // the kernel ends it when the disk comes back
  }
  process.result.exit_code = 128 + SIGKILL;
  process.result.stalled_s = process.limit_s;
}

}  // namespace

double read_stall_limit_s() {
  const char* variable = std::getenv("MIEN_STALL_LIMIT");
  if (variable == nullptr || *variable == '\0') return kStallLimit_s;
  const std::string_view text(variable);
  double limit_s = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), limit_s);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(limit_s) || limit_s < 0)
    throw InputError(fmt::format(
        "MIEN_STALL_LIMIT: '{}' is not a number of seconds such as 600, or 0 for no limit", text));
  return limit_s;
}

std::string describe_end(const std::string& program, const ProcessResult& result) {
  if (result.stalled_s == 0) return describe_end(program, result.exit_code);
  return fmt::format(
      "{} hung and was ended: for {:.4g} s it said nothing and hardly worked; run again, or let "
      "MIEN_STALL_LIMIT be more seconds (0: no limit)",
      program, result.stalled_s);
}

Process::Process(Process&& other) noexcept { *this = std::move(other); }

Process& Process::operator=(Process&& other) noexcept {
  std::swap(id, other.id);
  std::swap(output_file, other.output_file);
  std::swap(input_file, other.input_file);
  std::swap(started_s, other.started_s);
  std::swap(result, other.result);
  std::swap(limit_s, other.limit_s);
  std::swap(idle_s, other.idle_s);
  std::swap(looked_s, other.looked_s);
  std::swap(cpu_s, other.cpu_s);
  std::swap(looks, other.looks);
  std::swap(ready_looks, other.ready_looks);
  std::swap(has_spoken, other.has_spoken);
  return *this;
}

Process::~Process() {
  close_input(*this);
  if (id == 0) return;
  ::kill(-id, SIGKILL);
  reap(*this, 0);
}

namespace {

// `input` is the child's, or -1.
Process start_child(const std::vector<std::string>& command, const std::filesystem::path& folder,
                    const std::vector<std::string>& environment, int input) {
  std::vector<std::string> arguments = command, variables = build_environment(environment);
  std::vector<char*> argument_list = list_pointers(arguments), variable_list = list_pointers(variables);
  const std::filesystem::path place = folder.empty() ? "." : folder;
  const double limit_s = read_stall_limit_s();

  std::array<int, 2> output{-1, -1}, report{-1, -1};
  if (::pipe2(output.data(), O_CLOEXEC) != 0)
    throw RunError(fmt::format("cannot start {}: {}", command.front(), std::strerror(errno)));
  int error = ::pipe2(report.data(), O_CLOEXEC) == 0 ? 0 : errno;

  Process process;
  process.limit_s = limit_s;
  process.started_s = process.looked_s = read_clock_s();
  process.output_file = output[0];
  const pid_t parent = ::getpid();
  const pid_t child = error == 0 ? ::fork() : -1;
  if (child == 0)
    become_program(argument_list.data(), variable_list.data(), place.c_str(), input, output[1], report[1],
                   parent);
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

}  // namespace

Process start_process(const std::vector<std::string>& command, const std::filesystem::path& folder,
                      const std::vector<std::string>& environment) {
  return start_child(command, folder, environment, -1);
}

// A socket, not a pipe: writing to one whose reader has gone can be told not to raise a signal.
Process start_fed_process(const std::vector<std::string>& command, const std::filesystem::path& folder) {
  std::array<int, 2> ends{-1, -1};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw RunError(fmt::format("cannot start {}: {}", command.front(), std::strerror(errno)));
  try {
    Process process = start_child(command, folder, {}, ends[1]);
    ::close(ends[1]);
    ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
    process.input_file = ends[0];
    return process;
  } catch (...) {
    ::close(ends[0]);
    ::close(ends[1]);
    throw;
  }
}

bool feed_process(Process& process, const void* data, std::size_t size) {
  const char* next = static_cast<const char*>(data);
  process.looked_s = read_clock_s();  // while we had nothing to give, it had nothing to do
  while (size > 0) {
    throw_if_interrupted();
    if (process.id == 0 || process.input_file < 0) return false;
    const ssize_t count = ::send(process.input_file, next, size, MSG_NOSIGNAL);
    if (count > 0) {
      next += count;
      size -= static_cast<std::size_t>(count);
      continue;
    }
    if (count < 0 && errno != EAGAIN && errno != EINTR) {
      close_input(process);
      return false;
    }
    std::array<pollfd, 2> files{pollfd{process.input_file, POLLOUT, 0},
                                pollfd{process.output_file, POLLIN, 0}};
    ::poll(files.data(), files.size(), kPoll_ms);
    collect_output(process);
    if (reap(process, WNOHANG)) return false;
    if (has_stalled(process)) {
      end_stalled(process);
      return false;
    }
  }
  return true;
}

void close_input(Process& process) {
  if (process.input_file >= 0) ::close(process.input_file);
  process.input_file = -1;
}

void wait_for_any(const std::vector<Process*>& running) {
  while (true) {
    bool has_ended = false, is_closing = false;
    std::vector<pollfd> files;
    for (Process* process : running) {
      collect_output(*process);
      if (process->id == 0 || reap(*process, WNOHANG)) {
        has_ended = true;
      } else if (has_stalled(*process)) {
        end_stalled(*process);
        has_ended = true;
      }
      is_closing |= process->output_file < 0;
      files.push_back({process->output_file, POLLIN, 0});
    }
    throw_if_interrupted();
    if (has_ended) return;
    ::poll(files.data(), files.size(), is_closing ? kReap_ms : kPoll_ms);
  }
}

bool wait_for_output(Process& process) {
  throw_if_interrupted();
  const std::size_t heard = process.result.output.size();
  collect_output(process);
  if (process.id == 0 || reap(process, WNOHANG)) return false;
  if (has_stalled(process)) {
    end_stalled(process);
    return false;
  }
  if (process.result.output.size() != heard) return true;
  pollfd file{process.output_file, POLLIN, 0};
  ::poll(&file, 1, process.output_file < 0 ? kReap_ms : kPoll_ms);
  collect_output(process);
  return true;
}

ProcessResult run_process(const std::vector<std::string>& command, const std::filesystem::path& folder,
                          const std::vector<std::string>& environment) {
  throw_if_interrupted();
  Process process = start_process(command, folder, environment);
  wait_for_any({&process});
  return std::move(process.result);
}

void let_others_first(int niceness) {
  // Whoever has given way further already stays there: the way back is not everybody's to go.
  if (::getpriority(PRIO_PROCESS, 0) < niceness) ::setpriority(PRIO_PROCESS, 0, niceness);
}

std::filesystem::path find_program(const std::string& program) {
  const char* variable = std::getenv("PATH");
  std::string_view path = variable != nullptr ? variable : "/usr/bin:/bin";
  while (true) {
    const std::size_t end = path.find(':');
    const std::filesystem::path candidate = std::filesystem::path(path.substr(0, end)) / program;
    std::error_code ignored;
    if (!std::filesystem::is_directory(candidate, ignored) && ::access(candidate.c_str(), X_OK) == 0)
      return candidate;
    if (end == std::string_view::npos) return {};
    path.remove_prefix(end + 1);
  }
}

void require_programs(const std::vector<std::pair<std::string, std::string>>& programs) {
  for (const auto& [program, package] : programs)
    if (find_program(program).empty())
      throw RunError(
          fmt::format("{} is not installed; install it with: apt-get install {}", program, package));
}

}  // namespace mien

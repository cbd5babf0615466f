// Arguments in, exit status out: the only place that decides how the program ends.
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>
#include <string_view>
#include <system_error>

#include "command_line/arguments.hpp"
#include "core/diagnostics.hpp"
#include "core/error.hpp"
#include "core/pool.hpp"
#include "core/signals.hpp"
#include "core/streams.hpp"
#include "render/process.hpp"

namespace {

using namespace mien;

constexpr int kDone = 0, kFailed = 1, kWrongInput = 2, kInterrupted = 130;

int run_request(const Request& request) {
  if (request.command != nullptr) {
    request.command->run(request.options);
    return kDone;
  }
  if (request.is_usage)
    write_stream(stderr, request.text);
  else
    fmt::print("{}", request.text);
  return request.is_usage ? kWrongInput : kDone;
}

// What to say of output that was lost; nobody reads a pipe that has been closed, so nothing is said of that.
std::string describe_lost_output(int error) {
  return error == EPIPE ? "" : fmt::format("cannot write standard output: {}", std::strerror(error));
}

// "out/a/frames: Permission denied", of what no function of ours has put into words.
std::string describe_fault(const std::filesystem::filesystem_error& error) {
  const std::string path = error.path1().string();
  return fmt::format("{}: {}", path.empty() ? "the folder this runs in" : path, error.code().message());
}

}  // namespace

int main(int argc, char** argv) {
  open_missing_streams();
  const bool is_json = std::any_of(argv, argv + argc, [](std::string_view word) { return word == "--json"; });
  const auto fail = [&](int status, const std::string& message) {
    if (!message.empty()) write_diagnostics(InputError(message).diagnostics, is_json);
    return status;
  };
  int status = kDone;
  try {
    install_signal_handlers();
    static_cast<void>(read_stall_limit_s());  // a wrong one is told before any work
    const Request request = read_arguments(argc, argv);
    set_job_count(request.options.jobs);
    status = run_request(request);
  } catch (const InputError& e) {
    write_diagnostics(e.diagnostics, is_json);
    status = kWrongInput;
  } catch (const Interrupted& e) {
    status = fail(kInterrupted, e.what());
  } catch (const std::bad_alloc&) {
    status = fail(kFailed, "out of memory");
  } catch (const std::filesystem::filesystem_error& e) {
    status = fail(kFailed, describe_fault(e));
  } catch (const std::system_error& e) {  // of fmt::print, if standard output takes no more
    const bool is_output = std::ferror(stdout) != 0;
    status = fail(kFailed, is_output ? describe_lost_output(e.code().value()) : e.code().message());
  } catch (const std::exception& e) {
    status = fail(kFailed, e.what());
  }
  // Everything printed has arrived: a full disk behind `mien schema > file` is a failure too, and so is an
  // error stream that took nothing of what was to be said, though then nobody can be told.
  errno = 0;
  if (has_lost_text(stdout) && status == kDone)
    status = fail(kFailed, describe_lost_output(errno == 0 ? EIO : errno));
  return has_lost_text(stderr) && status == kDone ? kFailed : status;
}

// Arguments in, exit status out: the only place that prints an error and decides how the program ends.
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <nlohmann/json.hpp>
#include <string_view>

#include "command_line/arguments.hpp"
#include "core/error.hpp"
#include "core/pool.hpp"
#include "render/process.hpp"

namespace {

using namespace mien;

constexpr int kDone = 0, kFailed = 1, kWrongInput = 2, kInterrupted = 130;

int run_request(const Request& request) {
  if (request.command != nullptr) {
    request.command->run(request.options);
    return kDone;
  }
  fmt::print(request.is_usage ? stderr : stdout, "{}", request.text);
  return request.is_usage ? kWrongInput : kDone;
}

std::string format_json(const Diagnostic& diagnostic) {
  nlohmann::ordered_json object{{"kind", diagnostic.is_warning ? "warning" : "error"}};
  if (!diagnostic.place.file.empty()) object["file"] = diagnostic.place.file;
  if (diagnostic.place.line > 0) {
    object["line"] = diagnostic.place.line;
    if (diagnostic.place.column > 0) object["column"] = diagnostic.place.column;
  }
  object["message"] = diagnostic.message;
  return object.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void print_diagnostics(const std::vector<Diagnostic>& diagnostics, bool is_json) {
  for (const Diagnostic& diagnostic : diagnostics)
    fmt::print(stderr, "{}\n", is_json ? format_json(diagnostic) : format_diagnostic(diagnostic));
  const auto errors = std::count_if(diagnostics.begin(), diagnostics.end(),
                                    [](const Diagnostic& diagnostic) { return !diagnostic.is_warning; });
  if (errors > 1 && !is_json) fmt::print(stderr, "{} errors\n", errors);
}

// Everything printed has arrived: a full disk behind `mien schema > file` is a failure too.
void flush_output() {
  std::cout.flush();
  if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw RunError(fmt::format("cannot write standard output: {}", std::strerror(errno)));
}

}  // namespace

int main(int argc, char** argv) {
  const bool is_json = std::any_of(argv, argv + argc, [](std::string_view word) { return word == "--json"; });
  const auto fail = [&](int status, const std::string& message) {
    print_diagnostics(InputError(message).diagnostics, is_json);
    return status;
  };
  try {
    install_signal_handlers();
    const Request request = read_arguments(argc, argv);
    set_job_count(request.options.jobs);
    const int status = run_request(request);
    flush_output();
    return status;
  } catch (const InputError& e) {
    print_diagnostics(e.diagnostics, is_json);
    return kWrongInput;
  } catch (const Interrupted& e) {
    return fail(kInterrupted, e.what());
  } catch (const std::bad_alloc&) {
    return fail(kFailed, "out of memory");
  } catch (const std::exception& e) {
    return fail(kFailed, e.what());
  }
}

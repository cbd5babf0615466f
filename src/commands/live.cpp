// `mien live`.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "clip/clip.hpp"
#include "commands/table.hpp"
#include "config/data_words.hpp"
#include "config/schema.hpp"
#include "core/data.hpp"
#include "core/error.hpp"
#include "core/streams.hpp"
#include "live/session.hpp"
#include "render/file_watch.hpp"
#include "render/process.hpp"

namespace mien {

namespace {

constexpr double kNewFiles_s = 1;  // how late it is noticed that the text names other files

void tell_address(const Options& options, const std::string& address) {
  if (options.is_json)
    fmt::print("{{\"address\":\"{}\"}}\n", address);
  else
    fmt::print("{}\n", address);
  std::fflush(stdout);  // whoever follows a pipe learns it now
}

// In a session of its own, so that it goes on without us.
void open_browser(const std::string& address) {
  run_process({"sh", "-c", "exec setsid -f xdg-open \"$1\" >/dev/null 2>&1", "sh", address}, ".");
}

std::vector<std::filesystem::path> list_watched(LiveSession& session) {
  const std::lock_guard lock(session.shelf.mutex);
  std::vector<std::filesystem::path> files = session.shelf.files;
  files.push_back(session.shelf.file);
  return files;
}

// Tells the pages what happens to the files, until a signal comes.
void follow_files(LiveSession& session) {
  FileWatch watch;
  while (true) {
    const std::vector<std::filesystem::path> files = list_watched(session);
    set_watched_files(watch, files);
    if (!wait_for_save(watch, kNewFiles_s)) continue;
    look_at_disk(session,
                 std::ranges::any_of(files, [&](const auto& file) { return file != session.shelf.file; }));
  }
}

// A file with mistakes is opened, to mend them; one that cannot be read or saved is told.
void check_file(const Options& options, const Language& language) {
  if (std::filesystem::is_regular_file(options.file)) return;
  load_request(options, language);
  throw InputError(fmt::format("{} is no plain file; expected one that can be saved", options.file.string()));
}

// Whatever ends the server, nobody waits for it.
struct EndOfSession {
  LiveSession& session;
  ~EndOfSession() { end_session(session); }
};

void run_live(const Options& options) {
  if (options.is_opened) require_programs({{"xdg-open", "xdg-utils"}, {"setsid", "util-linux"}});
  LiveSession session;
  session.files = list_live_files(find_data_folder());
  const Resources resources = load_resources(find_data_folder());
  check_file(options, *resources.stock.language);
  session.shelf.resources = &resources;
  session.shelf.file = options.file;
  session.schema = build_schema(load_data_words(find_data_folder()));
  session.program = std::filesystem::read_symlink("/proc/self/exe");
  session.is_read_only = options.is_read_only;
  look_at_disk(session, false);
  const LiveServer server(options.port,
                          [&](const LiveRequest& request) { return answer_request(session, request); });
  const EndOfSession end{session};
  tell_address(options, server.address);
  try {
    if (options.is_opened) open_browser(server.address);
    follow_files(session);
  } catch (const Interrupted&) {  // which is how it ends
  }
}

}  // namespace

const CommandInfo command_live{
    "live",
    "Pictures",
    "FILE",
    "a page in the browser: editor, face, timeline, sliders",
    "Serves a page at an address of this machine alone, which it prints: the file as text "
    "with its mistakes as you\ntype, the face that it describes, its timeline, and sliders "
    "that write into the file. What other programs\nsave is shown at once. Ctrl-C ends.",
    "port open read-only",
    "mien live configs/hello.yaml\nmien live face.yaml --port 8080 --open",
    run_live};

}  // namespace mien

#include "render/file_watch.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "core/clock.hpp"
#include "core/error.hpp"
#include "core/signals.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

constexpr int kSignal_ms = 200;  // a signal is noticed within so long
constexpr int kQuiet_ms = 60;    // nothing for so long: the save is done
constexpr std::uint32_t kSaves = IN_CLOSE_WRITE | IN_MOVED_TO | IN_CREATE | IN_DELETE | IN_MOVED_FROM;

// Whether one of the files is among the events that have come; reads them all.
bool read_events(FileWatch& watch) {
  alignas(inotify_event) std::array<char, 16384> buffer;
  bool is_ours = false;
  while (true) {
    const ssize_t count = ::read(watch.events, buffer.data(), buffer.size());
    if (count <= 0) return is_ours;
    for (ssize_t at = 0; at < count;) {
      const auto* const event = reinterpret_cast<const inotify_event*>(buffer.data() + at);
      const auto folder = watch.names.find(event->wd);
      if (folder != watch.names.end() && event->len > 0 && folder->second.contains(event->name))
        is_ours = true;
      at += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
    }
  }
}

void watch_file(FileWatch& watch, const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const int id = ::inotify_add_watch(watch.events, folder.c_str(), kSaves);
  if (id < 0) {
    if (errno == ENOENT || errno == ENOTDIR) return;
    throw RunError(fmt::format("cannot watch {}: {}", folder.string(), std::strerror(errno)));
  }
  watch.names[id].insert(file.filename().string());
}

}  // namespace

FileWatch::FileWatch() : events(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
  if (events < 0) throw RunError(fmt::format("cannot watch files: {}", std::strerror(errno)));
}

FileWatch::FileWatch(FileWatch&& other) noexcept
    : events(std::exchange(other.events, -1)), names(std::move(other.names)) {}

FileWatch& FileWatch::operator=(FileWatch&& other) noexcept {
  std::swap(events, other.events);
  std::swap(names, other.names);
  return *this;
}

FileWatch::~FileWatch() {
  if (events >= 0) ::close(events);
}

void set_watched_files(FileWatch& watch, const std::vector<fs::path>& files) {
  const std::map<int, std::set<std::string>> before = std::exchange(watch.names, {});
  for (const fs::path& file : files) {
    watch_file(watch, file);
    std::error_code error;
    const fs::path real = fs::canonical(file, error);
    if (!error) watch_file(watch, real);
  }
  for (const auto& [folder, names] : before)
    if (!watch.names.contains(folder)) ::inotify_rm_watch(watch.events, folder);
}

bool wait_for_save(FileWatch& watch, double most_s) {
  const double begun_s = read_clock_s();
  bool is_saved = false;
  while (true) {
    throw_if_interrupted();
    pollfd file{watch.events, POLLIN, 0};
    const int ready = ::poll(&file, 1, is_saved ? kQuiet_ms : kSignal_ms);
    if (ready > 0 && read_events(watch)) is_saved = true;
    if (ready == 0 && is_saved) return true;
    if (!is_saved && read_clock_s() - begun_s >= most_s) return false;
  }
}

}  // namespace mien

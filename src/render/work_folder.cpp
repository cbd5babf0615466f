// The lock tells a living run's folder from a dead one's: flock(2) goes with the process, however it ends,
// and holds across containers and most network disks, where a process number would not.
#include "render/work_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/error.hpp"

namespace mien {

namespace {

constexpr const char* kPrefix = ".mien-work-";

// Opens a folder and takes its lock; -1 if somebody else has it. A disk without locks gives the file unlocked
// if `is_ours`.
int open_locked(const std::filesystem::path& folder, bool is_ours) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (file < 0 || ::flock(file, LOCK_EX | LOCK_NB) == 0) return file;
  if (is_ours && errno != EWOULDBLOCK) return file;
  ::close(file);
  return -1;
}

// "f0001.pov" of "f0001.pov.123.part"; empty for other names.
std::string find_part_name(const std::string& file_name) {
  constexpr std::string_view kEnding = ".part";
  if (!file_name.ends_with(kEnding)) return "";
  const std::string rest = file_name.substr(0, file_name.size() - kEnding.size());
  const std::size_t point = rest.rfind('.');
  if (point == rest.npos || point + 1 == rest.size()) return "";
  return rest.find_first_not_of("0123456789", point + 1) == rest.npos ? rest.substr(0, point) : "";
}

// Nobody who lives holds this file, and the disk can tell.
bool is_left(const std::filesystem::path& file) {
  const int opened = ::open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (opened < 0) return false;
  const bool is_free = ::flock(opened, LOCK_EX | LOCK_NB) == 0;
  ::close(opened);
  return is_free;
}

std::vector<std::filesystem::path> list_entries(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> entries;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    entries.push_back(entry->path());
  return entries;
}

}  // namespace

void remove_left_folders(const std::filesystem::path& folder) {
  std::error_code ignored;
  for (const std::filesystem::path& entry : list_entries(folder)) {
    if (!entry.filename().string().starts_with(kPrefix)) continue;
    const int file = open_locked(entry, false);
    if (file < 0) continue;
    std::filesystem::remove_all(entry, ignored);
    ::close(file);
  }
}

void remove_left_parts(const std::filesystem::path& folder,
                       const std::function<bool(const std::string& name)>& is_ours) {
  for (const std::filesystem::path& entry : list_entries(folder)) {
    const std::string name = find_part_name(entry.filename().string());
    if (!name.empty() && is_ours(name) && is_left(entry)) ::unlink(entry.c_str());
  }
}

void remove_left_parts_of(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.parent_path();
  remove_left_parts(folder.empty() ? "." : folder,
                    [&](const std::string& name) { return name == file.filename().string(); });
}

WorkFolder::WorkFolder(const std::filesystem::path& parent) {
  const std::filesystem::path shown = parent.empty() ? "." : parent;
  std::error_code error;
  std::filesystem::create_directories(shown, error);
  if (error) throw RunError(fmt::format("cannot write in {}: {}", shown.string(), error.message()));
  remove_left_folders(shown);
  while (true) {
    std::string name = (std::filesystem::absolute(shown) / kPrefix).string() + "XXXXXX";
    if (::mkdtemp(name.data()) == nullptr)
      throw RunError(fmt::format("cannot write in {}: {}", shown.string(), std::strerror(errno)));
    path = name;
    // Between the two lines another run may have taken our folder for a dead one's; then we make another.
    lock = open_locked(path, true);
    if (lock >= 0 && ::access(path.c_str(), F_OK) == 0) return;
    if (lock >= 0) ::close(lock);
  }
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path, ignored);
  ::close(lock);
}

void require_space(const std::filesystem::path& folder, std::size_t byte_count,
                   const std::filesystem::path& target) {
  const std::filesystem::path probe = folder / "space";
  const int file = ::open(probe.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  int error = file < 0 ? errno : ::posix_fallocate(file, 0, static_cast<off_t>(byte_count));
  if (file >= 0) {
    ::close(file);
    ::unlink(probe.c_str());
  }
  if (error == EOPNOTSUPP || error == EINVAL) error = 0;  // the disk cannot tell
  if (error != 0) throw RunError(fmt::format("cannot write {}: {}", target.string(), std::strerror(error)));
}

}  // namespace mien

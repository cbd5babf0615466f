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
#include <system_error>

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

void remove_left_folders(const std::filesystem::path& parent) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(parent, ignored)) {
    if (!entry.path().filename().string().starts_with(kPrefix)) continue;
    const int file = open_locked(entry.path(), false);
    if (file < 0) continue;
    std::filesystem::remove_all(entry.path(), ignored);
    ::close(file);
  }
}

}  // namespace

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

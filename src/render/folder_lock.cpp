// flock(2): the lock belongs to the open file and goes with its last descriptor, so that no number of a dead
// process must be judged. The file is removed before it is let go; one that was removed between our opening
// and our locking it locks nothing and is made again.
#include "render/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"
#include "render/failure.hpp"

namespace mien {

namespace {

namespace fs = std::filesystem;

constexpr const char* kName = ".mien.lock";
constexpr std::size_t kMostWords = 400;  // bytes of a command in a message

[[noreturn]] void fail_folder(const fs::path& folder, int error) {
  throw RunError(fmt::format("cannot write in {}: {}", folder.string(), std::strerror(error)));
}

// "12: mien render a.yaml", of ourselves.
std::string describe_us() {
  std::string line;
  try {
    line = read_file("/proc/self/cmdline");  // each word ends with a zero
  } catch (const RunError&) {
    line.clear();
  }
  std::vector<std::string> words;
  for (std::size_t at = 0; at < line.size();) {
    words.emplace_back(line.c_str() + at);
    at += words.back().size() + 1;
  }
  return fmt::format("{}: {}", ::getpid(), quote_command(words));
}

// What stands in the lock's file, as a part of a message.
std::string describe_holder(int file) {
  std::array<char, kMostWords> bytes;
  const ssize_t count = ::pread(file, bytes.data(), bytes.size(), 0);
  std::string text(bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  std::erase_if(text, [](unsigned char letter) { return letter < ' ' || letter == 127; });
  if (text.empty()) return "";  // it has only just begun
  return fmt::format(" (process {}{})", text, count == static_cast<ssize_t>(kMostWords) ? "..." : "");
}

bool is_still(int file, const fs::path& path) {
  struct stat ours {
  }, there{};
  return ::fstat(file, &ours) == 0 && ::stat(path.c_str(), &there) == 0 && ours.st_ino == there.st_ino &&
         ours.st_dev == there.st_dev;
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder) : path(folder / kName) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail_folder(folder, error.value());
  while (file < 0) {
    const int opened = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (opened < 0) fail_folder(folder, errno);
    int number = EINTR;
    while (number == EINTR) number = ::flock(opened, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
    if (number == EWOULDBLOCK) {
      const std::string holder = describe_holder(opened);
      ::close(opened);
      throw RunError(
          fmt::format("{} is being written by another run{}; wait for its end or write elsewhere with -o",
                      folder.string(), holder));
    }
    if (number != 0) {  // no locks here
      ::close(opened);
      ::unlink(path.c_str());
      return;
    }
    if (is_still(opened, path))
      file = opened;
    else
      ::close(opened);
  }
  const std::string us = describe_us();
  // A full disk keeps nobody from holding the lock; what is written next will say so.
  [[maybe_unused]] const bool is_told =
      ::ftruncate(file, 0) == 0 && ::pwrite(file, us.data(), us.size(), 0) >= 0;
}

FolderLock::FolderLock(FolderLock&& other) noexcept { *this = std::move(other); }

FolderLock& FolderLock::operator=(FolderLock&& other) noexcept {
  std::swap(path, other.path);
  std::swap(file, other.file);
  return *this;
}

FolderLock::~FolderLock() {
  if (file < 0) return;
  ::unlink(path.c_str());
  ::close(file);
}

}  // namespace mien

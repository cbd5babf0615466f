#include "render/folder_lock.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <optional>

#include "core/error.hpp"
#include "render/scratch.hpp"

namespace mien {
namespace {

TEST(folder_lock, keeps_others_out_as_long_as_it_lives) {
  const Scratch scratch;
  const auto folder = scratch.path / "deep/out";
  {
    FolderLock lock(folder);
    EXPECT_TRUE(lock.is_held());
    const std::string told = find_message<RunError>([&] { FolderLock second(folder); });
    EXPECT_TRUE(told.starts_with(
        fmt::format("{} is being written by another run (process {}: ", folder.string(), ::getpid())))
        << told;
    EXPECT_TRUE(told.ends_with("); wait for its end or write elsewhere with -o")) << told;
    const FolderLock moved = std::move(lock);
    EXPECT_TRUE(moved.is_held());
    EXPECT_THROW(FolderLock third(folder), RunError);
    EXPECT_NO_THROW(FolderLock other(scratch.path / "deep"));
  }
  EXPECT_EQ(count_files(folder), 0) << "nothing stays";
  EXPECT_TRUE(FolderLock(folder).is_held());
}

TEST(folder_lock, says_little_of_one_who_said_little_and_no_more_of_one_who_said_much) {
  const Scratch scratch;
  std::optional<FolderLock> lock(std::in_place, scratch.path);
  ASSERT_EQ(::truncate(lock->path.c_str(), 0), 0);
  EXPECT_EQ(find_message<RunError>([&] { FolderLock second(scratch.path); }),
            scratch.path.string() +
                " is being written by another run; wait for its end or write elsewhere with -o");
  std::string words = "12: \x1b[31mmien\n" + std::string(5000, 'x');
  ASSERT_EQ(::pwrite(lock->file, words.data(), words.size(), 0), static_cast<ssize_t>(words.size()));
  const std::string told = find_message<RunError>([&] { FolderLock second(scratch.path); });
  EXPECT_NE(told.find("(process 12: [31mmienxxx"), told.npos) << told;
  EXPECT_NE(told.find("xxx...); wait"), told.npos) << told;
  EXPECT_LT(told.size(), 700u);
}

TEST(folder_lock, goes_with_its_process) {
  const Scratch scratch;
  const pid_t child = ::fork();
  if (child == 0) {
    const FolderLock lock(scratch.path);
    write_file(scratch.path / "held", "x");
    ::pause();
    ::_exit(0);
  }
  for (int i = 0; i < 500 && !std::filesystem::exists(scratch.path / "held"); ++i) ::usleep(10000);
  EXPECT_THROW(FolderLock lock(scratch.path), RunError);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(std::filesystem::exists(scratch.path / ".mien.lock"));
  { EXPECT_TRUE(FolderLock(scratch.path).is_held()); }
  EXPECT_FALSE(std::filesystem::exists(scratch.path / ".mien.lock"));
}

TEST(folder_lock, lets_one_of_many_in_at_a_time) {
  const Scratch scratch;
  constexpr int kRunners = 8, kTurns = 50;
  write_file(scratch.path / "count", "0");
  std::vector<pid_t> children;
  for (int i = 0; i < kRunners; ++i) {
    const pid_t child = ::fork();
    if (child == 0) {
      for (int turn = 0; turn < kTurns;) {
        try {
          const FolderLock lock(scratch.path / "folder");
          write_file(scratch.path / "count",
                     std::to_string(std::stoi(read_file(scratch.path / "count")) + 1));
          ++turn;
        } catch (const RunError&) {
          ::usleep(100);
        }
      }
      ::_exit(0);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) ::waitpid(child, nullptr, 0);
  EXPECT_EQ(read_file(scratch.path / "count"), std::to_string(kRunners * kTurns));
}

TEST(folder_lock, tells_a_place_that_cannot_be_written) {
  EXPECT_EQ(find_message<RunError>([] { FolderLock lock("/dev/full/x"); }),
            "cannot write in /dev/full/x: Not a directory");
}

}  // namespace
}  // namespace mien

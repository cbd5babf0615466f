#include "core/streams.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <initializer_list>

namespace mien {
namespace {

// How `work` ends as a process of its own: what it returns.
template <typename Work>
int run_apart(const Work& work) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(work());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(streams, are_never_a_file_that_is_opened_later) {
  for (const std::initializer_list<int> closed :
       std::initializer_list<std::initializer_list<int>>{{}, {0}, {1}, {2}, {0, 1, 2}, {0, 2}}) {
    EXPECT_EQ(run_apart([&] {
                for (const int descriptor : closed) ::close(descriptor);
                open_missing_streams();
                return ::open("/dev/null", O_WRONLY) > 2 ? 0 : 1;
              }),
              0);
  }
}

TEST(streams, that_were_closed_take_nothing_and_say_so) {
  EXPECT_EQ(run_apart([] {
              ::close(0);
              ::close(2);
              open_missing_streams();
              char byte = 0;
              if (has_lost_text(stderr)) return 1;  // nothing was said yet
              write_stream(stderr, "lost");
              if (!has_lost_text(stderr)) return 2;
              return ::read(0, &byte, 1) == 0 && ::write(2, "x", 1) < 0 ? 0 : 3;
            }),
            0);
}

TEST(streams, that_are_full_say_so) {
  std::FILE* full = std::fopen("/dev/full", "w");
  ASSERT_NE(full, nullptr);
  EXPECT_FALSE(has_lost_text(full));
  EXPECT_NO_THROW(write_stream(full, "lost"));
  EXPECT_TRUE(has_lost_text(full));
  std::fclose(full);
}

}  // namespace
}  // namespace mien

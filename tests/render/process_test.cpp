#include "render/process.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <thread>

#include "core/error.hpp"
#include "render/scratch.hpp"

namespace mien {
namespace {

pid_t wait_for_number(const std::filesystem::path& file) {
  wait_for_lines(file, 1);
  return std::stoi(read_file(file));
}

TEST(process, hears_both_streams_and_the_exit_status) {
  const ProcessResult result = run_process({"sh", "-c", "echo one; echo two >&2; exit 3"}, ".");
  EXPECT_EQ(result.output, "one\ntwo\n");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(run_process({"sh", "-c", "kill -SEGV $$"}, ".").exit_code, 128 + SIGSEGV);
}

TEST(process, runs_in_its_folder_with_its_variables_and_without_input) {
  const Scratch scratch;
  ::setenv("MIEN_TEST", "ours", 1);
  const auto result =
      run_process({"sh", "-c", "pwd; echo $MIEN_TEST; cat"}, scratch.path, {"MIEN_TEST=theirs"});
  EXPECT_EQ(result.output, scratch.path.string() + "\ntheirs\n");
  EXPECT_EQ(run_process({"printenv", "MIEN_TEST"}, "").output, "ours\n");
}

TEST(process, reads_what_it_is_fed) {
  const Scratch scratch;
  const std::string much(3000000, 'a');
  Process counter = start_fed_process({"wc", "-c"}, scratch.path);
  EXPECT_TRUE(feed_process(counter, much.data(), much.size()));
  EXPECT_TRUE(feed_process(counter, "bcd", 3));
  close_input(counter);
  wait_for_any({&counter});
  EXPECT_EQ(counter.result.output, "3000003\n");
  EXPECT_EQ(counter.result.exit_code, 0);
}

TEST(process, that_reads_no_more_is_fed_no_more) {
  const std::string much(3000000, 'a');
  Process fussy = start_fed_process({"sh", "-c", "head -c 10 >/dev/null; echo enough; exit 4"}, ".");
  EXPECT_FALSE(feed_process(fussy, much.data(), much.size()));
  close_input(fussy);
  if (fussy.id != 0) wait_for_any({&fussy});
  EXPECT_EQ(fussy.result.output, "enough\n");
  EXPECT_EQ(fussy.result.exit_code, 4);
  EXPECT_FALSE(feed_process(fussy, much.data(), much.size()));
}

TEST(process, keeps_the_end_of_a_flood) {
  const ProcessResult result = run_process({"sh", "-c", "yes | head -c 9000000; echo end"}, ".");
  EXPECT_LE(result.output.size(), 2u << 20);
  EXPECT_TRUE(result.output.ends_with("y\nend\n"));
}

TEST(process, does_not_wait_for_a_grandchild_that_holds_the_output) {
  const ProcessResult result = run_process({"sh", "-c", "sleep 60 & echo said"}, ".");
  EXPECT_EQ(result.output, "said\n");
  EXPECT_LT(result.wall_s, 30);  // seconds: half of the grandchild's, however busy the machine
}

TEST(process, is_ended_at_once_by_a_second_signal_that_is_meant) {
  const pid_t child = ::fork();
  if (child == 0) {
    install_signal_handlers();
    ::raise(SIGINT);
    ::raise(SIGINT);
    ::usleep(1'100'000);
    ::raise(SIGTERM);
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM) << status;
}

TEST(process, waits_for_one_of_many) {
  Process fast = start_process({"sh", "-c", "echo fast"}, "."), slow = start_process({"sleep", "20"}, ".");
  wait_for_any({&fast, &slow});
  EXPECT_EQ(fast.id, 0);
  EXPECT_EQ(fast.result.output, "fast\n");
  EXPECT_NE(slow.id, 0);
}

TEST(process, tells_what_cannot_be_started) {
  EXPECT_EQ(find_message<RunError>([] { run_process({"no-such-program"}, "/tmp"); }),
            "cannot start no-such-program in /tmp: No such file or directory");
  EXPECT_EQ(find_message<RunError>([] { run_process({"true"}, "/no/such/folder"); }),
            "cannot start true in /no/such/folder: No such file or directory");
}

TEST(process, names_the_package_of_a_missing_program) {
  EXPECT_NO_THROW(require_programs({{"povray", "povray"}, {"ffprobe", "ffmpeg"}}));
  EXPECT_EQ(find_message<RunError>([] {
              require_programs({{"sh", "dash"}, {"povrax", "povray"}});
            }),
            "povrax is not installed; install it with: apt-get install povray");
  const Scratch scratch;
  std::filesystem::create_directory(scratch.path / "povray");  // a folder is no program
  const std::string before = std::getenv("PATH");
  ::setenv("PATH", scratch.path.c_str(), 1);
  EXPECT_EQ(find_message<RunError>([] {
              require_programs({{"povray", "povray"}});
            }),
            "povray is not installed; install it with: apt-get install povray");
  ::setenv("PATH", before.c_str(), 1);
}

TEST(process, ends_children_and_grandchildren_on_a_signal) {
  const Scratch scratch;
  install_signal_handlers();
  std::thread finger([&] {
    wait_for_number(scratch.path / "id");
    ::kill(::getpid(), SIGINT);
  });
  const std::string script = "sleep 60 & echo $! > id; wait";
  EXPECT_EQ(find_message<Interrupted>([&] {
              run_process({"sh", "-c", script}, scratch.path);
            }),
            "interrupted; what was finished is kept, run again to go on");
  finger.join();
  ::kill(::getpid(), SIGINT);  // its echo
  EXPECT_TRUE(is_gone(std::stoi(read_file(scratch.path / "id"))));
  EXPECT_THROW(run_process({"true"}, "."), Interrupted);
  EXPECT_THROW(throw_if_interrupted(), Interrupted);
  install_signal_handlers();
  EXPECT_EQ(run_process({"true"}, ".").exit_code, 0);
}

// MIEN_STALL_LIMIT while it lives.
struct StallLimit {
  explicit StallLimit(const char* seconds) { ::setenv("MIEN_STALL_LIMIT", seconds, 1); }
  ~StallLimit() { ::unsetenv("MIEN_STALL_LIMIT"); }
};

TEST(process, takes_ten_minutes_or_what_is_said_for_a_stall) {
  EXPECT_EQ(read_stall_limit_s(), 600);
  for (const auto& [text, limit_s] : {std::pair{"2.5", 2.5}, {"0", 0.0}, {"", 600.0}}) {
    const StallLimit limit(text);
    EXPECT_EQ(read_stall_limit_s(), limit_s);
  }
  const StallLimit limit("ten");
  EXPECT_EQ(find_message<InputError>([] { read_stall_limit_s(); }),
            "MIEN_STALL_LIMIT: 'ten' is not a number of seconds such as 600, or 0 for no limit");
}

TEST(process, ends_what_does_nothing_with_its_children) {
  const Scratch scratch;
  const StallLimit limit("1");
  const ProcessResult result =
      run_process({"sh", "-c", "echo hm; sleep 60 & echo $! > id; wait"}, scratch.path);
  EXPECT_EQ(result.stalled_s, 1);
  EXPECT_EQ(result.output, "hm\n");
  EXPECT_GE(result.wall_s, 1);
  EXPECT_LT(result.wall_s, 30);  // half of what it would have slept, however busy the machine
  EXPECT_TRUE(is_gone(std::stoi(read_file(scratch.path / "id"))));
  EXPECT_EQ(describe_end("sh", result),
            "sh hung and was ended: for 1 s it said nothing and hardly worked; run again, or let "
            "MIEN_STALL_LIMIT be more seconds (0: no limit)");
  ProcessResult killed;
  killed.exit_code = 137;
  EXPECT_EQ(describe_end("sh", killed), "sh was ended by signal 9 (Killed)");
}

TEST(process, ends_one_that_hangs_and_not_the_other) {
  const StallLimit limit("1");
  Process hung = start_process({"sleep", "60"}, "."),
          busy = start_process({"sh", "-c", "while :; do :; done"}, ".");
  wait_for_any({&hung, &busy});
  EXPECT_EQ(hung.id, 0);
  EXPECT_EQ(hung.result.stalled_s, 1);
  EXPECT_NE(busy.id, 0);
}

TEST(process, waits_for_what_computes_talks_or_has_no_limit) {
  const auto run = [](const char* seconds, const char* script) {
    const StallLimit limit(seconds);
    return run_process({"sh", "-c", script}, ".");
  };
  const ProcessResult talks = run("1", "for i in 1 2 3 4 5 6; do sleep 0.4; echo $i; done");
  EXPECT_EQ(talks.output, "1\n2\n3\n4\n5\n6\n");
  EXPECT_EQ(talks.stalled_s, 0);
  // A child's work is its parent's.
  EXPECT_EQ(run("1", "timeout 3 sh -c 'while :; do :; done' & wait; echo done").output, "done\n");
  EXPECT_EQ(run("0", "sleep 2; echo done").output, "done\n");
}

TEST(process, leaves_no_child_when_we_are_killed) {
  const Scratch scratch;
  const pid_t parent = ::fork();
  if (parent == 0) {
    run_process({"sh", "-c", "echo $$ > id; exec sleep 60"}, scratch.path);
    ::_exit(0);
  }
  const pid_t child = wait_for_number(scratch.path / "id");
  ::kill(parent, SIGKILL);
  ::waitpid(parent, nullptr, 0);
  EXPECT_TRUE(is_gone(child));
}

}  // namespace
}  // namespace mien

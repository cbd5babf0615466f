#include "live/jobs.hpp"

#include <gtest/gtest.h>

#include <chrono>

#include "core/error.hpp"
#include "places.hpp"

namespace mien {
namespace {

Job wait_for_end(Jobs& jobs, int id) {
  std::unique_lock lock(jobs.mutex);
  const auto find = [&]() -> const Job& {
    for (const Job& job : jobs.jobs)
      if (job.id == id) return job;
    throw std::logic_error("gone");
  };
  jobs.changed.wait_for(lock, std::chrono::seconds(30), [&] { return find().state > JobState::running; });
  return find();
}

int add_shell(Jobs& jobs, const std::string& script) {
  return add_job(jobs, "test", "Test", {"sh", "-c", script});
}

TEST(live_jobs, hear_what_the_program_says) {
  Jobs jobs;
  const std::string result = std::string(source_folder()) + "/README.md";
  const int id = add_shell(
      jobs,
      "echo '{\"event\":\"frame\",\"stage\":\"frames\",\"frame\":3,\"done\":3,\"total\":48}'; "
      "echo '{\"kind\":\"warning\",\"file\":\"a.yaml\",\"line\":3,\"column\":7,\"message\":\"too quick\"}'; "
      "echo '{\"clip\":\"" +
          result + "\"}'; printf 'no end'");
  const Job job = wait_for_end(jobs, id);
  EXPECT_EQ(job.state, JobState::done);
  EXPECT_EQ(job.stage, "frames");
  EXPECT_EQ(job.finished, 3);
  EXPECT_EQ(job.all, 48);
  EXPECT_EQ(job.lines,
            (std::deque<std::string>{"a.yaml:3:7: warning: too quick", "clip    " + result, "no end"}));
  EXPECT_EQ(job.results, (std::vector<std::filesystem::path>{result}));
}

TEST(live_jobs, fail_with_their_words) {
  Jobs jobs;
  const int failing = add_shell(jobs, "echo it broke >&2; exit 1");
  const int missing = add_job(jobs, "test", "Test", {"no-such-program-anywhere"});
  const Job failed = wait_for_end(jobs, failing);
  EXPECT_EQ(failed.state, JobState::failed);
  EXPECT_EQ(failed.lines, (std::deque<std::string>{"it broke"}));
  const Job lost = wait_for_end(jobs, missing);
  EXPECT_EQ(lost.state, JobState::failed);
  EXPECT_EQ(
      lost.lines,
      (std::deque<std::string>{"cannot start no-such-program-anywhere in .: No such file or directory"}));
}

TEST(live_jobs, run_one_after_the_other_and_are_stopped) {
  Jobs jobs;
  const int first = add_shell(jobs, "sleep 60"), second = add_shell(jobs, "sleep 60"),
            third = add_shell(jobs, "exit 0");
  stop_job(jobs, second);
  stop_job(jobs, first);
  EXPECT_EQ(wait_for_end(jobs, first).state, JobState::stopped);
  EXPECT_EQ(wait_for_end(jobs, second).state, JobState::stopped);
  EXPECT_EQ(wait_for_end(jobs, third).state, JobState::done);
  stop_job(jobs, third);
  EXPECT_EQ(wait_for_end(jobs, third).state, JobState::done);
}

TEST(live_jobs, a_hand_that_slips_is_told) {
  Jobs jobs;
  add_shell(jobs, "sleep 60");
  std::string message;
  for (int i = 0; i < 30 && message.empty(); ++i) try {
      add_shell(jobs, "exit 0");
    } catch (const InputError& error) {
      message = error.diagnostics.front().message;
    }
  EXPECT_EQ(message, "10 are waiting; expected some of them to end first");
}

TEST(live_jobs, keep_the_last_lines) {
  Jobs jobs;
  const Job job = wait_for_end(jobs, add_shell(jobs, "seq 1 500"));
  EXPECT_EQ(job.lines.size(), 60u);
  EXPECT_EQ(job.lines.back(), "500");
}

TEST(live_jobs, end_with_what_runs) {
  const auto begun = std::chrono::steady_clock::now();
  {
    Jobs jobs;
    add_shell(jobs, "sleep 60");
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(20));
}

}  // namespace
}  // namespace mien

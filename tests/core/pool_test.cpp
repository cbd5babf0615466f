#include "core/pool.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace mien {
namespace {

// Sets the number of threads for one test.
struct Jobs {
  explicit Jobs(int count) { set_job_count(count); }
  ~Jobs() { set_job_count(0); }
};

// Who works, and how many at the same time at the most.
struct Watch {
  std::mutex mutex;
  std::set<std::thread::id> threads;
  int now = 0, most = 0;

  void work() {
    {
      const std::lock_guard lock(mutex);
      threads.insert(std::this_thread::get_id());
      most = std::max(most, ++now);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const std::lock_guard lock(mutex);
    --now;
  }
};

TEST(pool, work_within_work_uses_no_more_threads_than_it_may) {
  for (const int jobs : {1, 2, 3, 7}) {
    const Jobs set(jobs);
    Watch watch;
    for_each_index(12, 100, [&](std::size_t, int) {
      for_each_index(
          6, 100, [&](std::size_t, int) { for_each_index(2, 100, [&](std::size_t, int) { watch.work(); }); });
    });
    EXPECT_LE(watch.most, jobs);
    EXPECT_LE(watch.threads.size(), static_cast<std::size_t>(jobs));
    if (jobs > 1) {
      EXPECT_GT(watch.threads.size(), 1u) << jobs;
    }
  }
}

TEST(pool, gives_no_more_threads_than_a_call_asks_for) {
  const Jobs set(8);
  Watch watch;
  for_each_index(60, 2, [&](std::size_t, int worker) {
    EXPECT_LT(worker, 2);
    watch.work();
  });
  EXPECT_LE(watch.most, 2);
}

TEST(pool, results_are_the_same_for_any_number_of_threads) {
  std::vector<double> expected;
  for (const int jobs : {1, 2, 7, 16}) {
    const Jobs set(jobs);
    std::vector<double> sums(50);
    for_each_index(sums.size(), count_workers(), [&](std::size_t i, int) {
      std::vector<double> terms(40);
      for_each_index(terms.size(), count_workers(),
                     [&](std::size_t k, int) { terms[k] = 1 / (1.0 + static_cast<double>(i * k)); });
      sums[i] = std::accumulate(terms.begin(), terms.end(), 0.0);
    });
    if (expected.empty()) expected = sums;
    EXPECT_EQ(sums, expected) << jobs;
  }
}

TEST(pool, a_worker_is_one_at_a_time_even_while_it_waits_for_inner_work) {
  const Jobs set(4);
  std::vector<std::atomic<int>> busy(4);
  std::atomic<int> clashes = 0;
  for_each_index(80, 4, [&](std::size_t, int worker) {
    if (busy[static_cast<std::size_t>(worker)]++ != 0) ++clashes;
    for_each_index(8, 4,
                   [](std::size_t, int) { std::this_thread::sleep_for(std::chrono::microseconds(50)); });
    --busy[static_cast<std::size_t>(worker)];
  });
  EXPECT_EQ(clashes, 0);
}

TEST(pool, who_waits_for_inner_work_does_nothing_of_the_outer_work) {
  const Jobs set(4);
  std::mutex mutex;  // not recursive: a thread that took up outer work while it waits would wait for itself
  int done = 0;
  for_each_index(40, 4, [&](std::size_t, int) {
    const std::lock_guard lock(mutex);
    for_each_index(16, 4, [](std::size_t, int) { std::this_thread::yield(); });
    ++done;
  });
  EXPECT_EQ(done, 40);
}

TEST(pool, the_first_exception_stops_the_rest_and_comes_out) {
  for (const int jobs : {1, 4}) {
    const Jobs set(jobs);
    std::atomic<int> begun = 0;
    EXPECT_THROW(for_each_index(10000, jobs,
                                [&](std::size_t i, int) {
                                  ++begun;
                                  for_each_index(4, jobs, [&](std::size_t k, int) {
                                    if (i == 3 && k == 2) throw std::runtime_error("no");
                                  });
                                }),
                 std::runtime_error);
    EXPECT_LT(begun, 10000);
  }
}

TEST(pool, has_as_many_threads_as_cores_unless_it_is_told) {
  set_job_count(0);
  EXPECT_EQ(count_workers(), count_cores());
  const Jobs set(5);
  EXPECT_EQ(count_workers(), 5);
}

}  // namespace
}  // namespace mien

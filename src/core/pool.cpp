// oneTBB specification, task_arena::execute and this_task_arena::isolate: a thread that waits inside isolated
// work takes up tasks of that work alone.
#include "core/pool.hpp"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>

#include "core/signals.hpp"

namespace mien {

namespace {

struct Pool {
  int limit;
  tbb::global_control
      control;  // of whatever else uses oneTBB, too; also lets it have more threads than cores
  tbb::task_arena arena;

  explicit Pool(int limit_)
      : limit(limit_),
        control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(limit_)),
        arena(limit_) {}
};

std::unique_ptr<Pool>& find_pool() {
  static std::unique_ptr<Pool> pool = std::make_unique<Pool>(count_cores());
  return pool;
}

}  // namespace

void set_job_count(int jobs) {
  const int limit = jobs < 1 ? count_cores() : jobs;
  std::unique_ptr<Pool>& pool = find_pool();
  if (pool->limit != limit) pool = std::make_unique<Pool>(limit);
}

int count_workers() { return find_pool()->limit; }

int count_cores() { return static_cast<int>(std::max(1u, std::thread::hardware_concurrency())); }

void for_each_index(std::size_t count, int jobs, const std::function<void(std::size_t, int)>& work) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto run = [&](int worker) {
    for (std::size_t i = next++; i < count; i = next++) try {
        throw_if_interrupted();
        work(i, worker);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
  };
  Pool& pool = *find_pool();
  const auto most = static_cast<std::size_t>(std::clamp(jobs, 1, pool.limit));
  const int workers = static_cast<int>(std::min(most, count));
  if (workers <= 1) {
    run(0);
  } else {
    pool.arena.execute([&] {
      tbb::this_task_arena::isolate([&] {
        tbb::task_group others;
        for (int worker = 1; worker < workers; ++worker) others.run([&run, worker] { run(worker); });
        run(0);
        others.wait();
      });
    });
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace mien

#include "core/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace mien {

void for_each_index(std::size_t count, int jobs, const std::function<void(std::size_t, int)>& work) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto run = [&](int worker) {
    for (std::size_t i = next++; i < count; i = next++) try {
        work(i, worker);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
  };
  std::vector<std::jthread> threads;
  const int extra =
      static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(std::max(jobs, 1)), count)) - 1;
  for (int worker = 1; worker <= extra; ++worker) threads.emplace_back(run, worker);
  run(0);
  threads.clear();  // joins
  if (failure) std::rethrow_exception(failure);
}

int count_cores() { return static_cast<int>(std::max(1u, std::thread::hardware_concurrency())); }

}  // namespace mien

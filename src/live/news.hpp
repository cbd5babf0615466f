// Pages that wait for news: the answer comes when there is some.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace mien {

inline constexpr double kNews_s = 25;      // then a page is answered without news, and asks again
inline constexpr double kShortNews_s = 1;  // where many wait: they must leave threads for requests
inline constexpr int kMostWaitingPages = 16;

// `waiting` counts them; `lock` guards it and all that `is_news` asks.
template <typename IsNews>
void wait_for_news(std::unique_lock<std::mutex>& lock, std::condition_variable& changed, int& waiting,
                   IsNews is_news) {
  const double most_s = waiting < kMostWaitingPages ? kNews_s : kShortNews_s;
  ++waiting;
  changed.wait_for(lock, std::chrono::duration<double>(most_s), is_news);
  --waiting;
}

}  // namespace mien

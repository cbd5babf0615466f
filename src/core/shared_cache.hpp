// A cache of costly things that several threads share: each is made once while it is kept, and few are kept.
#pragma once

#include <cstddef>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>

namespace mien {

// Things by number. Whoever takes them goes upward, so that of more than `room` the lowest is let go.
template <typename Thing>
struct SharedCache {
  explicit SharedCache(std::size_t room_) : room(room_) {}

  std::size_t room;
  std::mutex mutex;
  std::map<std::size_t, std::shared_future<std::shared_ptr<const Thing>>> things;
};

// Number `index`, made by `build` if nobody has; else waits for whoever is making it. It lives as long as
// anybody holds it. What `build` throws is thrown to all who ask.
template <typename Thing>
std::shared_ptr<const Thing> share_thing(SharedCache<Thing>& cache, std::size_t index,
                                         const std::function<Thing()>& build) {
  std::promise<std::shared_ptr<const Thing>> promise;
  std::shared_future<std::shared_ptr<const Thing>> found;
  {
    const std::lock_guard lock(cache.mutex);
    const auto [entry, is_new] = cache.things.try_emplace(index);
    if (!is_new) {
      found = entry->second;
    } else {
      entry->second = promise.get_future().share();
      while (cache.things.size() > cache.room) cache.things.erase(cache.things.begin());
    }
  }
  if (found.valid()) return found.get();
  try {
    auto thing = std::make_shared<const Thing>(build());
    promise.set_value(thing);
    return thing;
  } catch (...) {
    promise.set_exception(std::current_exception());
    throw;
  }
}

}  // namespace mien

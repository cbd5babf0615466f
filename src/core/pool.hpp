// Doing many independent things on several cores.
#pragma once

#include <cstddef>
#include <functional>

namespace mien {

// Calls `work(index, worker)` once for each index below `count`, on up to `jobs` threads; `worker` (below
// `jobs`) names the thread, so that each can have its own buffers. Indices are begun in ascending order. The
// first exception stops what has not begun and is thrown again here.
void for_each_index(std::size_t count, int jobs,
                    const std::function<void(std::size_t index, int worker)>& work);

// As many threads as the machine runs at once; at least 1.
int count_cores();

}  // namespace mien

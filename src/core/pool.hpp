// Doing many independent things on several cores: one pool of threads (oneTBB's) for the whole program.
#pragma once

#include <cstddef>
#include <functional>

namespace mien {

// How many threads may work at once from now on, the caller's among them: `--jobs`; below 1: as many as
// cores. Said once, before the first work; while work is going on it must not be said.
void set_job_count(int jobs);

// As many threads as may work at once; at least 1.
int count_workers();

// As many threads as the machine runs at once; at least 1.
int count_cores();

// Calls `work(index, worker)` once for each index below `count`, on up to `jobs` threads of the pool, the
// caller's among them; `worker` (below `jobs`) is nobody else's during the call, so that each can have its
// own buffers. Work may call this again: all share the same threads, and whoever waits for inner work does
// nothing of the outer work meanwhile, so that what it holds locked stays its own affair. Indices are begun
// in ascending order. The first exception stops what has not begun and is thrown again here; so does Ctrl-C
// (core/signals.hpp).
void for_each_index(std::size_t count, int jobs,
                    const std::function<void(std::size_t index, int worker)>& work);

}  // namespace mien

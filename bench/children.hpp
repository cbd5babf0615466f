// What programs that we run cost.
#pragma once

#include <sys/resource.h>

namespace mien {

// What all children so far have used of cores, s.
inline double read_children_s() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

}  // namespace mien

// The time that passes, which no clock of the day's time sets back.
#pragma once

#include <chrono>

namespace mien {

// Seconds since some moment before the program began.
inline double read_clock_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace mien

#include "core/signals.hpp"

#include <signal.h>
#include <time.h>

#include <algorithm>
#include <atomic>
#include <cerrno>

#include "core/error.hpp"

namespace mien {

namespace {

constexpr long kEcho_ms = 1000;  // nobody who means "at once" presses twice so fast; wrappers do

// The one thing a signal handler may touch, and any thread may ask: when the first signal came; 0: none did.
std::atomic<long> signal_ms = 0;
static_assert(std::atomic<long>::is_always_lock_free);

long read_clock_ms() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return std::max(1L, now.tv_sec * 1000L + now.tv_nsec / 1'000'000L);
}

// Only calls that are safe there (signal-safety(7)).
extern "C" void note_signal(int number) {
  const int error = errno;
  const long now_ms = read_clock_ms();
  long first_ms = 0;
  if (!signal_ms.compare_exchange_strong(first_ms, now_ms) && now_ms - first_ms >= kEcho_ms) {
    ::signal(number, SIG_DFL);
    ::raise(number);  // ends us as soon as this function returns
  }
  errno = error;
}

}  // namespace

void install_signal_handlers() {
  signal_ms = 0;
  struct sigaction action {};
  action.sa_handler = note_signal;  // without SA_RESTART: poll() shall wake
  ::sigemptyset(&action.sa_mask);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) ::sigaction(number, &action, nullptr);
  ::signal(SIGPIPE, SIG_IGN);
}

void throw_if_interrupted() {
  if (signal_ms != 0) throw Interrupted();
}

}  // namespace mien

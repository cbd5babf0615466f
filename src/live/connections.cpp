#include "live/connections.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "core/clock.hpp"
#include "live/server.hpp"

namespace mien {

namespace {

constexpr double kCrowdedIdle_s = 0.05;
constexpr double kCrowdedRequest_s = 2;  // then whoever dawdles makes room for others
constexpr double kWrite_s = 20;          // for a reader who has stopped reading
constexpr int kLook_ms = 50;             // how late an end or a crowd is noticed

bool is_crowded(const Crowd& crowd) { return crowd.count.load() > static_cast<int>(kMaxThreads) / 2; }

}  // namespace

bool BoundedStream::wait(short events, double end_s) const {
  while (true) {
    pollfd waited{socket_, events, 0};
    const double left_s = end_s - read_clock_s();
    const int step_ms = std::clamp(static_cast<int>(left_s * 1000), 0, kLook_ms);
    const int ready = ::poll(&waited, 1, step_ms);
    if (ready > 0) return true;
    if (ready < 0 && errno != EINTR) return false;
    if (left_s <= 0 || crowd_.is_ending) return false;
  }
}

bool BoundedStream::wait_for_request() {
  const double begun_s = read_clock_s();
  while (begin_ == end_) {
    const double now_s = read_clock_s();
    if (now_s - begun_s > (is_crowded(crowd_) ? kCrowdedIdle_s : kIdle_s) || crowd_.is_ending) return false;
    if (wait(POLLIN, now_s + kCrowdedIdle_s)) break;
  }
  end_s_ = read_clock_s() + (is_crowded(crowd_) ? kCrowdedRequest_s : kMaxRequest_s);
  bytes_left_ = kMaxRequest_bytes;
  return true;
}

bool BoundedStream::is_readable() const { return begin_ < end_ || wait(POLLIN, end_s_); }

bool BoundedStream::is_writable() const { return wait(POLLOUT, read_clock_s() + kWrite_s); }

ssize_t BoundedStream::read(char* to, std::size_t size) {
  if (begin_ == end_) {
    if (bytes_left_ == 0 || !wait(POLLIN, end_s_)) return -1;
    const ssize_t count = ::recv(socket_, buffer_.data(), std::min(buffer_.size(), bytes_left_), 0);
    if (count <= 0) return count;
    begin_ = 0;
    end_ = static_cast<std::size_t>(count);
    bytes_left_ -= end_;
  }
  const std::size_t count = std::min(size, end_ - begin_);
  std::memcpy(to, buffer_.data() + begin_, count);
  begin_ += count;
  return static_cast<ssize_t>(count);
}

ssize_t BoundedStream::write(const char* from, std::size_t size) {
  if (!is_writable()) return -1;
  return ::send(socket_, from, size, MSG_NOSIGNAL | MSG_DONTWAIT);
}

void BoundedStream::find_place(std::string& ip, int& port) {
  ip = "127.0.0.1";
  port = 0;
}

void LiveThreads::enqueue(std::function<void()> task) {
  const std::lock_guard lock(mutex_);
  tasks_.push_back(std::move(task));
  if (idle_ < tasks_.size() && threads_.size() < most_) threads_.emplace_back([this] { work(); });
  waiting_.notify_one();
}

void LiveThreads::shutdown() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
  }
  waiting_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void LiveThreads::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    ++idle_;
    waiting_.wait(lock, [this] { return is_ending_ || !tasks_.empty(); });
    --idle_;
    if (tasks_.empty()) return;
    const std::function<void()> task = std::move(tasks_.front());
    tasks_.pop_front();
    lock.unlock();
    task();
    lock.lock();
  }
}

}  // namespace mien

// One connection of the server, and the threads that hear them. Beneath cpp-httplib, which has no bounds for
// headers, for time, and for bodies in chunks.
#pragma once

#include <httplib.h>

#include <array>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace mien {

inline constexpr double kIdle_s = 4;  // a browser keeps its connections for the next request

// How many connections there are, heard or waiting; when there are too many, idle ones are closed.
struct Crowd {
  std::atomic<int> count{0};
  std::atomic<bool> is_ending{false};
};

// A socket whose requests are bounded in bytes and in time.
class BoundedStream : public httplib::Stream {
 public:
  BoundedStream(int socket, const Crowd& crowd) : socket_(socket), crowd_(crowd) {}

  // Sleeps until a request begins; false if none came in time.
  bool wait_for_request();

  bool is_readable() const override;
  bool is_writable() const override;
  ssize_t read(char* to, std::size_t size) override;
  ssize_t write(const char* from, std::size_t size) override;
  void get_remote_ip_and_port(std::string& ip, int& port) const override { find_place(ip, port); }
  void get_local_ip_and_port(std::string& ip, int& port) const override { find_place(ip, port); }
  int socket() const override { return socket_; }

 private:
  bool wait(short events, double end_s) const;
  static void find_place(std::string& ip, int& port);  // nobody here asks for it

  int socket_;
  const Crowd& crowd_;
  double end_s_ = 0;            // of the request that is being read
  std::size_t bytes_left_ = 0;  // that it may still have
  std::array<char, 4096> buffer_{};
  std::size_t begin_ = 0, end_ = 0;  // of what is in the buffer
};

// Threads that are made as connections come, up to a number, and stay.
class LiveThreads : public httplib::TaskQueue {
 public:
  explicit LiveThreads(std::size_t most) : most_(most) {}
  void enqueue(std::function<void()> task) override;
  void shutdown() override;

 private:
  void work();

  std::size_t most_, idle_ = 0;
  bool is_ending_ = false;
  std::mutex mutex_;
  std::condition_variable waiting_;
  std::deque<std::function<void()>> tasks_;
  std::vector<std::thread> threads_;
};

}  // namespace mien

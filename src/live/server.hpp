// A web server for one page on this machine: it listens on 127.0.0.1 alone, answers nobody without the token
// of its address, and takes nothing that is too large or too slow.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

namespace mien {

struct LiveRequest {
  bool is_post = false;
  std::string path;  // below the token: "api/check", "" for the page itself
  std::map<std::string, std::string> query;
  std::string body;
};

struct LiveAnswer {
  int status = 200;
  std::string type = "application/json";
  std::string body;
};

// One line of JSON that tells what is wrong.
LiveAnswer build_refusal(int status, const std::string& message);

// Asked by many threads at once. What it throws is answered as an error of the server.
using LiveHandler = std::function<LiveAnswer(const LiveRequest&)>;

// What a request may be at most.
inline constexpr std::size_t kMaxBody_bytes = 2u << 20;  // a file of the largest size, as JSON
inline constexpr std::size_t kMaxRequest_bytes = kMaxBody_bytes + (64u << 10);  // with all its headers
inline constexpr double kMaxRequest_s = 10;                                     // until all of it is here
inline constexpr std::size_t kMaxThreads = 48;  // connections that are heard at once; others wait

struct LiveServer {
  // Port 0: any that is free. Throws RunError "port N is not free on 127.0.0.1".
  LiveServer(int port, LiveHandler handler);
  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;
  ~LiveServer();  // waits for the answers that are being made

  int port = 0;
  std::string token;
  std::string address;  // "http://127.0.0.1:PORT/TOKEN/"

  struct Parts;
  std::unique_ptr<Parts> parts;
};

}  // namespace mien

// A client that says what it likes: for tests of servers.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <string>
#include <utility>

namespace mien {

struct Connection {
  explicit Connection(int port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) close();
  }
  Connection(Connection&& other) noexcept : socket(std::exchange(other.socket, -1)) {}
  Connection& operator=(Connection&&) = delete;
  ~Connection() { close(); }

  void close() {
    if (socket >= 0) ::close(std::exchange(socket, -1));
  }
  // False once the other side hears no more.
  bool send(std::string_view text) {
    while (!text.empty()) {
      const ssize_t count = ::send(socket, text.data(), text.size(), MSG_NOSIGNAL);
      if (count <= 0) return false;
      text.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
  }
  // All that comes until the other side closes, or nothing comes for so long.
  std::string receive(int most_ms = 15000) {
    std::string text;
    char buffer[65536];
    pollfd waited{socket, POLLIN, 0};
    while (::poll(&waited, 1, most_ms) > 0) {
      const ssize_t count = ::recv(socket, buffer, sizeof buffer, 0);
      if (count <= 0) break;
      text.append(buffer, static_cast<std::size_t>(count));
    }
    return text;
  }

  int socket = -1;
};

// The whole answer to a request, which asks the server to close.
inline std::string ask(int port, const std::string& request) {
  Connection connection(port);
  connection.send(request);
  return connection.receive();
}

inline std::string build_get(const std::string& path, const std::string& host, const std::string& more = "") {
  return "GET " + path + " HTTP/1.1\r\nHost: " + host + "\r\nConnection: close\r\n" + more + "\r\n";
}

inline std::string build_post(const std::string& path, const std::string& host, const std::string& body,
                              const std::string& type = "application/json", const std::string& more = "") {
  return "POST " + path + " HTTP/1.1\r\nHost: " + host + "\r\nConnection: close\r\nContent-Type: " + type +
         "\r\nContent-Length: " + std::to_string(body.size()) + "\r\n" + more + "\r\n" + body;
}

// 200 of "HTTP/1.1 200 OK"; 0 of what is no answer.
inline int find_status(const std::string& answer) {
  return answer.starts_with("HTTP/1.1 ") ? std::atoi(answer.c_str() + 9) : 0;
}

inline std::string find_body(const std::string& answer) {
  const std::size_t end = answer.find("\r\n\r\n");
  return end == std::string::npos ? "" : answer.substr(end + 4);
}

}  // namespace mien

// What a hostile or clumsy client gets.
#include "live/server.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <utility>
#include <vector>

#include "core/clock.hpp"
#include "core/error.hpp"
#include "live/client.hpp"

namespace mien {
namespace {

// Says back what it was asked.
LiveAnswer repeat(const LiveRequest& request) {
  if (request.path == "fail") throw RunError("it broke");
  return {200, "text/plain", (request.is_post ? "POST " : "GET ") + request.path + " " + request.body};
}

struct Served {
  LiveServer server{0, repeat};
  std::string host = "127.0.0.1:" + std::to_string(server.port);
  std::string path = "/" + server.token + "/";
};

std::size_t measure_memory_kb() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmRSS:")) return std::stoul(line.substr(6));
  return 0;
}

void expect_serving(const Served& served) {
  EXPECT_EQ(find_body(ask(served.server.port, build_get(served.path + "x", served.host))), "GET x ");
}

TEST(live_server, answers_who_has_the_token) {
  const Served served;
  EXPECT_EQ(served.server.address, "http://" + served.host + served.path);
  expect_serving(served);
  EXPECT_EQ(find_body(ask(served.server.port, build_post(served.path + "y", served.host, "{}"))),
            "POST y {}");
}

TEST(live_server, every_answer_keeps_the_page_to_itself) {
  const Served served;
  for (const std::string& path : {served.path, std::string("/nobody/")}) {
    const std::string answer = ask(served.server.port, build_get(path, served.host));
    EXPECT_NE(answer.find("Content-Security-Policy: default-src 'none'; script-src 'self';"), answer.npos);
    EXPECT_NE(answer.find("frame-ancestors 'none'"), answer.npos);
    EXPECT_NE(answer.find("X-Content-Type-Options: nosniff"), answer.npos);
    EXPECT_NE(answer.find("Referrer-Policy: no-referrer"), answer.npos);
    EXPECT_NE(answer.find("Cross-Origin-Resource-Policy: same-origin"), answer.npos);
    EXPECT_EQ(answer.find("Access-Control-Allow-Origin"), answer.npos);
  }
}

TEST(live_server, strangers_learn_nothing) {
  const Served served;
  const auto refuse = [&](const std::string& request, const std::string& why) {
    const std::string answer = ask(served.server.port, request);
    EXPECT_EQ(find_status(answer), 403) << request;
    EXPECT_EQ(find_body(answer), "{\"error\":\"" + why + "\"}");
  };
  const std::string no_token = "the address lacks the token; expected the one that 'mien live' printed";
  for (const char* path : {"/", "/x", "/0123456789abcdef0123456789abcdef/", "/../../etc/passwd"})
    refuse(build_get(path, served.host), no_token);
  for (const char* host : {"evil.example", "evil.example:80", ""})
    refuse(build_get(served.path, host), "this server is 127.0.0.1 alone");
  refuse(build_get(served.path, served.host, "Origin: http://evil.example\r\n"),
         "another page asked; expected this server's own");
  refuse(build_post(served.path, served.host, "{}", "application/json", "Origin: null\r\n"),
         "another page asked; expected this server's own");
}

TEST(live_server, a_form_of_another_page_cannot_post) {
  const Served served;
  for (const char* type :
       {"text/plain", "application/x-www-form-urlencoded", "multipart/form-data; boundary=x"})
    EXPECT_EQ(find_status(ask(served.server.port, build_post(served.path, served.host, "{}", type))), 415)
        << type;
}

TEST(live_server, other_methods_are_refused) {
  const Served served;
  for (const char* method : {"PUT", "DELETE", "PATCH"}) {
    const std::string request = std::string(method) + " " + served.path +
                                " HTTP/1.1\r\nHost: " + served.host +
                                "\r\nConnection: close\r\nContent-Length: 0\r\n\r\n";
    EXPECT_EQ(find_status(ask(served.server.port, request)), 405) << method;
  }
}

TEST(live_server, what_breaks_is_told) {
  const Served served;
  const std::string answer = ask(served.server.port, build_get(served.path + "fail", served.host));
  EXPECT_EQ(find_status(answer), 500);
  EXPECT_EQ(find_body(answer), "{\"error\":\"it broke\"}");
}

TEST(live_server, a_gigabyte_is_refused_unread) {
  const Served served;
  const std::size_t before_kb = measure_memory_kb();
  std::string request = build_post(served.path, served.host, "");
  request.replace(request.find("Content-Length: 0"), 17, "Content-Length: 1073741824");
  Connection connection(served.server.port);
  connection.send(request);
  const std::string piece(1 << 20, 'x');
  int sent = 0;
  while (sent < 1024 && connection.send(piece)) ++sent;
  EXPECT_LT(sent, 64);  // what the sockets hold
  EXPECT_LT(measure_memory_kb(), before_kb + (64u << 10));
  expect_serving(served);
}

TEST(live_server, a_body_in_chunks_ends_at_the_same_limit) {
  const Served served;
  Connection connection(served.server.port);
  connection.send("POST " + served.path + " HTTP/1.1\r\nHost: " + served.host +
                  "\r\nContent-Type: application/json\r\nTransfer-Encoding: chunked\r\n\r\n");
  const std::string piece = "10000\r\n" + std::string(0x10000, 'x') + "\r\n";
  int sent = 0;
  while (sent < 4096 && connection.send(piece)) ++sent;
  EXPECT_LT(sent, 1024);
  EXPECT_NE(find_status(connection.receive()), 200);
  expect_serving(served);
}

TEST(live_server, endless_headers_end) {
  const Served served;
  Connection connection(served.server.port);
  connection.send("GET " + served.path + " HTTP/1.1\r\nHost: " + served.host + "\r\n");
  int sent = 0;
  while (sent < 100000 && connection.send("X-Filler: " + std::string(1000, 'y') + "\r\n")) ++sent;
  EXPECT_LT(sent, 50000);
  expect_serving(served);
}

TEST(live_server, garbage_is_no_request) {
  const Served served;
  unsigned state = 1;
  std::vector<Connection> connections;
  for (int round = 0; round < 50; ++round) {
    std::string garbage;
    for (int i = 0; i < 4000; ++i) garbage += static_cast<char>((state = state * 1103515245u + 12345u) >> 16);
    connections.emplace_back(served.server.port);
    connections.back().send(garbage + "\r\n\r\n");
  }
  int wait_ms = 3000;  // of all of them together
  for (Connection& connection : connections)
    EXPECT_NE(find_status(connection.receive(std::exchange(wait_ms, 60))), 200);
  expect_serving(served);
}

TEST(live_server, five_hundred_idle_connections_keep_nobody_out) {
  const Served served;
  expect_serving(served);
  const std::size_t before_kb = measure_memory_kb();
  std::vector<Connection> idle;
  for (int i = 0; i < 500; ++i) {
    idle.emplace_back(served.server.port);
    if (i % 2 == 1) idle.back().send("GET /half of a request");
  }
  const double begun_s = read_clock_s();
  expect_serving(served);
  EXPECT_LT(read_clock_s() - begun_s, 30);
  EXPECT_LT(measure_memory_kb(), before_kb + (100u << 10));
}

TEST(live_server, a_port_that_is_taken_is_told) {
  const Served served;
  try {
    const LiveServer other(served.server.port, repeat);
    FAIL();
  } catch (const RunError& error) {
    EXPECT_EQ(std::string(error.what()),
              "port " + std::to_string(served.server.port) + " is not free on 127.0.0.1");
  }
}

TEST(live_server, nobody_else_on_the_net_reaches_it) {
  const Served served;
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(served.server.port));
  address.sin_addr.s_addr = htonl(0x7F000002);  // 127.0.0.2: this machine too, but not the address it binds
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  EXPECT_NE(::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  ::close(socket);
}

TEST(live_server, ends_with_connections_open) {
  std::vector<Connection> open;
  const double begun_s = read_clock_s();
  {
    const Served served;
    for (int i = 0; i < 20; ++i) open.emplace_back(served.server.port);
    expect_serving(served);
  }
  EXPECT_LT(read_clock_s() - begun_s, 15);
}

}  // namespace
}  // namespace mien

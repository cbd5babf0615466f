// cpp-httplib 0.11: httplib.h. Its own reading of requests is replaced by connections.hpp's.
#include "live/server.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "live/connections.hpp"
#include "live/guard.hpp"

namespace mien {

namespace {

constexpr int kMostRequests = 100;  // of one connection
constexpr int kQueue = 256;         // connections that are not accepted yet

// Scripts, styles and pictures of this page alone; nobody frames it, and nothing leaves it.
constexpr const char* kPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; media-src 'self'; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

void close_on_exec(int socket) {
  ::fcntl(socket, F_SETFD, FD_CLOEXEC);
}  // programs that we start have no use for it

}  // namespace

// Whatever a connection says, the next one is heard.
class LiveListener : public httplib::Server {
 public:
  Crowd crowd;

  // httplib lets five wait; a sixth would be a second late.
  void lengthen_queue() { ::listen(svr_sock_, kQueue); }

 private:
  bool process_and_close_socket(int socket) override {
    close_on_exec(socket);
    ++crowd.count;
    BoundedStream stream(socket, crowd);
    bool is_closed = false;
    for (int left = kMostRequests; left > 0 && !is_closed; --left)
      if (!stream.wait_for_request() || !process_request(stream, left == 1, is_closed, nullptr)) break;
    --crowd.count;
    ::shutdown(socket, SHUT_RDWR);
    ::close(socket);
    return true;
  }
};

namespace {

void give(const LiveAnswer& answer, httplib::Response& response) {
  response.status = answer.status;
  response.set_content(answer.body, answer.type.c_str());
}

}  // namespace

LiveAnswer build_refusal(int status, const std::string& message) {
  return {status, "application/json",
          nlohmann::json{{"error", message}}.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)};
}

struct LiveServer::Parts {
  LiveHandler handler;
  LiveListener listener;
  std::thread thread;
};

namespace {

// Who is refused whatever they ask; nothing if they are heard.
std::optional<LiveAnswer> refuse_stranger(const httplib::Request& request, const LiveServer& server) {
  if (!is_own_host(request.get_header_value("Host"), server.port))
    return build_refusal(403, "this server is 127.0.0.1 alone");
  if (!is_own_origin(request.get_header_value("Origin"), server.port))
    return build_refusal(403, "another page asked; expected this server's own");
  if (!strip_token(request.path, server.token))
    return build_refusal(403, "the address lacks the token; expected the one that 'mien live' printed");
  return std::nullopt;
}

LiveRequest build_request(const httplib::Request& request, const LiveServer& server) {
  LiveRequest asked{request.method == "POST", *strip_token(request.path, server.token), {}, {}};
  for (const auto& [name, value] : request.params) asked.query[name] = value;
  return asked;
}

LiveAnswer answer(const LiveHandler& handler, const LiveRequest& request) {
  try {
    return handler(request);
  } catch (const Interrupted&) {
    return build_refusal(503, "the server is ending");
  } catch (const std::exception& error) {
    return build_refusal(500, error.what());
  }
}

void hear_get(const httplib::Request& request, httplib::Response& response, const LiveServer& server) {
  const auto refusal = refuse_stranger(request, server);
  give(refusal ? *refusal : answer(server.parts->handler, build_request(request, server)), response);
}

void hear_post(const httplib::Request& request, httplib::Response& response,
               const httplib::ContentReader& read, const LiveServer& server) {
  if (const auto refusal = refuse_stranger(request, server)) return give(*refusal, response);
  // A form of another site can send text, but no JSON.
  if (!request.get_header_value("Content-Type").starts_with("application/json"))
    return give(build_refusal(415, "expected JSON"), response);
  LiveRequest asked = build_request(request, server);
  bool is_too_long = false;
  read([&](const char* bytes, std::size_t count) {
    is_too_long |= asked.body.size() + count > kMaxBody_bytes;
    if (!is_too_long) asked.body.append(bytes, count);
    return !is_too_long;
  });
  if (is_too_long || response.status == 413)
    return give(build_refusal(413, fmt::format("larger than {} bytes", kMaxBody_bytes)), response);
  if (response.status >= 400) return;
  give(answer(server.parts->handler, asked), response);
}

void refuse_method(const httplib::Request&, httplib::Response& response, const httplib::ContentReader&) {
  give(build_refusal(405, "expected GET or POST"), response);
}

void prepare(LiveListener& listener, const LiveServer& server) {
  listener.new_task_queue = [] { return new LiveThreads(kMaxThreads); };  // httplib deletes it
  listener.set_payload_max_length(kMaxBody_bytes);
  listener.set_tcp_nodelay(true);
  listener.set_keep_alive_max_count(kMostRequests);  // both are told to browsers
  listener.set_keep_alive_timeout(static_cast<time_t>(kIdle_s));
  listener.set_default_headers({{"Content-Security-Policy", kPolicy},
                                {"X-Content-Type-Options", "nosniff"},
                                {"Referrer-Policy", "no-referrer"},
                                {"Cross-Origin-Resource-Policy", "same-origin"},
                                {"Cross-Origin-Opener-Policy", "same-origin"},
                                {"Cache-Control", "no-store"}});
  // As httplib would, but for SO_REUSEPORT, with which two servers would share a port.
  listener.set_socket_options([](int socket) {
    const int yes = 1;
    ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    close_on_exec(socket);
  });
  listener.Get(".*", [&](const auto& request, auto& response) { hear_get(request, response, server); });
  listener.Post(".*", [&](const auto& request, auto& response, const httplib::ContentReader& read) {
    hear_post(request, response, read, server);
  });
  listener.Put(".*", refuse_method);
  listener.Patch(".*", refuse_method);
  listener.Delete(".*", refuse_method);
}

}  // namespace

LiveServer::LiveServer(int asked_port, LiveHandler handler)
    : token(build_token()), parts(std::make_unique<Parts>()) {
  parts->handler = std::move(handler);
  prepare(parts->listener, *this);
  port = asked_port;
  if (port == 0)
    port = parts->listener.bind_to_any_port("127.0.0.1");
  else if (!parts->listener.bind_to_port("127.0.0.1", port))
    port = -1;
  if (port < 0) throw RunError(fmt::format("port {} is not free on 127.0.0.1", asked_port));
  parts->listener.lengthen_queue();
  address = fmt::format("http://127.0.0.1:{}/{}/", port, token);
  parts->thread = std::thread([this] { parts->listener.listen_after_bind(); });
}

LiveServer::~LiveServer() {
  parts->listener.crowd.is_ending = true;
  while (parts->thread.joinable() && !parts->listener.is_running()) std::this_thread::yield();
  parts->listener.stop();
  parts->thread.join();
}

}  // namespace mien

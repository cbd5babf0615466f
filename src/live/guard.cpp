#include "live/guard.hpp"

#include <fmt/format.h>
#include <sys/random.h>

#include <array>

#include "core/error.hpp"

namespace mien {

std::string build_token() {
  std::array<unsigned char, 16> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw RunError("the system gives no random numbers for the page's address");
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

bool is_own_host(std::string_view host, int port) {
  return host == fmt::format("127.0.0.1:{}", port) || host == fmt::format("localhost:{}", port);
}

bool is_own_origin(std::string_view origin, int port) {
  constexpr std::string_view kScheme = "http://";
  return origin.empty() || (origin.starts_with(kScheme) && is_own_host(origin.substr(kScheme.size()), port));
}

std::optional<std::string> strip_token(std::string_view path, std::string_view token) {
  if (path.empty() || path.front() != '/') return std::nullopt;
  path.remove_prefix(1);
  unsigned difference = path.size() <= token.size() || path[token.size()] != '/' ? 1 : 0;
  for (std::size_t i = 0; i < token.size(); ++i)
    difference |=
        static_cast<unsigned char>(token[i]) ^ static_cast<unsigned char>(i < path.size() ? path[i] : 0);
  if (difference != 0) return std::nullopt;
  return std::string(path.substr(token.size() + 1));
}

}  // namespace mien

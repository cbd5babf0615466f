// Who may ask: a page of another site in the same browser must learn nothing and change nothing.
//
// Source: OWASP, "DNS rebinding" and "Cross-Site Request Forgery Prevention Cheat Sheet".
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mien {

// 32 hexadecimal digits that nobody can guess. Throws RunError if the system gives none.
std::string build_token();

// Whether a request's `Host` is this server: a name that another site made point here is not.
bool is_own_host(std::string_view host, int port);

// Whether `Origin`, where the browser sends one, is this server's own page. "" is none.
bool is_own_origin(std::string_view origin, int port);

// "api/check" of "/TOKEN/api/check"; empty if the token is another. Takes as long for each wrong one.
std::optional<std::string> strip_token(std::string_view path, std::string_view token);

}  // namespace mien

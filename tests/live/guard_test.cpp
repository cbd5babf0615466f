#include "live/guard.hpp"

#include <gtest/gtest.h>

#include <set>

namespace mien {
namespace {

TEST(live_guard, no_two_tokens_are_alike) {
  std::set<std::string> tokens;
  for (int i = 0; i < 100; ++i) {
    const std::string token = build_token();
    EXPECT_EQ(token.size(), 32u);
    EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), token.npos);
    tokens.insert(token);
  }
  EXPECT_EQ(tokens.size(), 100u);
}

TEST(live_guard, a_host_is_this_machine_and_port) {
  EXPECT_TRUE(is_own_host("127.0.0.1:8123", 8123));
  EXPECT_TRUE(is_own_host("localhost:8123", 8123));
  for (const char* host : {"", "127.0.0.1", "127.0.0.1:81", "127.0.0.1:81234", "evil.example:8123",
                           "127.0.0.1.evil.example:8123", "localhost.evil.example:8123", "[::1]:8123"})
    EXPECT_FALSE(is_own_host(host, 8123)) << host;
}

TEST(live_guard, an_origin_is_none_or_this_server) {
  EXPECT_TRUE(is_own_origin("", 8123));
  EXPECT_TRUE(is_own_origin("http://127.0.0.1:8123", 8123));
  for (const char* origin : {"null", "https://127.0.0.1:8123", "http://127.0.0.1:8124", "http://evil.example",
                             "http://127.0.0.1:8123.evil.example", "127.0.0.1:8123"})
    EXPECT_FALSE(is_own_origin(origin, 8123)) << origin;
}

TEST(live_guard, what_stands_behind_the_token_is_the_path) {
  EXPECT_EQ(strip_token("/abc/", "abc"), "");
  EXPECT_EQ(strip_token("/abc/api/check", "abc"), "api/check");
  EXPECT_EQ(strip_token("/abc//abc/", "abc"), "/abc/");
  for (const char* path : {"", "/", "/abc", "abc/", "/abd/x", "/ab/x", "/abcd/x", "//abc/x"})
    EXPECT_EQ(strip_token(path, "abc"), std::nullopt) << path;
}

}  // namespace
}  // namespace mien

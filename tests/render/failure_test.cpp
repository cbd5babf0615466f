#include "render/failure.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mien {
namespace {

using testing::HasSubstr;

TEST(failure, quotes_a_command_for_a_shell) {
  EXPECT_EQ(quote_command({"povray", "+Imy frames/é.pov", "+A0.1", "", "it's"}),
            "povray '+Imy frames/é.pov' +A0.1 '' 'it'\\''s'");
}

TEST(failure, tells_a_failure_with_the_command_and_the_last_lines) {
  EXPECT_EQ(describe_end("povray", 1), "povray failed (exit status 1)");
  EXPECT_EQ(describe_end("povray", 139), "povray was ended by signal 11 (Segmentation fault)");
  EXPECT_EQ(describe_end("ffmpeg", 255), "ffmpeg failed (exit status 255)");
  EXPECT_EQ(format_failure("it failed", "x y", "a\n\n\x1b[31mb\rc\n"),
            "it failed\n  command: x y\n  a\n  [31mb\n  c");
  std::string long_output;
  for (int i = 1; i <= 20; ++i) long_output += std::to_string(i) + "\n";
  EXPECT_THAT(format_failure("it failed", "x", long_output),
              HasSubstr("command: x\n  (8 lines before these left out)\n  9\n  10\n"));
  EXPECT_EQ(
      format_failure("it failed", "x", "1\n2\n3\n4\n5\n6\n7\n8\n9\n10\n11\n12\n13").find("  (1 line before"),
      std::string("it failed\n  command: x\n").size());
}

TEST(failure, tells_the_beginning_of_a_line_without_an_end) {
  std::string line(999, 'x');
  EXPECT_EQ(format_failure("it failed", "x", line + "y"), "it failed\n  command: x\n  " + line + "y");
  EXPECT_EQ(format_failure("it failed", "x", line + "é" + std::string(5000, 'z')),
            "it failed\n  command: x\n  " + line + "... (5002 bytes more left out)")
      << "cut before a letter, not in it";
  EXPECT_EQ(format_failure("it failed", "x", std::string(2000, '\xBF')),
            "it failed\n  command: x\n  ... (2000 bytes more left out)");
}

}  // namespace
}  // namespace mien

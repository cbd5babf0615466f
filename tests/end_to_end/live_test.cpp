// `mien live` as it is started and ended, and in a real browser.
#include <gtest/gtest.h>

#include <regex>

#include "end_to_end/program.hpp"

namespace mien {
namespace {

// Words for a shell: `begin OPTION...` starts the server, $address is its page's; `finish` ends it.
std::string build_words(const std::string& file) {
  return std::string("begin() { '") + program_path() + "' live " + file +
         " \"$@\" >seen.out 2>seen.err & pid=$!; for i in $(seq 300); do [ -s seen.out ] && break; sleep "
         "0.1; done; "
         "address=$(head -n 1 seen.out); }\n"
         "finish() { kill -INT $pid; wait $pid; echo \"status $?\"; }\n";
}

TEST(live, prints_its_address_serves_and_ends_cleanly) {
  const auto folder = make_folder("live");
  write_file(folder / "tiny.yaml", kTinyClip);
  const ProgramRun run =
      run_shell(folder, build_words("tiny.yaml") +
                            "begin\n"
                            "ask() { python3 -c 'import sys, urllib.request as r; "
                            "print(r.urlopen(sys.argv[1]).read().decode()[:15])' \"$1\"; }\n"
                            "ask \"$address\"\n"
                            "finish\n");
  EXPECT_EQ(run.out, "<!doctype html>\nstatus 0\n") << run.err;
  EXPECT_TRUE(std::regex_match(read_file(folder / "seen.out"),
                               std::regex("http://127\\.0\\.0\\.1:[0-9]+/[0-9a-f]{32}/\n")));
  EXPECT_EQ(read_file(folder / "seen.err"), "");
  EXPECT_EQ(list_files(folder), (std::vector<std::string>{"seen.err", "seen.out", "tiny.yaml"}));
}

TEST(live, tells_a_port_that_is_taken) {
  const auto folder = make_folder("live_port");
  write_file(folder / "tiny.yaml", kTinyClip);
  const ProgramRun run = run_shell(folder, build_words("tiny.yaml") +
                                               "begin --json\n"
                                               "port=$(sed 's/.*127.0.0.1:\\([0-9]*\\).*/\\1/' seen.out)\n"
                                               "mien live tiny.yaml --port $port 2>other.err; echo $?\n"
                                               "sed \"s/$port/PORT/\" other.err\n"
                                               "finish\n");
  EXPECT_EQ(run.out, "1\nerror: port PORT is not free on 127.0.0.1\nstatus 0\n") << run.err;
}

TEST(live, opens_a_file_with_mistakes_but_no_other_thing) {
  const auto folder = make_folder("live_wrong");
  write_file(folder / "wrong.yaml", "mien: 1\nhaed: {}\n");
  const ProgramRun run = run_shell(folder, build_words("wrong.yaml") +
                                               "begin; finish\n"
                                               "mien live nobody.yaml; echo $?\n"
                                               "mien live .; echo $?\n");
  EXPECT_EQ(run.out, "status 0\n2\n2\n");
  EXPECT_EQ(run.err.substr(0, run.err.find('\n')),
            "nobody.yaml: error: cannot read: No such file or directory");
}

TEST(live, ports_are_numbers_that_users_have) {
  const auto folder = make_folder("live_ports");
  const ProgramRun run = run_shell(folder, "mien live a.yaml --port 80; mien live a.yaml --port some");
  EXPECT_EQ(run.err,
            "error: --port: '80' is not a whole number within 1024..65535\n"
            "error: --port: 'some' is not a whole number within 1024..65535\n");
}

// tests/live/page.py does what a person would: types, drags, saves, plays.
TEST(live, works_in_a_browser) {
  const auto folder = make_folder("live_page");
  std::filesystem::copy_file(std::filesystem::path(source_folder()) / "configs" / "hello.yaml",
                             folder / "hello.yaml");
  const ProgramRun run = run_shell(folder, "/usr/bin/python3 '" + std::string(source_folder()) +
                                               "/tests/live/page.py' '" + program_path() + "' hello.yaml");
  EXPECT_EQ(run.status, 0) << run.out << run.err;
  EXPECT_EQ(run.out.find("FAILED"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("all of it holds"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace mien

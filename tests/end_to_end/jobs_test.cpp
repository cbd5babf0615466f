// `--jobs` is how many threads the program has, and nothing else of what it does.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "end_to_end/program.hpp"

namespace mien {
namespace {

// How many threads a run of the program had at the most, looked at a hundred times a second.
int count_threads(const std::filesystem::path& folder, const std::string& arguments) {
  const std::string command = fmt::format(
      "rm -f id done\n"
      "( '{}' {} >log & echo $! >id; wait $!; echo $? >done ) &\n"
      "most=0\n"
      "while [ ! -s done ]; do\n"
      "  n=$(ls /proc/$(cat id 2>/dev/null)/task 2>/dev/null | wc -l)\n"
      "  [ \"$n\" -gt \"$most\" ] && most=$n\n"
      "  sleep 0.01\n"
      "done\n"
      "echo $most $(cat done)",
      program_path(), arguments);
  const ProgramRun run = run_shell(folder, command);
  int most = 0, status = -1;
  EXPECT_EQ(std::sscanf(run.out.c_str(), "%d %d", &most, &status), 2) << run.out << run.err;
  EXPECT_EQ(status, 0) << run.err;
  return most;
}

TEST(jobs, are_the_threads_that_the_program_has) {
  const auto folder = make_folder("jobs_threads");
  write_file(folder / "tiny.yaml", kTinyClip);
  EXPECT_EQ(count_threads(folder, "frames tiny.yaml --jobs 1 -o one"), 1);
  const int three = count_threads(folder, "frames tiny.yaml --jobs 3 -o three");
  EXPECT_GT(three, 1);
  EXPECT_LE(three, 3);
}

TEST(jobs, change_no_byte) {
  const auto folder = make_folder("jobs_bytes");
  write_file(folder / "tiny.yaml", kTinyClip);
  ASSERT_EQ(run_shell(folder, "mien frames tiny.yaml --jobs 1 --quiet -o one").status, 0);
  for (const int jobs : {2, 7, 16}) {
    const ProgramRun run = run_shell(
        folder,
        fmt::format("mien frames tiny.yaml --jobs {0} --quiet -o {0} && diff -r -x tiny.ini one {0}", jobs));
    EXPECT_EQ(run.status, 0) << jobs << ": " << run.out.substr(0, 300) << run.err;
  }
}

}  // namespace
}  // namespace mien

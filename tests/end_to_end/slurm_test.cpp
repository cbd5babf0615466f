// A clip on a Slurm of this test's own: a controller and two nodes on this machine.
#include <gtest/gtest.h>

#include "end_to_end/program.hpp"

namespace mien {
namespace {

// tests/farm/real.py kills a task and then a node, and compares the clip with a local run's.
TEST(slurm_cluster, makes_the_clip_of_a_local_run_though_a_task_and_a_node_are_lost) {
  const auto folder = make_folder("slurm_cluster");
  const ProgramRun run = run_shell(folder, "/usr/bin/python3 '" + std::string(source_folder()) +
                                               "/tests/farm/real.py' '" + program_path() + "'");
  if (const std::size_t at = run.out.find("skipped: "); at != run.out.npos)
    GTEST_SKIP() << run.out.substr(at, run.out.find('\n', at) - at);
  EXPECT_EQ(run.status, 0) << run.out << run.err;
  EXPECT_EQ(run.out.find("FAILED"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("all of it holds"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace mien

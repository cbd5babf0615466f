#include "render/slurm.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "render/scratch.hpp"

namespace mien {
namespace {

TEST(slurm, script_of_an_array_says_all_that_sbatch_needs) {
  SlurmScript script;
  script.name = "mien_hello_0123";
  script.folder = "/shared/my \"films\"";
  script.log = "/shared/100%/slurm/%a.log";
  script.tasks = 8;
  script.cores = 2;
  script.partition = "long";
  script.time_limit = "2:00:00";
  script.note = "8 tasks";
  script.command = {"/usr/bin/mien", "render", "it's.yaml", "--part", "{task}/8"};
  EXPECT_EQ(build_slurm_script(script),
            "#!/bin/sh\n"
            "#SBATCH --job-name=mien_hello_0123\n"
            "#SBATCH --array=1-8\n"
            "#SBATCH --ntasks=1\n"
            "#SBATCH --cpus-per-task=2\n"
            "#SBATCH --partition=long\n"
            "#SBATCH --time=2:00:00\n"
            "#SBATCH --chdir=\"/shared/my \\\"films\\\"\"\n"
            "#SBATCH --output=\"/shared/100%%/slurm/%a.log\"\n"
            "#SBATCH --open-mode=append\n"
            "#SBATCH --requeue\n"
            "# 8 tasks\n"
            "exec /usr/bin/mien render 'it'\\''s.yaml' --part \"$SLURM_ARRAY_TASK_ID\"/8\n");
  script.folder = "/two\nlines";
  EXPECT_EQ(find_message<RunError>([&] { build_slurm_script(script); }),
            "'/two\nlines' has a line's end in its name, which sbatch cannot take");
}

TEST(slurm, script_of_one_job_leaves_out_what_is_the_clusters_own) {
  SlurmScript script;
  script.name = "mien";
  script.folder = "/a";
  script.log = "/a/clip.log";
  script.note = "one";
  script.command = {"true"};
  const std::string text = build_slurm_script(script);
  for (const char* option : {"array", "partition", "time"})
    EXPECT_EQ(text.find(std::string("--") + option), std::string::npos) << text;
}

TEST(slurm, arrays_may_be_as_long_as_the_cluster_says) {
  EXPECT_EQ(find_most_tasks("MaxArrayTasks = 7\nMaxArraySize            = 1001\nMaxJobCount = 10000\n"),
            1000u);
  EXPECT_EQ(find_message<RunError>([] { find_most_tasks("MaxArraySize = 0\n"); }),
            "this cluster runs no job arrays: its MaxArraySize is 0");
  EXPECT_EQ(find_message<RunError>([] { find_most_tasks("slurm\n"); }),
            "'scontrol show config' says no MaxArraySize");
}

TEST(slurm, jobs_are_known_by_their_names) {
  const SlurmJobs none = read_slurm_jobs("", "a", "a_clip");
  EXPECT_FALSE(none.is_there());
  EXPECT_TRUE(none.numbers().empty());
  const SlurmJobs jobs = read_slurm_jobs(
      "12|a|PENDING|Resources\n13|a_clip|PENDING|Dependency\n12|a|RUNNING|None\n9|a_other|RUNNING|None\n",
      "a", "a_clip");
  EXPECT_EQ(jobs.numbers(), (std::vector<std::string>{"12", "13"}));
  EXPECT_EQ(jobs.running, 1u);
  EXPECT_EQ(jobs.reason, "Resources");
  const SlurmJobs last = read_slurm_jobs("13|a_clip|COMPLETING|None\n", "a", "a_clip");
  EXPECT_EQ(last.numbers(), std::vector<std::string>{"13"});
  EXPECT_EQ(last.running, 1u);
}

TEST(slurm, is_given_a_script_and_gives_a_number) {
  const Scratch scratch;
  const std::filesystem::path script = scratch.path / "tasks.sh";
  const FakeProgram sbatch("sbatch",
                           "echo 'sbatch: warning: look out' >&2\n"
                           "echo \"$*; $SBATCH_JOB_NAME $SBATCH_PARTITION $SBATCH_TIMELIMIT\" >\"$0.seen\"\n"
                           "echo '17;cluster'\n");
  SlurmScript job;
  job.name = "mien_a";
  job.partition = "long";
  job.time_limit = "30";
  EXPECT_EQ(submit_script(job, script, "12"), "17");
  EXPECT_EQ(read_file(sbatch.folder.path / "sbatch.seen"),
            "--parsable --dependency=afterany:12 " + script.string() + "; mien_a long 30\n");
}

TEST(slurm, tells_what_its_programs_say) {
  const FakeProgram sbatch("sbatch", "echo 'sbatch: error: invalid partition specified: lnog'\nexit 1\n");
  EXPECT_EQ(find_message<RunError>([] { submit_script({}, "/a.sh", ""); }),
            "sbatch failed (exit status 1): sbatch: error: invalid partition specified: lnog");
  const FakeProgram silent("sbatch", "echo 'submitted something'\n");
  EXPECT_EQ(find_message<RunError>([] { submit_script({}, "/a.sh", ""); }),
            "sbatch gave no job's number: submitted something\n");
}

}  // namespace
}  // namespace mien

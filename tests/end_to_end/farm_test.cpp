// `mien render --engine slurm` with programs in Slurm's place: what it submits, when it submits nothing, and
// what it says.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "command_line/arguments.hpp"
#include "command_line/help.hpp"
#include "commands/farm_words.hpp"
#include "end_to_end/program.hpp"
#include "render/scratch.hpp"

namespace mien {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// A cluster that does each thing at once: sbatch runs what it is given, unless HELD is set, and squeue tells
// what the file "jobs" says.
std::string make_cluster(const fs::path& folder) {
  make_program(folder, "sbatch", R"sh(echo "$@" | sed "s|$PWD/||g" >>calls
number=$(($(cat count 2>/dev/null || echo 11) + 1)); echo $number >count
for script; do :; done
tasks=$(sed -n 's/^#SBATCH --array=1-//p' "$script")
log=$(sed -n 's/^#SBATCH --output="\(.*\)"/\1/p' "$script")
if [ -n "$HELD" ]; then :
elif [ -n "$tasks" ]; then
  for i in $(seq "$tasks"); do
    [ "$i" = "$LOST" ] || SLURM_ARRAY_TASK_ID=$i sh "$script" >"${log%\%a.log}$i.log" 2>&1
  done
else
  sh "$script" >"$log" 2>&1
fi
echo $number
)sh");
  make_program(folder, "squeue", "cat jobs 2>/dev/null || true\n");
  make_program(folder, "scancel", "echo \"scancel $*\" >>calls\nrm jobs\n");
  return make_program(folder, "scontrol", "echo \"MaxArraySize = ${MOST:-1001}\"\n");
}

// A povray that draws the same picture of 48x60 each time, at once.
void make_quick_povray(const fs::path& folder) {
  write_file(folder / "bin/picture.png", build_picture(48, 60));
  make_program(folder, "povray",
               "for word; do case $word in +O*) cp \"${0%/*}/picture.png\" \"${word#+O}\" ;; esac; done\n");
}

// In a folder of its own with tiny.yaml, of three drawings.
struct Farm {
  explicit Farm(const std::string& name) : folder(make_folder("farm_" + name)), path(make_cluster(folder)) {
    write_file(folder / "tiny.yaml", kTinyClip);
  }
  ProgramRun run(const std::string& options, const std::string& variables = "") const {
    return run_shell(folder, variables + " " + path + "'" + program_path() + "' render tiny.yaml " + options);
  }
  std::string calls() const { return fs::exists(folder / "calls") ? read_file(folder / "calls") : ""; }
  fs::path folder;
  std::string path;
};

// `text` without what differs from one machine to the next.
std::string replace_all(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

TEST(farm, dry_run_prints_the_scripts_and_does_nothing) {
  const Farm farm("dry");
  const ProgramRun run =
      farm.run("--engine slurm --dry-run --chunk 2 --partition long --time 90m --quality good");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  std::string text = replace_all(run.out, program_path(), "MIEN");
  text = replace_all(text, fs::canonical(farm.folder).string(), "HERE");
  const std::size_t name = text.find("mien_tiny_");
  ASSERT_NE(name, text.npos) << text;
  text = replace_all(text, text.substr(name, 18), "NAME");
  const std::string common =
      "#SBATCH --ntasks=1\n#SBATCH --cpus-per-task=1\n#SBATCH --partition=long\n#SBATCH --time=1:30:00\n"
      "#SBATCH --chdir=\"HERE\"\n#SBATCH --output=\"HERE/out/tiny/slurm/";
  const std::string more = ".log\"\n#SBATCH --open-mode=append\n#SBATCH --requeue\n";
  EXPECT_EQ(text,
            "# out/tiny/slurm/tasks.sh\n#!/bin/sh\n#SBATCH --job-name=NAME\n#SBATCH --array=1-2\n" + common +
                "%a" + more +
                "# 2 tasks of 1 to 2 drawings: each traces its part of plan.json\n"
                "exec MIEN render tiny.yaml --quality=good --jobs=1 --part \"$SLURM_ARRAY_TASK_ID\"/2\n\n"
                "# out/tiny/slurm/clip.sh\n#!/bin/sh\n#SBATCH --job-name=NAME_clip\n" +
                common + "clip" + more +
                "# when all tasks have ended: looks whether every drawing is there, and makes the clip\n"
                "exec MIEN render tiny.yaml --quality=good --jobs=1 --part gather\n\n"
                "# sbatch --parsable out/tiny/slurm/tasks.sh\n"
                "# sbatch --parsable --dependency=afterany:JOB out/tiny/slurm/clip.sh\n");
  EXPECT_EQ(farm.calls(), "");
  EXPECT_FALSE(fs::exists(farm.folder / "out"));
}

TEST(farm, makes_what_a_local_run_makes) {
  const Farm farm("same");
  const ProgramRun run = farm.run("--engine slurm --chunk 1");
  ASSERT_EQ(run.status, 0) << run.err << run.out;
  EXPECT_EQ(
      farm.calls(),
      "--parsable out/tiny/slurm/tasks.sh\n--parsable --dependency=afterany:12 out/tiny/slurm/clip.sh\n");
  EXPECT_THAT(run.err, HasSubstr("3 frames, 3 drawings, 3 to trace\n"));
  EXPECT_THAT(run.err,
              HasSubstr("submitted job 12, 3 tasks of 1 drawing, and job 13, which makes the clip; logs in "
                        "out/tiny/slurm\n"));
  EXPECT_THAT(run.err, HasSubstr("frames: 3 done"));
  EXPECT_EQ(run.out, "clip    out/tiny/tiny.mp4\nposter  out/tiny/poster.png\n");
  EXPECT_THAT(read_file(farm.folder / "out/tiny/slurm/clip.log"), HasSubstr("0 to trace"));
  ASSERT_EQ(farm.run("-o local").status, 0);
  for (const std::string& file : list_files(farm.folder / "local"))
    EXPECT_EQ(read_file(farm.folder / "local" / file), read_file(farm.folder / "out/tiny" / file)) << file;

  fs::remove(farm.folder / "calls");
  const ProgramRun again = farm.run("--engine slurm --chunk 1");
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_THAT(again.err, HasSubstr("3 frames, 3 drawings, 0 to trace\n"));
  EXPECT_EQ(farm.calls(), "--parsable out/tiny/slurm/clip.sh\n") << "all is there: no array";
  EXPECT_EQ(run_shell(farm.folder, "mien clean tiny.yaml").status, 0);
  EXPECT_EQ(list_files(farm.folder / "out/tiny"),
            (std::vector<std::string>{"manifest.json", "poster.png", "tiny.mp4"}));
}

TEST(farm, keeps_designs_side_by_side) {
  const Farm farm("beside");
  const std::string beside = "--frames 2-2 --beside real,comic";
  const ProgramRun run = farm.run("--engine slurm --chunk 1 " + beside);
  ASSERT_EQ(run.status, 0) << run.err << run.out;
  EXPECT_THAT(run.err, HasSubstr("2 tasks of 1 drawing"));
  ASSERT_EQ(farm.run("-o local " + beside).status, 0);
  EXPECT_EQ(read_file(farm.folder / "local/tiny_2-2.mp4"), read_file(farm.folder / "out/tiny/tiny_2-2.mp4"));
}

TEST(farm, has_no_more_tasks_than_an_array_may) {
  const Farm farm("most");
  const ProgramRun run = farm.run("--engine slurm --chunk 1 --dry-run", "MOST=3");
  EXPECT_THAT(run.out, HasSubstr("#SBATCH --array=1-2\n"));
  EXPECT_EQ(farm.run("--engine slurm", "MOST=0").err,
            "error: this cluster runs no job arrays: its MaxArraySize is 0\n");
}

TEST(farm, gives_a_task_as_many_drawings_as_fit_its_time) {
  const Farm farm("chunk");
  EXPECT_THAT(farm.run("--engine slurm --dry-run").out, HasSubstr("# 1 task of 3 drawings"))
      << "five minutes";
  EXPECT_THAT(farm.run("--engine slurm --dry-run --chunk 1s").out, HasSubstr("# 3 tasks of 1 drawing:"));
  make_quick_povray(farm.folder);
  ASSERT_EQ(farm.run("--engine slurm --frames 1-1").status, 0);
  const std::string measured = read_file(farm.folder / "out/tiny/slurm/cost.json");
  write_file(farm.folder / "out/tiny/slurm/cost.json",
             measured.substr(0, measured.find("\"seconds\":")) + "\"seconds\":40}\n");
  EXPECT_THAT(farm.run("--engine slurm --dry-run --chunk 79s").out, HasSubstr("# 2 tasks of 1 drawing:"));
  EXPECT_THAT(farm.run("--engine slurm --dry-run --chunk 80s").out, HasSubstr("# 1 task of 2 drawings"));
  EXPECT_THAT(farm.run("--engine slurm --dry-run --chunk 40s --jobs 2").out,
              HasSubstr("# 1 task of 2 drawings"));
}

TEST(farm, hands_every_option_of_render_on_to_its_jobs) {
  const std::set<std::string_view> own{"engine",  "partition", "chunk", "time", "no-wait",
                                       "dry-run", "part",      "quiet", "json", "help"};
  const std::map<std::string_view, std::string> given{
      {"output", "there"}, {"frames", "1-2"}, {"size", "32x40"},   {"quality", "best"},
      {"jobs", "3"},       {"store", "5"},    {"keep-scenes", ""}, {"beside", "real,comic"},
      {"loop", "3"},       {"nice", "5"},     {"boomerang", ""},   {"slate", ""}};
  for (const OptionInfo* option : list_options(*find_command("render"))) {
    if (own.contains(option->name)) continue;
    ASSERT_TRUE(given.contains(option->name)) << option->name << " is no option that a task is given";
    const std::string& value = given.at(option->name);
    const std::string word = fmt::format("--{}{}{}", option->name, value.empty() ? "" : "=", value);
    const std::vector<const char*> argv{"mien", "render", "a.yaml", word.c_str()};
    const FarmWords words =
        list_farm_words(read_arguments(static_cast<int>(argv.size()), argv.data()).options);
    EXPECT_THAT(words.clip, testing::Contains(word));
    EXPECT_THAT(words.asked, HasSubstr(word));
    constexpr auto kOfClip =
        std::to_array<std::string_view>({"store", "keep-scenes", "loop", "boomerang", "slate"});
    const bool is_for_all = std::ranges::find(kOfClip, option->name) == kOfClip.end();
    EXPECT_EQ(std::ranges::count(words.tasks, word), is_for_all ? 1 : 0) << word;
  }
}

TEST(farm, makes_the_clip_though_a_task_was_lost) {
  const Farm farm("lost");
  make_quick_povray(farm.folder);
  const ProgramRun run = farm.run("--engine slurm --chunk 2", "LOST=2");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(read_file(farm.folder / "out/tiny/slurm/clip.log"), HasSubstr("1 to trace"));
}

TEST(farm, tells_what_is_missing_and_goes_on_from_there) {
  const Farm farm("missing");
  make_program(farm.folder, "povray", "echo 'Parse Error: no luck' >&2\nexit 1\n");
  const ProgramRun run = farm.run("--engine slurm --chunk 1");
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(
      run.err,
      HasSubstr("error: jobs 12 and 13 ended without the clip; 3 of 3 drawings are missing; run again to "
                "go on\n  out/tiny/slurm/clip.log ends with:\n"));
  EXPECT_THAT(
      run.err,
      HasSubstr("  error: 3 of 3 drawings are missing: frames 1, 2, 3; why is in the logs of the tasks, "
                "out/tiny/slurm/*.log; run again to go on\n"));
  EXPECT_THAT(read_file(farm.folder / "out/tiny/slurm/1.log"), HasSubstr("Parse Error: no luck"));
  EXPECT_EQ(run.out, "");
  make_quick_povray(farm.folder);
  const ProgramRun again = farm.run("--engine slurm --chunk 1");
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_TRUE(fs::exists(farm.folder / "out/tiny/tiny.mp4"));
}

TEST(farm, finds_jobs_of_an_earlier_call_and_doubles_none) {
  const Farm farm("found");
  const ProgramRun left = farm.run("--engine slurm --chunk 1 --no-wait", "HELD=1");
  EXPECT_EQ(left.status, 0) << left.err;
  EXPECT_THAT(left.err,
              HasSubstr("look with: squeue -j 12,13; cancel with: scancel 12 13; wait for the clip with the "
                        "same command\n"));
  const std::string script = read_file(farm.folder / "out/tiny/slurm/tasks.sh");
  const std::size_t at = script.find("mien_tiny_");
  const std::string name = script.substr(at, script.find('\n', at) - at);
  const std::string jobs = "12|" + name + "|PENDING|Resources\n13|" + name + "_clip|PENDING|Dependency\n";
  write_file(farm.folder / "jobs", jobs);
  fs::remove(farm.folder / "calls");

  const ProgramRun same = farm.run("--engine slurm --chunk 1 --no-wait");
  EXPECT_THAT(same.err, HasSubstr("going on with jobs 12 and 13 of an earlier call\n"));
  EXPECT_EQ(farm.calls(), "");

  write_file(farm.folder / "jobs", "12|" + name + "|RUNNING|None\n");
  farm.run("--engine slurm --chunk 1 --no-wait", "HELD=1");
  EXPECT_EQ(farm.calls(), "--parsable --dependency=afterany:12 out/tiny/slurm/clip.sh\n")
      << "whoever was stopped between the two submits the second";

  write_file(farm.folder / "jobs", jobs);
  fs::remove(farm.folder / "calls");
  const ProgramRun other = farm.run("--engine slurm --chunk 3 --no-wait", "HELD=1");
  EXPECT_THAT(other.err,
              HasSubstr("cancelled jobs 12 and 13 of an earlier call, which asked for something else\n"));
  EXPECT_EQ(farm.calls(),
            "scancel 12 13\n--parsable out/tiny/slurm/tasks.sh\n"
            "--parsable --dependency=afterany:15 out/tiny/slurm/clip.sh\n");
}

TEST(farm, leaves_jobs_to_themselves_when_it_is_interrupted) {
  const Farm farm("interrupted");
  farm.run("--engine slurm --no-wait", "HELD=1");
  const std::string script = read_file(farm.folder / "out/tiny/slurm/tasks.sh");
  const std::size_t at = script.find("mien_tiny_");
  write_file(farm.folder / "jobs",
             "12|" + script.substr(at, script.find('\n', at) - at) + "|PENDING|Priority\n");
  const ProgramRun run =
      run_shell(farm.folder, farm.path + "HELD=1 '" + program_path() +
                                 "' render tiny.yaml --engine slurm 2>seen & id=$!\n"
                                 "until grep -q waiting seen; do sleep 0.1; done\nkill -INT $id; wait $id");
  EXPECT_EQ(run.status, 130);
  const std::string seen = read_file(farm.folder / "seen");
  EXPECT_THAT(seen, HasSubstr("waiting for the cluster: Priority\n"));
  EXPECT_THAT(
      seen,
      HasSubstr("error: interrupted; the jobs go on; look with: squeue -j 12,14; cancel with: scancel 12 14; "
                "wait for the clip with the same command\n"));
  EXPECT_EQ(farm.calls().find("scancel"), std::string::npos);
}

TEST(farm, task_traces_nothing_of_a_file_that_has_changed) {
  const Farm farm("changed");
  farm.run("--engine slurm --chunk 2 --no-wait", "HELD=1");
  std::string changed = kTinyClip;
  write_file(farm.folder / "tiny.yaml", changed.replace(changed.find("smile"), 5, "anger"));
  const ProgramRun run = farm.run("--part 1/2");
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, testing::ContainsRegex(
                           "error: frame [123] of out/tiny is another drawing than when the jobs were "
                           "submitted: the file, or what it reads, has changed since; submit again\n"));
  EXPECT_FALSE(fs::exists(farm.folder / "out/tiny/store"));
  EXPECT_EQ(farm.run("--part 1/3").err,
            "error: out/tiny/slurm/plan.json has 2 parts; expected 3, as --part 1/3 says; submit again\n");
  EXPECT_EQ(farm.run("--part 1/3 -o there").err,
            "error: cannot read there/slurm/plan.json: No such file or directory\n");
}

TEST(farm, says_what_it_lacks_in_one_line) {
  const Farm farm("lacks");
  const auto run_bare = [&](const std::string& options) {
    return run_shell(farm.folder,
                     "PATH=/nowhere '" + std::string(program_path()) + "' render tiny.yaml " + options);
  };
  const ProgramRun bare = run_bare("--engine slurm");
  EXPECT_EQ(bare.status, 1);
  EXPECT_EQ(bare.err, "error: sbatch is not installed; install it with: apt-get install slurm-client\n");
  EXPECT_EQ(run_bare("--engine slurm --dry-run").status, 0) << "scripts for another machine";
  make_program(farm.folder, "sbatch",
               "echo 'sbatch: error: invalid partition specified: lnog' >&2; exit 1\n");
  const ProgramRun wrong = farm.run("--engine slurm --partition lnog");
  EXPECT_EQ(wrong.status, 1);
  EXPECT_THAT(wrong.err,
              HasSubstr("error: sbatch failed (exit status 1): sbatch: error: invalid partition specified: "
                        "lnog\n"));
  const ProgramRun sketch = farm.run("--engine slurm --quality sketch");
  EXPECT_EQ(sketch.status, 2);
  EXPECT_EQ(sketch.err,
            "error: --engine slurm is for pictures of POV-Ray; the quality is sketch, expected draft, good "
            "or best\n");
}

}  // namespace
}  // namespace mien

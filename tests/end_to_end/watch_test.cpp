// `mien watch` beside an editor: what it does at each save, and how it ends.
#include <gtest/gtest.h>

#include "end_to_end/program.hpp"

namespace mien {
namespace {

// Words for a shell: `begin` starts the watch, `await N` waits until it has come to rest N times, `finish`
// ends it.
std::string build_words(const std::string& file) {
  return std::string("begin() { '") + program_path() + "' watch " + file +
         " --jobs 2 >seen.out 2>seen.err & pid=$!; await 1; }\n"
         "await() { for i in $(seq 900); do [ \"$(grep -c '^watching' seen.err)\" -ge $1 ] && return; sleep "
         "0.1; "
         "done; echo \"waited for $1 in vain\"; }\n"
         "finish() { kill -INT $pid; wait $pid; echo \"status $?\"; }\n";
}

TEST(watch, sketches_what_changed_at_each_save) {
  const auto folder = make_folder("watch");
  write_file(folder / "tiny.yaml", kTinyClip);
  const ProgramRun run =
      run_shell(folder, build_words("tiny.yaml") +
                            "begin\n"
                            "cp out/tiny/tiny_sketch.mp4 first.mp4\n"
                            "sed 's/^title: Tiny/title: Tinier/' tiny.yaml >new.yaml\n"
                            "mv new.yaml tiny.yaml; await 2\n"  // as editors replace a file
                            "cmp out/tiny/tiny_sketch.mp4 first.mp4\n"
                            "sed -i 's/express: smile/express: anger/' tiny.yaml; await 3\n"
                            "cmp -s out/tiny/tiny_sketch.mp4 first.mp4 && echo same\n"
                            "finish\n");
  EXPECT_EQ(run.out, "status 0\n");
  const std::string heard = read_file(folder / "seen.err");
  EXPECT_NE(heard.find("0 done, 3 kept"), std::string::npos) << heard;
  EXPECT_NE(heard.find("2 done, 1 kept"), std::string::npos) << heard;
  EXPECT_EQ(list_files(folder / "out"),
            (std::vector<std::string>{"tiny/manifest_sketch.json", "tiny/tiny_sketch.mp4"}));
}

TEST(watch, tells_mistakes_and_keeps_the_last_good_clip) {
  const auto folder = make_folder("watch_mistakes");
  write_file(folder / "tiny.yaml", kTinyClip);
  const ProgramRun run =
      run_shell(folder, build_words("tiny.yaml") +
                            "begin\n"
                            "cp out/tiny/tiny_sketch.mp4 first.mp4; cp tiny.yaml good.yaml\n"
                            "echo 'haed: {}' >>tiny.yaml; await 2\n"
                            "cmp out/tiny/tiny_sketch.mp4 first.mp4\n"
                            "rm tiny.yaml; await 3\n"
                            "cp good.yaml tiny.yaml; await 4\n"
                            "finish\n");
  EXPECT_EQ(run.out, "status 0\n");
  const std::string heard = read_file(folder / "seen.err");
  EXPECT_NE(heard.find("error: unknown key 'haed'; did you mean 'head'?"), std::string::npos) << heard;
  EXPECT_NE(heard.find("0 done, 3 kept"), std::string::npos) << heard;
}

TEST(watch, follows_included_files) {
  const auto folder = make_folder("watch_included");
  write_file(folder / "faces.yaml", "mien: 1\nclip:\n  turn: [{at: 0s, turn: 5deg}]\n");
  std::string clip = kTinyClip;
  clip.replace(clip.find("clip:"), 5, "clip:\n  include: faces.yaml");
  write_file(folder / "tiny.yaml", clip);
  const ProgramRun run = run_shell(folder, build_words("tiny.yaml") +
                                               "begin\n"
                                               "sed -i 's/5deg/9deg/' faces.yaml; await 2\n"
                                               "finish\n");
  EXPECT_EQ(run.out, "status 0\n") << read_file(folder / "seen.err");
}

TEST(watch, begins_with_a_file) {
  const auto folder = make_folder("watch_none");
  const ProgramRun run = run_shell(folder, "mien watch nobody.yaml");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err, "nobody.yaml: error: cannot read: No such file or directory\n");
}

}  // namespace
}  // namespace mien

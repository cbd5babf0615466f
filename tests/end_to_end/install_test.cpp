// What `cmake --install` puts where, and that it runs from there. (The folders are those of GNUInstallDirs'
// defaults.)
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "end_to_end/program.hpp"

namespace mien {
namespace {

using testing::HasSubstr;

// The build installed below an empty folder.
std::filesystem::path install_build(const std::string& name) {
  const std::filesystem::path folder = make_folder(name);
  const std::string build = std::filesystem::path(program_path()).parent_path().string();
  const ProgramRun run = run_shell(folder, fmt::format("cmake --install '{}' --prefix usr", build));
  EXPECT_EQ(run.status, 0) << run.err;
  return folder;
}

TEST(install, puts_everything_where_it_belongs) {
  const std::filesystem::path folder = install_build("install_places");
  for (const char* file : {"bin/mien", "share/man/man1/mien.1", "share/bash-completion/completions/mien",
                           "share/zsh/site-functions/_mien", "share/fish/vendor_completions.d/mien.fish",
                           "share/doc/mien/README.md", "share/doc/mien/LICENSE", "share/doc/mien/NOTICE",
                           "share/doc/mien/docs/install.md", "share/doc/mien/docs/hello.webp",
                           "share/mien/templates/head/heads.yaml", "share/mien/templates/mien.schema.json",
                           "share/mien/configs/hello.yaml"})
    EXPECT_TRUE(std::filesystem::is_regular_file(folder / "usr" / file)) << file;
  for (const char* data : {"templates", "configs"})
    EXPECT_EQ(list_files(folder / "usr/share/mien" / data),
              list_files(std::filesystem::path(source_folder()) / data));
  EXPECT_THAT(read_file(folder / "usr/share/bash-completion/completions/mien"), HasSubstr("list:0) "));
  for (const char* kind : {"landmarks", "exposure"})
    EXPECT_THAT(read_file(folder / "usr/share/bash-completion/completions/mien"), HasSubstr(kind));
}

TEST(install, runs_from_there_with_its_own_data) {
  const std::filesystem::path folder = install_build("install_runs");
  write_file(folder / "usr/share/mien/templates/new.yaml", "# the installed one of {{name}}\n");
  ASSERT_EQ(run_shell(folder, "usr/bin/mien new otto").status, 0);
  EXPECT_EQ(read_file(folder / "otto.yaml"), "# the installed one of otto\n");
  std::filesystem::rename(folder / "usr", folder / "moved");
  ASSERT_EQ(run_shell(folder, "moved/bin/mien new anna").status, 0);
  EXPECT_EQ(read_file(folder / "anna.yaml"), "# the installed one of anna\n");
  EXPECT_EQ(run_shell(folder, "moved/bin/mien list ages").out, run_shell(folder, "mien list ages").out);
  EXPECT_EQ(run_shell(folder, "moved/bin/mien check moved/share/mien/configs/hello.yaml").status, 0);
}

}  // namespace
}  // namespace mien

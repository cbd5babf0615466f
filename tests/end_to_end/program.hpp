// Running the built program as a person would: in a folder of its own, through a shell.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "core/text.hpp"
#include "places.hpp"

namespace mien {

struct ProgramRun {
  int status = 0;  // exit status; 128 + n if signal n ended it
  std::string out, err;
};

// An empty folder for one test.
inline std::filesystem::path make_folder(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "mien_end_to_end" / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

// `command` in `folder`; "mien" in it is the program that was built. What it prints is kept outside `folder`.
inline ProgramRun run_shell(const std::filesystem::path& folder, const std::string& command) {
  const std::string log = folder.string() + ".log";
  const std::string line = "cd '" + folder.string() + "' && mien() { '" + program_path() +
                           "' \"$@\"; } && { " + command + "\n} >'" + log + ".out' 2>'" + log +
                           ".err' </dev/null";
  const int ended = std::system(line.c_str());
  return {WIFSIGNALED(ended) ? 128 + WTERMSIG(ended) : WEXITSTATUS(ended), read_file(log + ".out"),
          read_file(log + ".err")};
}

// A program `name` in folder/bin that does what `script` says; PATH for a command that shall find it first.
inline std::string make_program(const std::filesystem::path& folder, const std::string& name,
                                const std::string& script) {
  write_file(folder / "bin" / name, "#!/bin/sh\n" + script);
  std::filesystem::permissions(folder / "bin" / name, std::filesystem::perms::owner_all);
  return "PATH='" + (folder / "bin").string() + "':\"$PATH\" ";
}

// The files below a folder, from it, by name.
inline std::vector<std::string> list_files(const std::filesystem::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files.push_back(std::filesystem::relative(entry.path(), folder).generic_string());
  std::sort(files.begin(), files.end());
  return files;
}

// A clip of three frames that takes a few seconds: neutral to smile, with two drawings in between.
inline constexpr const char* kTinyClip = R"(mien: 1
title: Tiny
clip:
  fps: 24
  keys:
    - {at: 0s, express: neutral}
    - {at: 0.125s, express: smile}
render: {size: 48x60, quality: draft}
)";

}  // namespace mien

// A hidden folder for half-made files, beside the place where the finished ones go.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

namespace mien {

// Made inside `parent` (which is made too), locked while we live, removed with all it holds when this object
// goes. Folders that a killed run left in `parent` are removed first. Throws RunError "cannot write in
// PARENT: reason".
struct WorkFolder {
  explicit WorkFolder(const std::filesystem::path& parent);
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  std::filesystem::path path;  // absolute: PARENT/.mien-work-XXXXXX
  int lock = -1;
};

// Removes the work folders that killed runs left in `folder`.
void remove_left_folders(const std::filesystem::path& folder);

// Removes the half-made files "NAME.PID.part" (write_file) that killed runs left in `folder`: those whose
// NAME `is_ours` says is one that we write there. What somebody is writing stays, and on a disk without
// locks, where nobody can tell, all does.
void remove_left_parts(const std::filesystem::path& folder,
                       const std::function<bool(const std::string& name)>& is_ours);

// The same of the one file that a command is to write, beside it.
void remove_left_parts_of(const std::filesystem::path& file);

// Throws RunError "cannot write TARGET: No space left on device" if `byte_count` bytes cannot be written in
// `folder` (a full disk, a quota, a limit of the shell). Asked after a program failed, since few say clearly
// why they did.
void require_space(const std::filesystem::path& folder, std::size_t byte_count,
                   const std::filesystem::path& target);

}  // namespace mien

// A hidden folder for half-made files, beside the place where the finished ones go.
#pragma once

#include <cstddef>
#include <filesystem>

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

// Throws RunError "cannot write TARGET: No space left on device" if `byte_count` bytes cannot be written in
// `folder` (a full disk, a quota, a limit of the shell). Asked after a program failed, since few say clearly
// why they did.
void require_space(const std::filesystem::path& folder, std::size_t byte_count,
                   const std::filesystem::path& target);

}  // namespace mien

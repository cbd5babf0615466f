// Before a command writes: the folder is its own, and without what dead runs left.
#pragma once

#include <filesystem>

#include "options.hpp"
#include "render/folder_lock.hpp"

namespace mien {

// The lock of a folder that the command is to fill, with everything gone from it that killed runs left
// half-made there, in its scenes/ and in its frames/. Throws RunError as FolderLock does. Where the disk has
// no locks a note on standard error says so, and all stays.
FolderLock hold_folder(const Options& options, const std::filesystem::path& folder);

}  // namespace mien

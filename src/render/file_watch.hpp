// Waiting for files to be saved. Linux: inotify(7).
#pragma once

#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace mien {

// Files that are watched through their folders, so that those which an editor replaces, and those that are
// not there yet, are seen too. Only moved.
struct FileWatch {
  FileWatch();
  FileWatch(FileWatch&& other) noexcept;
  FileWatch& operator=(FileWatch&& other) noexcept;
  ~FileWatch();

  int events = -1;
  std::map<int, std::set<std::string>> names;  // of each watched folder
};

// From now on these files are watched, and no others: also where their links lead. Folders that are not there
// are left out. Throws RunError "cannot watch FOLDER: reason".
void set_watched_files(FileWatch& watch, const std::vector<std::filesystem::path>& files);

// Sleeps until one of the files has been written, replaced or removed, and then until nothing more has
// happened for a moment: an editor may do several things for one save. False if none has been for `most_s`
// seconds. Throws Interrupted on a signal.
bool wait_for_save(FileWatch& watch, double most_s = std::numeric_limits<double>::infinity());

}  // namespace mien

// One writer a folder: who writes into it holds its lock.
#pragma once

#include <filesystem>

namespace mien {

// Held from its making to its end, and gone with the process however that ends. While it is held the folder,
// which is made too, has a file ".mien.lock" that tells who holds it. Throws RunError "FOLDER is being
// written by another run (process 12: mien render a.yaml); wait for its end or write elsewhere with -o",
// having written nothing, and "cannot write in FOLDER: reason". Only moved.
struct FolderLock {
  explicit FolderLock(const std::filesystem::path& folder);
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&& other) noexcept;
  ~FolderLock();

  // False where the disk has no locks (some network disks): then nobody is kept out, and nobody told apart
  // from the dead.
  bool is_held() const { return file >= 0; }

  std::filesystem::path path;  // of the lock's file
  int file = -1;
};

}  // namespace mien

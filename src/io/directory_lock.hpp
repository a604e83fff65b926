#pragma once

#include <filesystem>

namespace breccia {

/// Prevents other processes of Breccia from writing to a results directory during the lifetime of this object. The
/// operating system releases the lock when the process ends in any way. A process cannot lock a directory twice. On a
/// file system without locks it has no effect.
class DirectoryLock {
 public:
  /// Creates the directory if it is missing. Throws DirectoryInUse when another lock holds it, FileError when it cannot
  /// be created or opened.
  explicit DirectoryLock(std::filesystem::path directory);
  DirectoryLock(const DirectoryLock&) = delete;
  DirectoryLock& operator=(const DirectoryLock&) = delete;
  DirectoryLock(DirectoryLock&&) = delete;
  DirectoryLock& operator=(DirectoryLock&&) = delete;
  /// Removes the directory if it is empty.
  ~DirectoryLock();

 private:
  std::filesystem::path directory_;
  int descriptor_ = -1;
};

}  // namespace breccia

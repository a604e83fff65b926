#pragma once

#include <filesystem>

namespace breccia {

/// Keeps other processes from writing to a directory of results, for as long as it lives. The system gives the
/// directory free when the process ends, however it ends.
class DirectoryLock {
 public:
  /// The directory is made where it is missing. Throws InputError where another process holds it, FileError where it
  /// cannot be made.
  explicit DirectoryLock(const std::filesystem::path& directory);
  DirectoryLock(const DirectoryLock&) = delete;
  DirectoryLock& operator=(const DirectoryLock&) = delete;
  DirectoryLock(DirectoryLock&&) = delete;
  DirectoryLock& operator=(DirectoryLock&&) = delete;
  /// Removes the directory if it is empty.
  ~DirectoryLock();

 private:
  std::filesystem::path directory_;
  int descriptor_;
};

}  // namespace breccia

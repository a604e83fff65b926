#pragma once

#include <filesystem>

#include "breccia/error.hpp"

namespace breccia {

/// Another process writes to a directory that is to be written to.
class DirectoryInUse : public InputError {
 public:
  using InputError::InputError;
};

/// Keeps other processes of Breccia from writing to a directory of results, for as long as it lives. The system gives
/// the directory free when the process ends, however it ends. A process cannot lock a directory twice. On a file system
/// without locks it keeps nobody away.
class DirectoryLock {
 public:
  /// The directory is made where it is missing. Throws DirectoryInUse where another lock holds it, FileError where it
  /// cannot be made or opened.
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

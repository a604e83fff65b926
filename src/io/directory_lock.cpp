#include "io/directory_lock.hpp"

#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "breccia/error.hpp"

#include "io/empty_directory.hpp"
#include "io/text_file.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& directory, int reason) {
  if (reason == EWOULDBLOCK) {
    throw DirectoryInUse(
        fmt::format("{}: another process of Breccia writes its results here; wait for its end", directory.string()));
  }
  throw FileError(
      fmt::format("{}: cannot lock this directory: {}", directory.string(), std::generic_category().message(reason)));
}

/// Whether this error number means that the file system has no locks. NFS locks only files that are open for writing
/// (EBADF), which a directory cannot be.
bool has_no_locks(int reason) {
  return reason == ENOSYS || reason == ENOTSUP || reason == ENOLCK || reason == EBADF;
}

/// Whether an open descriptor is still the file at its path. Another process may have removed the file meanwhile.
bool is_still_at(int descriptor, const fs::path& directory) {
  struct stat opened = {}, found = {};
  return ::fstat(descriptor, &opened) == 0 && ::stat(directory.c_str(), &found) == 0 && opened.st_dev == found.st_dev &&
         opened.st_ino == found.st_ino;
}

/// Opens and locks the directory. Returns its descriptor, or -1 if the directory was removed meanwhile.
int locked(const fs::path& directory) {
  constexpr int flags = O_RDONLY | O_DIRECTORY | O_CLOEXEC;
  const int descriptor = ::open(directory.c_str(), flags);  // NOLINT(cppcoreguidelines-pro-type-vararg)
  if (descriptor < 0 && errno == ENOENT) return -1;
  if (descriptor < 0) refuse(directory, errno);
  const int reason = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
  if (reason != 0 && !has_no_locks(reason)) {
    ::close(descriptor);
    refuse(directory, reason);
  }
  if (is_still_at(descriptor, directory)) return descriptor;
  ::close(descriptor);
  return -1;
}

/// Creates the directory if it is missing. False if another process has removed it meanwhile.
bool is_made(const fs::path& directory) {
  std::error_code error, ignored;
  fs::create_directories(directory, error);
  if (error == std::errc::file_exists && !fs::exists(fs::symlink_status(directory, ignored))) return false;
  if (error) make_directory(directory);  // throws an error with the reason
  return true;
}

}  // namespace

DirectoryLock::DirectoryLock(fs::path directory) : directory_(std::move(directory)) {
  while (descriptor_ < 0) {
    if (is_made(directory_)) descriptor_ = locked(directory_);
  }
}

DirectoryLock::~DirectoryLock() {
  remove_if_empty(directory_);
  ::close(descriptor_);
}

}  // namespace breccia

#include "breccia/io/directory_lock.hpp"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "breccia/error.hpp"
#include "breccia/io/text_file.hpp"

namespace breccia {

DirectoryLock::DirectoryLock(const std::filesystem::path& directory) : directory_(directory) {
  make_directory(directory);
  descriptor_ =
      ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);  // NOLINT(cppcoreguidelines-pro-type-vararg)
  if (descriptor_ < 0 || ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  const int reason = errno;
  // Some file systems know no locks.
  if (reason != EWOULDBLOCK) return;
  ::close(descriptor_);
  throw InputError(
      fmt::format("{}: another process of Breccia writes its results here; wait for its end, or take another "
                  "directory (--out)",
                  directory.string()));
}

DirectoryLock::~DirectoryLock() {
  std::error_code is_not_empty;
  std::filesystem::remove(directory_, is_not_empty);
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace breccia

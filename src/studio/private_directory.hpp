#pragma once

#include <filesystem>
#include <mutex>

namespace breccia::studio {

/// A directory that only its user can read and that is removed at the end: for what is looked at once.
class PrivateDirectory {
 public:
  /// Throws FileError if it cannot be made.
  PrivateDirectory();
  ~PrivateDirectory();
  PrivateDirectory(const PrivateDirectory&) = delete;
  PrivateDirectory& operator=(const PrivateDirectory&) = delete;
  PrivateDirectory(PrivateDirectory&&) = delete;
  PrivateDirectory& operator=(PrivateDirectory&&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
  /// The path of a subdirectory that does not exist yet; of the earlier ones only the latest few are kept.
  std::filesystem::path next();

 private:
  std::filesystem::path path_;
  std::mutex mutex_;
  int count_ = 0;
};

}  // namespace breccia::studio

#pragma once

#include <cstddef>
#include <filesystem>

namespace breccia::films {

/// A new directory for the files of factors within the directory for temporary files. It is removed with its content at
/// the end, also when a signal has stopped the calculation.
class FactorDirectory {
 public:
  /// Throws InputError where the environment variable TMPDIR does not name a directory in which another can be made, or
  /// where the name is too long for MUMPS.
  FactorDirectory();
  ~FactorDirectory();
  FactorDirectory(const FactorDirectory&) = delete;
  FactorDirectory& operator=(const FactorDirectory&) = delete;
  FactorDirectory(FactorDirectory&&) = delete;
  FactorDirectory& operator=(FactorDirectory&&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

  /// Largest number of characters of the name.
  static constexpr std::size_t longest_name = 255;

 private:
  std::filesystem::path path_;
};

}  // namespace breccia::films

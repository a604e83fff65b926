#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace breccia {

/// A file that appears under its name all at once: it is written under a temporary name beside it, and renamed by
/// commit(). Without commit() the destructor removes the temporary file and an older file of that name stays as it was.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;
  ~AtomicFile();

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
  /// Where to write until commit().
  [[nodiscard]] const std::filesystem::path& temporary() const noexcept { return temporary_; }
  /// Renames the temporary file, which must be closed by now. Throws FileError.
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;  ///< empty when nothing is left to remove
};

/// The bytes of a file. Throws FileError.
std::string read_text(const std::filesystem::path& path);

/// Writes a file atomically; its directory must exist. Throws FileError.
void write_text(const std::filesystem::path& path, std::string_view text);

/// 64-bit xxHash of some bytes, as 16 hexadecimal digits. Tells contents apart; it is no protection against forgery.
std::string content_hash(std::string_view bytes);

}  // namespace breccia

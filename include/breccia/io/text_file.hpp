#pragma once

#include <filesystem>
#include <span>
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

/// Copies a file atomically. Throws FileError.
void copy_result(const std::filesystem::path& from, const std::filesystem::path& to);

/// Makes a directory, and those above it. Throws FileError.
void make_directory(const std::filesystem::path& directory);

/// Throws InputError where a file of a directory that is to be written or removed is one of the inputs it comes from.
void refuse_to_replace(const std::filesystem::path& directory, std::span<const std::string> names,
                       std::span<const std::filesystem::path> inputs);

/// Removes files of a directory where they are. Throws FileError.
void remove_files(const std::filesystem::path& directory, std::span<const std::string> names);

/// Removes what a process that was killed has left of atomic files in a directory, if there is one. Throws FileError.
void remove_partial_files(const std::filesystem::path& directory);

/// 64-bit xxHash of some bytes, as 16 hexadecimal digits. Tells contents apart; it is no protection against forgery.
std::string content_hash(std::string_view bytes);

}  // namespace breccia

#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace breccia {

/// A file that is written under a temporary name in the same directory and renamed by commit(), so that it never
/// appears incomplete. Without commit() the destructor removes the temporary file, and an older file of that name
/// remains unchanged.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;
  ~AtomicFile();

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
  /// The path to write to before commit().
  [[nodiscard]] const std::filesystem::path& temporary() const noexcept { return temporary_; }
  /// Renames the temporary file, which must be closed by now. Throws FileError.
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;  ///< empty after commit() or a move
};

/// The bytes of a file. Throws FileError, also for a stream without an end.
std::string read_text(const std::filesystem::path& path);

/// The first `most` bytes of a file, or all of a shorter one. Throws FileError.
std::string read_beginning(const std::filesystem::path& path, std::size_t most);

/// Writes a file atomically; its directory must exist. Throws FileError.
void write_text(const std::filesystem::path& path, std::string_view text);

/// Copies a file atomically. Throws FileError.
void copy_result(const std::filesystem::path& from, const std::filesystem::path& to);

/// Creates a directory and its missing parents. Throws FileError.
void make_directory(const std::filesystem::path& directory);

/// Throws InputError if one of the named files of a directory, which will be written or removed, is an input file.
void refuse_to_replace(const std::filesystem::path& directory, std::span<const std::string> names,
                       std::span<const std::filesystem::path> inputs);

/// Removes the named files from a directory; missing ones are ignored. Throws FileError.
void remove_files(const std::filesystem::path& directory, std::span<const std::string> names);

/// Removes the temporary files that killed processes have left in a directory (is_partial_name) of the files whose
/// names are known. Throws FileError.
void remove_partial_files(const std::filesystem::path& directory,
                          const std::function<bool(std::string_view)>& is_known);

/// 64-bit xxHash of some bytes, as 16 hexadecimal digits. It distinguishes contents, but does not protect against
/// forgery.
std::string content_hash(std::string_view bytes);

}  // namespace breccia

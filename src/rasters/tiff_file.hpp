#pragma once

#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include <tiffio.h>

namespace breccia {

/// A TIFF file in memory, opened with libtiff. The messages of libtiff become part of errors and are not printed.
class TiffFile {
 public:
  /// Throws InputError. The bytes must live as long as this object.
  TiffFile(std::filesystem::path path, std::string_view bytes);
  TiffFile(const TiffFile&) = delete;
  TiffFile& operator=(const TiffFile&) = delete;
  TiffFile(TiffFile&&) = delete;
  TiffFile& operator=(TiffFile&&) = delete;
  ~TiffFile() = default;

  [[nodiscard]] TIFF* handle() const noexcept { return handle_.get(); }
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
  [[nodiscard]] std::size_t size() const noexcept { return bytes_.size(); }

  /// Goes to the next page. Returns false after the last one; throws InputError if it is damaged.
  bool next_page();

  /// The value of a tag of this page, or its default.
  [[nodiscard]] std::uint16_t tag(std::uint32_t name, std::uint16_t otherwise) const;
  [[nodiscard]] std::uint32_t tag(std::uint32_t name, std::uint32_t otherwise) const;
  [[nodiscard]] double tag(std::uint32_t name, double otherwise) const;
  /// The text of a tag, empty if there is none.
  [[nodiscard]] std::string text_tag(std::uint32_t name) const;

  /// Throws InputError with the page, and with the message of libtiff if `found` is empty.
  [[noreturn]] void refuse(std::string_view found, std::string_view expected) const;
  /// Throws InputError with the message of libtiff.
  [[noreturn]] void refuse_damaged() const;

 private:
  static int keep_message(TIFF* tiff, void* file, const char* module, const char* format, std::va_list arguments);
  static tmsize_t read(thandle_t file, void* to, tmsize_t count);
  static tmsize_t write(thandle_t file, void* from, tmsize_t count);
  static toff_t seek(thandle_t file, toff_t offset, int whence);
  static int close(thandle_t file);
  static toff_t file_size(thandle_t file);
  static int map(thandle_t file, void** base, toff_t* size);
  static void unmap(thandle_t file, void* base, toff_t size);

  std::filesystem::path path_;
  std::string_view bytes_;
  std::size_t place_ = 0;  ///< position of the next byte that is read
  std::size_t page_ = 1;
  std::string message_;  ///< the first message of libtiff
  std::unique_ptr<TIFF, decltype(&TIFFClose)> handle_;
};

}  // namespace breccia

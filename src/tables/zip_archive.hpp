#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct zip;

namespace breccia::detail {

/// A ZIP archive in memory, whose entries are read by libzip.
class ZipArchive {
 public:
  /// The bytes must outlive this object. Throws InputError with the reason if they are no sound archive.
  explicit ZipArchive(std::string_view bytes);

  /// The content of an entry, by its path in the archive in any case; nothing if there is none of this name. Throws
  /// InputError with the reason if it is damaged, encrypted or longer than 128 MiB.
  [[nodiscard]] std::optional<std::string> entry(const std::string& name) const;

 private:
  struct Discard {
    void operator()(zip* archive) const noexcept;
  };
  std::unique_ptr<zip, Discard> archive_;
};

}  // namespace breccia::detail

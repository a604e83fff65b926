#include "tables/zip_archive.hpp"

#include <cstddef>

#include <fmt/format.h>
#include <zip.h>

#include "breccia/error.hpp"

namespace breccia::detail {
namespace {

/// An error of libzip, whose text it owns.
class ZipError {
 public:
  ZipError() noexcept { zip_error_init(&error_); }
  ZipError(const ZipError&) = delete;
  ZipError& operator=(const ZipError&) = delete;
  ZipError(ZipError&&) = delete;
  ZipError& operator=(ZipError&&) = delete;
  ~ZipError() { zip_error_fini(&error_); }

  [[nodiscard]] zip_error_t* get() noexcept { return &error_; }
  [[noreturn]] void raise() {
    throw InputError(fmt::format("a damaged archive ({}); save it anew in a spreadsheet, or its table as CSV",
                                 zip_error_strerror(&error_)));
  }

 private:
  zip_error_t error_ = {};
};

struct CloseEntry {
  void operator()(zip_file_t* entry) const noexcept { zip_fclose(entry); }
};

}  // namespace

void ZipArchive::Discard::operator()(zip* archive) const noexcept {
  zip_discard(archive);
}

ZipArchive::ZipArchive(std::string_view bytes) {
  ZipError error;
  auto* const source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, error.get());
  if (source == nullptr) error.raise();
  archive_.reset(zip_open_from_source(source, ZIP_RDONLY, error.get()));
  if (archive_) return;  // it owns the source
  zip_source_free(source);
  error.raise();
}

std::optional<std::string> ZipArchive::entry(const std::string& name) const {
  constexpr std::size_t longest = std::size_t{128} << 20U;
  zip_stat_t status;
  if (zip_stat(archive_.get(), name.c_str(), ZIP_FL_NOCASE, &status) != 0) return std::nullopt;
  if (status.size > longest) {
    throw InputError(fmt::format("{} in the archive has {} MiB, more than 128", name, status.size >> 20U));
  }
  const auto refuse = [&](const char* reason) {
    throw InputError(fmt::format("{} in the archive cannot be read: {}", name, reason));
  };
  const std::unique_ptr<zip_file_t, CloseEntry> file(zip_fopen_index(archive_.get(), status.index, 0));
  if (!file) refuse(zip_strerror(archive_.get()));
  std::string content(status.size, '\0');
  std::size_t read = 0;
  while (read < content.size()) {
    const auto count = zip_fread(file.get(), content.data() + read, content.size() - read);
    if (count < 0) refuse(zip_file_strerror(file.get()));
    if (count == 0) refuse("it ends early");
    read += static_cast<std::size_t>(count);
  }
  // The checksum is compared at the end of the entry.
  char beyond = '\0';
  if (zip_fread(file.get(), &beyond, 1) != 0) refuse(zip_file_strerror(file.get()));
  return content;
}

}  // namespace breccia::detail

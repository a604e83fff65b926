#include "rasters/tiff_file.hpp"

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/printable.hpp"

namespace breccia {

namespace {

TiffFile& tiff_of(void* file) {
  return *static_cast<TiffFile*>(file);
}

int ignore_tiff_warning(TIFF* /*tiff*/, void* /*file*/, const char* /*module*/, const char* /*format*/,
                        std::va_list /*arguments*/) {
  return 1;
}

}  // namespace

TiffFile::TiffFile(std::filesystem::path path, std::string_view bytes)
    : path_(std::move(path)), bytes_(bytes), handle_(nullptr, TIFFClose) {
  constexpr tmsize_t most_memory_at_once = tmsize_t{1} << 31;
  const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                                 TIFFOpenOptionsFree);
  TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), most_memory_at_once);
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_message, this);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignore_tiff_warning, nullptr);
  handle_.reset(
      TIFFClientOpenExt(path_.c_str(), "r", this, read, write, seek, close, file_size, map, unmap, options.get()));
  if (handle_ == nullptr) refuse_damaged();
}

bool TiffFile::next_page() {
  if (TIFFLastDirectory(handle()) != 0) return false;
  ++page_;
  if (TIFFReadDirectory(handle()) == 0) refuse_damaged();
  return true;
}

std::uint16_t TiffFile::tag(std::uint32_t name, std::uint16_t otherwise) const {
  auto value = otherwise;
  return TIFFGetFieldDefaulted(handle(), name, &value) != 0 ? value : otherwise;
}

std::uint32_t TiffFile::tag(std::uint32_t name, std::uint32_t otherwise) const {
  auto value = otherwise;
  return TIFFGetFieldDefaulted(handle(), name, &value) != 0 ? value : otherwise;
}

double TiffFile::tag(std::uint32_t name, double otherwise) const {
  auto value = static_cast<float>(otherwise);
  return TIFFGetFieldDefaulted(handle(), name, &value) != 0 ? value : otherwise;
}

std::string TiffFile::text_tag(std::uint32_t name) const {
  const char* text = nullptr;
  return TIFFGetField(handle(), name, &text) != 0 && text != nullptr ? text : "";
}

void TiffFile::refuse(std::string_view found, std::string_view expected) const {
  throw InputError(fmt::format("{}: page {}: {}; expected {}", path_.string(), page_, found, expected));
}

void TiffFile::refuse_damaged() const {
  throw InputError(fmt::format("{}: a damaged TIFF file, page {}: {}", path_.string(), page_,
                               message_.empty() ? "it cannot be decoded" : printable(message_)));
}

int TiffFile::keep_message(TIFF* /*tiff*/, void* file, const char* /*module*/, const char* format,
                           std::va_list arguments) {
  auto& message = tiff_of(file).message_;
  if (!message.empty()) return 1;
  std::array<char, 300> text{};
  std::vsnprintf(text.data(), text.size(), format, arguments);
  message = text.data();
  return 1;
}

tmsize_t TiffFile::read(thandle_t file, void* to, tmsize_t count) {
  auto& tiff = tiff_of(file);
  const auto begin = std::min(tiff.place_, tiff.bytes_.size());
  const auto bytes = tiff.bytes_.substr(begin, static_cast<std::size_t>(std::max<tmsize_t>(count, 0)));
  std::memcpy(to, bytes.data(), bytes.size());
  tiff.place_ = begin + bytes.size();
  return static_cast<tmsize_t>(bytes.size());
}

tmsize_t TiffFile::write(thandle_t /*file*/, void* /*from*/, tmsize_t /*count*/) {
  return 0;
}

toff_t TiffFile::seek(thandle_t file, toff_t offset, int whence) {
  auto& tiff = tiff_of(file);
  const auto origin = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? tiff.place_ : tiff.bytes_.size();
  return tiff.place_ = origin + offset;
}

int TiffFile::close(thandle_t /*file*/) {
  return 0;
}

toff_t TiffFile::file_size(thandle_t file) {
  return tiff_of(file).bytes_.size();
}

int TiffFile::map(thandle_t file, void** base, toff_t* size) {
  const auto bytes = tiff_of(file).bytes_;
  *base = const_cast<char*>(bytes.data());  // NOLINT(cppcoreguidelines-pro-type-const-cast) libtiff only reads
  *size = bytes.size();
  return 1;
}

void TiffFile::unmap(thandle_t /*file*/, void* /*base*/, toff_t /*size*/) {}

}  // namespace breccia

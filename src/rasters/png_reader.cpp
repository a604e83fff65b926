#include "rasters/png_reader.hpp"

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <png.h>

#include "breccia/error.hpp"

#include "rasters/grey_levels.hpp"
#include "rasters/raster_elements.hpp"
#include "rasters/raster_layout.hpp"

namespace breccia {

namespace {

/// A PNG file in memory. libpng reports an error by a jump, which must not pass over an object with a destructor: so
/// the functions that call it have none, and return whether they succeeded.
class PngDecoder {
 public:
  explicit PngDecoder(std::string_view bytes)
      : rest_(bytes),
        png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, keep_message, ignore_warning)),
        info_(png_ != nullptr ? png_create_info_struct(png_) : nullptr) {
    if (info_ != nullptr) png_set_read_fn(png_, this, next_bytes);
  }
  PngDecoder(const PngDecoder&) = delete;
  PngDecoder& operator=(const PngDecoder&) = delete;
  PngDecoder(PngDecoder&&) = delete;
  PngDecoder& operator=(PngDecoder&&) = delete;
  ~PngDecoder() { png_destroy_read_struct(&png_, &info_, nullptr); }

  /// Reads the header before the pixels, and requests samples of whole bytes in the byte order of this machine.
  bool read_header() {
    if (info_ == nullptr || setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT(cert-err52-cpp) libpng's way
    png_read_info(png_, info_);
    png_set_packing(png_);
    if constexpr (std::endian::native == std::endian::little) png_set_swap(png_);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    return true;
  }

  /// Reads the pixels, and the file to its end.
  bool read_rows(png_bytep* rows) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT(cert-err52-cpp)
    png_read_image(png_, rows);
    png_read_end(png_, nullptr);
    return true;
  }

  [[nodiscard]] std::size_t width() const { return png_get_image_width(png_, info_); }
  [[nodiscard]] std::size_t height() const { return png_get_image_height(png_, info_); }
  [[nodiscard]] std::size_t channels() const { return png_get_channels(png_, info_); }
  [[nodiscard]] bool has_palette() const { return png_get_color_type(png_, info_) == PNG_COLOR_TYPE_PALETTE; }
  [[nodiscard]] std::size_t bytes_per_sample() const { return png_get_bit_depth(png_, info_) > 8 ? 2 : 1; }
  [[nodiscard]] std::size_t bytes_per_row() const { return png_get_rowbytes(png_, info_); }
  [[nodiscard]] const char* message() const { return message_.data(); }

 private:
  static PngDecoder& decoder_of(png_structp png) { return *static_cast<PngDecoder*>(png_get_error_ptr(png)); }

  [[noreturn]] static void keep_message(png_structp png, png_const_charp message) {
    auto& kept = decoder_of(png).message_;
    std::strncpy(kept.data(), message, kept.size() - 1);
    png_longjmp(png, 1);
  }

  static void ignore_warning(png_structp /*png*/, png_const_charp /*message*/) {}

  static void next_bytes(png_structp png, png_bytep to, std::size_t count) {
    auto& rest = decoder_of(png).rest_;
    if (count > rest.size()) png_error(png, "the file ends too early");
    std::memcpy(to, rest.data(), count);
    rest.remove_prefix(count);
  }

  std::string_view rest_;
  std::array<char, 200> message_{"not enough memory"};
  png_structp png_;
  png_infop info_;
};

}  // namespace

Raster read_png(const std::filesystem::path& file, std::string_view bytes) {
  PngDecoder png(bytes);
  const auto refuse = [&] {
    throw InputError(fmt::format("{}: a damaged PNG file: {}", file.string(), png.message()));
  };
  if (!png.read_header()) refuse();
  std::vector<std::size_t> extents{png.width(), png.height()};
  const auto pixels = pixel_count(file, extents);
  require_plausible_size(file, pixels / 8, bytes.size());  // number of bytes with the least depth, one bit

  std::string samples(png.bytes_per_row() * png.height(), '\0');
  std::vector<png_bytep> rows;
  for (std::size_t row = 0; row < png.height(); ++row) {
    rows.push_back(reinterpret_cast<png_bytep>(samples.data()) + row * png.bytes_per_row());
  }
  if (!png.read_rows(rows.data())) refuse();

  const ElementType type{ElementType::Kind::unsigned_integer, png.bytes_per_sample()};
  std::vector<std::int32_t> values;
  values.reserve(pixels * png.channels());
  append_elements(values, file, samples, type);
  if (png.channels() == 1) {
    auto raster = raster_from_top(std::move(extents), std::move(values));
    if (png.has_palette()) raster.shades = Shades::palette;
    return raster;
  }
  const std::uint16_t most = type.bytes == 1 ? 255 : 65535;
  return raster_from_top(std::move(extents), grey_levels(file, {png.channels(), most, {values.begin(), values.end()}}));
}

}  // namespace breccia

#include "rasters/vti_document.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <fmt/format.h>
#include <zlib.h>

#include "breccia/error.hpp"

#include "io/display.hpp"
#include "io/file_mistakes.hpp"
#include "io/printable.hpp"
#include "rasters/base64.hpp"

namespace breccia {

namespace {

constexpr std::string_view appended_tag = "<AppendedData";

}  // namespace

VtiDocument::VtiDocument(std::filesystem::path file, std::string_view bytes) : file_(std::move(file)), bytes_(bytes) {
  parse();
  const std::string_view type = root().attribute("type").value();
  if (type != "ImageData") refuse(fmt::format("a VTK file of type {}", shown_value(type)), "ImageData");
  byte_order_ = has_second("byte_order", "LittleEndian", "BigEndian") ? std::endian::big : std::endian::little;
  bytes_per_header_number_ = has_second("header_type", "UInt32", "UInt64") ? 8 : 4;
  is_compressed_ = has_second("compressor", "", "vtkZLibDataCompressor");
}

/// Parses the XML, without binary data that may follow it.
void VtiDocument::parse() {
  const auto tag = bytes_.find(appended_tag);
  std::string text(bytes_.substr(0, tag));
  if (tag != std::string_view::npos) {
    const auto end = bytes_.find('>', tag);
    if (end == std::string_view::npos) refuse("an element <AppendedData> that does not end", "binary data behind it");
    text += bytes_.substr(tag, end + 1 - tag);
    text += "</AppendedData></VTKFile>";
    const auto underscore = std::min(bytes_.find('_', end), bytes_.size() - 1);
    appended_ = bytes_.substr(underscore + 1);
  }
  const auto parsed = xml_.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
  if (parsed) return;
  const auto mistake = text.begin() + std::min<std::ptrdiff_t>(parsed.offset, std::ssize(text));
  throw InputError(fmt::format("{}:{}: damaged XML: {}", file_.string(), std::count(text.begin(), mistake, '\n') + 1,
                               parsed.description()));
}

/// Whether an attribute of the file has the second of its two values; the first one is its default.
bool VtiDocument::has_second(const char* attribute, const char* first, const char* second) const {
  const std::string_view value = root().attribute(attribute).as_string(first);
  if (value != first && value != second) {
    refuse(fmt::format("{}={}", attribute, shown_value(value)), fmt::format(R"("{}" or "{}")", first, second));
  }
  return value == second;
}

std::string VtiDocument::array_bytes(const pugi::xml_node& array, std::size_t count) const {
  auto stored = stored_bytes(array);
  if (is_compressed_) return inflated(stored, count);
  const auto said = header_number(stored, 0);
  if (said != count) refuse(fmt::format("an array of {} bytes", said), fmt::format("{} for the extent", count));
  const auto available = stored.size() - bytes_per_header_number_;
  if (available < count) refuse(fmt::format("{} of an array", display_count(available, "byte")), fmt::to_string(count));
  return stored.substr(bytes_per_header_number_, count);
}

/// The stored bytes of an array, from its header on; to the end of the file where only the header has the length.
std::string VtiDocument::stored_bytes(const pugi::xml_node& array) const {
  const bool is_appended = std::string_view(array.attribute("format").value()) == "appended";
  auto text = std::string_view(array.text().get());
  if (is_appended) {
    const auto begin = array.attribute("offset").as_ullong(appended_.size());
    if (begin >= appended_.size())
      refuse("an array whose offset is missing or beyond the end", "its place in the file");
    text = appended_.substr(begin);
    const std::string_view encoding = root().child("AppendedData").attribute("encoding").value();
    if (encoding == "raw") return std::string(text);
    if (encoding != "base64") refuse(fmt::format("data in the encoding {}", shown_value(encoding)), "raw or base64");
    text = text.substr(0, text.find('<'));
    for (const auto& piece : image().children("Piece")) {
      for (const auto& other : piece.select_nodes(".//DataArray[@format='appended']")) {
        const auto next = other.node().attribute("offset").as_ullong();
        if (next > begin) text = text.substr(0, next - begin);
      }
    }
  }
  auto decoded = decode_base64(text);
  if (!decoded) refuse("an array that is damaged or not base64", "base64");
  return std::move(*decoded);
}

/// A number of the header before the data of an array.
std::size_t VtiDocument::header_number(std::string_view bytes, std::size_t index) const {
  const auto begin = index * bytes_per_header_number_;
  if (bytes.size() < begin + bytes_per_header_number_) refuse("an array that ends within its header", "all of it");
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < bytes_per_header_number_; ++i) {
    const auto place = byte_order_ == std::endian::big ? i : bytes_per_header_number_ - 1 - i;
    number = number << 8U | static_cast<unsigned char>(bytes[begin + place]);
  }
  return number;
}

/// Decompresses data whose header has the number of blocks, their size, the size of a smaller last block (or 0), and
/// the compressed size of each block.
std::string VtiDocument::inflated(std::string_view stored, std::size_t count) const {
  const auto blocks = header_number(stored, 0), block_size = header_number(stored, 1), last = header_number(stored, 2);
  const auto whole_blocks = last == 0 ? blocks : blocks - 1;
  const bool is_sound = blocks > 0 && block_size > 0 && last <= block_size && whole_blocks <= count / block_size &&
                        whole_blocks * block_size + last == count;
  if (!is_sound) {
    refuse(fmt::format("{} compressed blocks of {} bytes, the last of {}", blocks, block_size, last),
           fmt::format("{} bytes for the extent", count));
  }
  constexpr std::size_t first_size = 3;
  static_cast<void>(header_number(stored, first_size + blocks - 1));
  auto rest = stored.substr((first_size + blocks) * bytes_per_header_number_);
  std::string bytes(count, '\0');
  for (std::size_t block = 0, begin = 0; block < blocks; ++block, begin += block_size) {
    const auto expected = std::min(block_size, count - begin);
    const auto size = header_number(stored, first_size + block);
    auto found = static_cast<uLongf>(expected);
    const bool is_whole = size <= rest.size() &&
                          uncompress(reinterpret_cast<Bytef*>(bytes.data() + begin), &found,
                                     reinterpret_cast<const Bytef*>(rest.data()), static_cast<uLong>(size)) == Z_OK &&
                          found == expected;
    if (!is_whole) refuse(fmt::format("block {} of {} damaged or cut", block + 1, blocks), "data of zlib");
    rest.remove_prefix(size);
  }
  return bytes;
}

void VtiDocument::refuse(std::string_view found, std::string_view expected) const {
  throw InputError(fmt::format("{}: {}; expected {}", file_.string(), found, expected));
}

}  // namespace breccia

#pragma once

#include <bit>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include <pugixml.hpp>

namespace breccia {

/// A .vti file: its XML, and binary data that may follow it, which are not XML.
class VtiDocument {
 public:
  /// Throws InputError if it is no VTK XML file of type ImageData, or damaged. The bytes must live as long as this
  /// object.
  VtiDocument(std::filesystem::path file, std::string_view bytes);

  [[nodiscard]] const std::filesystem::path& file() const noexcept { return file_; }
  [[nodiscard]] std::size_t file_size() const noexcept { return bytes_.size(); }
  /// The element <ImageData>.
  [[nodiscard]] pugi::xml_node image() const { return root().child("ImageData"); }
  /// The order of the bytes of binary numbers.
  [[nodiscard]] std::endian byte_order() const noexcept { return byte_order_; }

  /// The numbers of an element <DataArray> of format "binary" or "appended", which are that many bytes. Throws
  /// InputError if there are fewer or more, or if they cannot be decoded.
  [[nodiscard]] std::string array_bytes(const pugi::xml_node& array, std::size_t count) const;

  /// Throws InputError.
  [[noreturn]] void refuse(std::string_view found, std::string_view expected) const;

 private:
  [[nodiscard]] pugi::xml_node root() const { return xml_.child("VTKFile"); }
  void parse();
  [[nodiscard]] bool has_second(const char* attribute, const char* first, const char* second) const;
  [[nodiscard]] std::string stored_bytes(const pugi::xml_node& array) const;
  [[nodiscard]] std::size_t header_number(std::string_view bytes, std::size_t index) const;
  [[nodiscard]] std::string inflated(std::string_view stored, std::size_t count) const;

  std::filesystem::path file_;
  std::string_view bytes_;
  pugi::xml_document xml_;
  std::string_view appended_;  ///< the content of <AppendedData> after the underscore
  std::endian byte_order_ = std::endian::little;
  std::size_t bytes_per_header_number_ = 4;
  bool is_compressed_ = false;
};

}  // namespace breccia

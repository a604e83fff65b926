#include "rasters/npy_header.hpp"

#include <charconv>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/file_mistakes.hpp"

namespace breccia {

namespace {

/// Reads the literal of a Python dictionary: {'descr': '<u2', 'fortran_order': False, 'shape': (3, 4), }
class NpyDictionary {
 public:
  NpyDictionary(const std::filesystem::path& file, std::string_view text) : file_(file), text_(text), rest_(text) {}

  NpyHeader read() {
    NpyHeader header;
    bool has_type = false, has_order = false, has_shape = false;
    require('{');
    while (!accept('}')) {
      const auto key = string();
      require(':');
      if (key == "descr") {
        if (next() == '[') refuse("numbers; a structured array has several in each element");
        header.type = string();
        has_type = true;
      } else if (key == "fortran_order") {
        header.fortran_order = boolean();
        has_order = true;
      } else if (key == "shape") {
        header.shape = tuple();
        has_shape = true;
      } else {
        refuse("the keys 'descr', 'fortran_order' and 'shape'");
      }
      if (!accept(',') && next() != '}') refuse("a comma or a closing brace");
    }
    if (!has_type || !has_order || !has_shape) refuse("the keys 'descr', 'fortran_order' and 'shape'");
    return header;
  }

 private:
  [[noreturn]] void refuse(std::string_view expected) const {
    throw InputError(fmt::format("{}: the header of this NumPy file is {}; expected {}", file_.string(),
                                 shown_value(text_), expected));
  }

  /// The next character that is no space; 0 at the end.
  char next() {
    const auto begin = rest_.find_first_not_of(" \t\r\n");
    rest_.remove_prefix(std::min(begin, rest_.size()));
    return rest_.empty() ? '\0' : rest_.front();
  }

  bool accept(char wanted) {
    if (next() != wanted) return false;
    rest_.remove_prefix(1);
    return true;
  }

  void require(char wanted) {
    if (!accept(wanted)) refuse(fmt::format("a dictionary with '{}' there", wanted));
  }

  bool accept_word(std::string_view word) {
    next();
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }

  std::string string() {
    const char quote = next();
    if (quote != '\'' && quote != '"') refuse("a text in quotes");
    const auto end = rest_.find(quote, 1);
    if (end == std::string_view::npos) refuse("a closing quote");
    std::string text(rest_.substr(1, end - 1));
    rest_.remove_prefix(end + 1);
    return text;
  }

  bool boolean() {
    if (accept_word("True")) return true;
    if (!accept_word("False")) refuse("True or False for 'fortran_order'");
    return false;
  }

  std::vector<std::size_t> tuple() {
    std::vector<std::size_t> numbers;
    require('(');
    while (!accept(')')) {
      next();
      std::size_t number = 0;
      const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
      if (error != std::errc()) refuse("a tuple of whole numbers for 'shape'");
      rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
      accept_word("L");  // of Python 2
      numbers.push_back(number);
      if (!accept(',') && next() != ')') refuse("commas between the numbers of 'shape'");
    }
    return numbers;
  }

  const std::filesystem::path& file_;
  std::string_view text_, rest_;
};

/// A number of `count` bytes, least significant first, at an offset in the file; nothing beyond its end.
std::optional<std::size_t> little_endian(std::string_view bytes, std::size_t offset, std::size_t count) {
  if (bytes.size() < offset + count) return {};
  std::size_t number = 0;
  for (std::size_t i = count; i-- > 0;) number = number << 8U | static_cast<unsigned char>(bytes[offset + i]);
  return number;
}

}  // namespace

NpyHeader read_npy_header(const std::filesystem::path& file, std::string_view bytes) {
  constexpr std::size_t version_at = 6, length_at = 8;
  const auto version = little_endian(bytes, version_at, 1).value_or(0);
  if (version < 1 || version > 3) {
    throw InputError(fmt::format("{}: a NumPy file of version {}; expected 1, 2 or 3", file.string(), version));
  }
  const std::size_t bytes_of_length = version == 1 ? 2 : 4;
  const auto begin = length_at + bytes_of_length;
  const auto length = little_endian(bytes, length_at, bytes_of_length);
  if (!length || *length > bytes.size() - begin) {
    throw InputError(fmt::format("{}: the NumPy file ends within its header", file.string()));
  }
  auto header = NpyDictionary(file, bytes.substr(begin, *length)).read();
  header.size = begin + *length;
  return header;
}

}  // namespace breccia

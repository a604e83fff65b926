#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace breccia {

/// Collects the mistakes in a file. The message has the first three mistakes of each kind and the number of further
/// ones, since a column in a wrong format has a mistake in every row.
class FileMistakes {
 public:
  explicit FileMistakes(const std::filesystem::path& file);

  /// Adds a mistake at a location (`file:line`) or, if `location` is empty, in the file as a whole: `table.csv:3: b:
  /// expected a number, got "x"`. Mistakes with the same `expected` are of one kind. Unprintable bytes are escaped.
  void add(std::string_view location, std::string_view expected, std::string_view got = {});
  [[nodiscard]] bool empty() const noexcept { return kinds_.empty(); }
  /// Throws one InputError with a line for each mistake; does nothing if there are none.
  void refuse() const;

 private:
  struct Kind {
    std::string expected;
    std::size_t count;
  };

  std::string file_;
  std::vector<std::string> lines_;
  std::vector<Kind> kinds_;
  std::size_t others_ = 0;  ///< number of mistakes of further kinds
};

/// A value of a file for a message: in quotes, unprintable bytes escaped, long values cut; `nothing` for an empty
/// value.
std::string shown_value(std::string_view text);

}  // namespace breccia

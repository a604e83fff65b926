#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace breccia {

/// What is wrong with a file. Of each kind of mistake the first three are told, and how many more there are: a column
/// in a wrong format is wrong in all of its ten thousand rows.
class FileMistakes {
 public:
  explicit FileMistakes(const std::filesystem::path& file);

  /// A mistake at a place (`file:line`) or, where that is empty, of the file as a whole: `table.csv:3: b: expected a
  /// number, got "x"`. Mistakes with the same `expected` are of one kind. Bytes that cannot be printed are escaped.
  void add(std::string_view place, std::string_view expected, std::string_view got = {});
  [[nodiscard]] bool empty() const noexcept { return kinds_.empty(); }
  /// Throws one InputError with a line for each mistake, if there are any.
  void refuse() const;

 private:
  struct Kind {
    std::string expected;
    std::size_t count;
  };

  std::string file_;
  std::vector<std::string> lines_;
  std::vector<Kind> kinds_;
  std::size_t others_ = 0;  ///< of further kinds
};

/// A value of a file in a message: in quotes, bytes escaped, cut where it is long; `nothing` where it is empty.
std::string shown_value(std::string_view text);

}  // namespace breccia

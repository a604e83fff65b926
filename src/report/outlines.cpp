#include "report/outlines.hpp"

#include <iterator>

#include <fmt/format.h>

namespace breccia {
namespace {

/// The phases of the squares of a map; of a larger map only every second or third square, and so on, is used.
class PhaseSquares {
 public:
  PhaseSquares(const std::vector<std::uint8_t>& phases, std::size_t columns, std::size_t most)
      : phases_(phases),
        all_columns_(columns),
        every_((columns + most - 1) / most),
        columns_((columns + every_ - 1) / every_) {}

  [[nodiscard]] std::size_t columns() const noexcept { return columns_; }
  /// The phase of a square by its row from the bottom and its column.
  [[nodiscard]] std::uint8_t at(std::size_t row, std::size_t column) const {
    return phases_[row * every_ * all_columns_ + column * every_];
  }

 private:
  const std::vector<std::uint8_t>& phases_;
  std::size_t all_columns_, every_, columns_;
};

}  // namespace

std::string outlines_of(const std::vector<std::uint8_t>& phases, std::size_t columns, std::size_t most) {
  const PhaseSquares squares(phases, columns, most);
  const auto count = squares.columns();
  const double side = 1.0 / static_cast<double>(count);
  std::string path;
  const auto out = std::back_inserter(path);
  /// Adds the runs, along a line, of sides of squares between two phases.
  const auto add_runs = [&](const auto& parts, const auto& add) {
    for (std::size_t begin = 0, end = 0; begin < count; begin = end + 1) {
      for (end = begin; end < count && parts(end);) ++end;
      if (end > begin) add(begin, end);
    }
  };
  const auto place = [&](std::size_t i) { return side * static_cast<double>(i); };
  for (std::size_t line = 1; line < count; ++line) {
    add_runs([&](std::size_t i) { return squares.at(line - 1, i) != squares.at(line, i); },
             [&](std::size_t begin, std::size_t end) {
               fmt::format_to(out, "M{:.4g} {:.4g}h{:.4g}", place(begin), 1.0 - place(line), place(end - begin));
             });
    add_runs([&](std::size_t i) { return squares.at(i, line - 1) != squares.at(i, line); },
             [&](std::size_t begin, std::size_t end) {
               fmt::format_to(out, "M{:.4g} {:.4g}v-{:.4g}", place(line), 1.0 - place(begin), place(end - begin));
             });
  }
  return path;
}

}  // namespace breccia

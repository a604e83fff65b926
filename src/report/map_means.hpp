#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace breccia {

/// The most columns of the map of field_picture().
inline constexpr std::size_t most_map_columns = 600;

/// Means of a square map over equal squares, the smallest squares with which at most a given number of columns remains,
/// from its values row by row; the last squares may be smaller. A map may thus be larger than the memory.
class MapMeans {
 public:
  MapMeans(std::size_t columns, std::size_t most);

  /// Takes the next value.
  void add(double value);

  /// Number of columns of the means.
  [[nodiscard]] std::size_t columns() const noexcept { return means_; }
  /// Whether the next value is the first one of its square, in its first row.
  [[nodiscard]] bool begins_square() const noexcept { return row_ % side_ == 0 && column_ % side_ == 0; }
  /// The means row by row, of the values so far.
  [[nodiscard]] std::vector<double> values() const;

 private:
  /// Length of the side of a square, in values; the last square may be smaller.
  [[nodiscard]] std::size_t side_of(std::size_t square) const noexcept;

  std::size_t columns_, side_, means_;
  std::size_t row_ = 0, column_ = 0;  ///< row and column of the next value
  std::vector<double> sums_;
};

}  // namespace breccia

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rasters/png.hpp"
#include "report/field_picture.hpp"

namespace breccia {

/// The range of values from the lowest to the highest colour of a map: the 1st to the 99th percentile of its values.
class ColourRange {
 public:
  /// `values` are the values that the map shows.
  ColourRange(ColourScale scale, const std::vector<double>& values);

  /// The range of colours of some values, with a diverging scale instead of a linear one where the range has values of
  /// both signs.
  static ColourRange diverging_if_signed(ColourScale scale, const std::vector<double>& values);

  /// The value at a share of the scale, 0 to 1.
  [[nodiscard]] double value_at(double share) const;
  /// The index of the colour of a value, 0 to 255. On a logarithmic scale values that are not positive have the lowest
  /// colour.
  [[nodiscard]] std::uint8_t index_of(double value) const;

  /// The colours by their numbers.
  [[nodiscard]] std::array<Rgb, 256> colours() const;
  [[nodiscard]] bool is_logarithmic() const noexcept { return scale_ == ColourScale::logarithmic; }

 private:
  ColourScale scale_;
  double from_, to_;
};

}  // namespace breccia

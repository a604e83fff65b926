#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "breccia/rasters/png.hpp"
#include "breccia/report/field_picture.hpp"

namespace breccia {

/// The range of values from the lowest to the highest colour of a map: the 1st to the 99th percentile of its values.
class ColourRange {
 public:
  /// `values` are those that the map shows.
  ColourRange(ColourScale scale, const std::vector<double>& values);

  /// The same, but with a diverging scale in the place of a linear one where values of both signs have a part in it.
  static ColourRange diverging_if_signed(ColourScale scale, const std::vector<double>& values);

  /// The value at a share of the scale, 0 to 1.
  [[nodiscard]] double value_at(double share) const;
  /// The colour of a value, from 0 to 255. On a logarithmic scale values that are not positive have the lowest one.
  [[nodiscard]] std::uint8_t index_of(double value) const;

  /// The colours by their numbers.
  [[nodiscard]] std::array<Rgb, 256> colours() const;
  [[nodiscard]] bool is_logarithmic() const noexcept { return scale_ == ColourScale::logarithmic; }

 private:
  ColourScale scale_;
  double from_, to_;
};

}  // namespace breccia

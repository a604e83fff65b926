#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "breccia/microstructure/grey_segmentation.hpp"

namespace breccia {

/// The number of pixels of each grey value of a picture.
class GreyHistogram {
 public:
  /// Throws InputError if the values span more than 65536, as those of 16 bits do not.
  explicit GreyHistogram(std::span<const std::int32_t> values);

  [[nodiscard]] std::int32_t darkest() const { return darkest_; }
  [[nodiscard]] std::int32_t brightest() const;
  [[nodiscard]] std::size_t distinct_values() const;

  /// Otsu's threshold: that for which the variance between the grey values up to it and those above it is largest, the
  /// middle of those that divide the pixels alike, as between two separate peaks. N. Otsu, IEEE Transactions on
  /// Systems, Man, and Cybernetics 9 (1979) 62-66, Eq. 18. Throws InputError if all pixels are equal.
  [[nodiscard]] double otsu_threshold() const;

  /// The two sides of a threshold, without labels. Throws InputError if all pixels are on one side.
  [[nodiscard]] GreySegmentation divided_at(double threshold) const;

 private:
  [[nodiscard]] GreySide side(std::int32_t first, std::int32_t last) const;
  [[nodiscard]] double share_above(double threshold) const;
  /// The largest grey value that is not above a threshold.
  [[nodiscard]] std::int32_t last_up_to(double threshold) const;

  std::int32_t darkest_ = 0;
  std::vector<std::size_t> counts_;  ///< from the darkest value to the brightest
  std::size_t pixels_ = 0;
};

/// Otsu's measure of separability of a histogram that is flat, 3/4, which no threshold separates better: of a picture
/// below it the threshold may divide one peak, or one side may be rare. (A normal distribution has 2/pi.)
inline constexpr double separability_of_flat_histogram = 0.75;

}  // namespace breccia

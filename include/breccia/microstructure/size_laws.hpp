#pragma once

namespace breccia {

// Laws with few numbers for the distribution of diameters by volume: the share F(d) of the volume that is in particles
// of diameter d and less.

/// Fuller's curve, by which aggregates of concrete are graded: F = (d / largest)^exponent.
struct FullerSizes {
  double largest = 0.0;   ///< [m]
  double exponent = 0.5;  ///< [-]
};

/// The distribution of Rosin and Rammler, that of ground powders: F = 1 - exp(-(d / size)^exponent).
struct RosinRammlerSizes {
  double size = 0.0;      ///< diameter below which 63.2 % of the volume are [m]
  double exponent = 0.0;  ///< [-]
};

/// The distribution through three quantiles. The normal quantile of F is linear in log d between them and goes on with
/// the same slopes, so that F is lognormal where d50 is the geometric mean of the two others.
struct QuantileSizes {
  double d10 = 0.0;  ///< diameter below which 10 % of the volume are [m]
  double d50 = 0.0;  ///< the same for 50 % [m]
  double d90 = 0.0;  ///< the same for 90 % [m]
};

/// The share F [-] of the volume in particles of this diameter [m] and less, by a law whose numbers are valid.
[[nodiscard]] double share_up_to(double diameter, const FullerSizes& law);
[[nodiscard]] double share_up_to(double diameter, const RosinRammlerSizes& law);
[[nodiscard]] double share_up_to(double diameter, const QuantileSizes& law);

}  // namespace breccia

#pragma once

#include <variant>
#include <vector>

#include "breccia/microstructure/size_laws.hpp"

namespace breccia {

/// One part of a mixture of lognormal distributions.
struct LognormalComponent {
  double weight;  ///< its share of the volume, relative to the other weights
  double median;  ///< [m]
  double sigma;   ///< standard deviation of the logarithm of the diameter [-]
};

/// Distribution of particle diameters by volume (in 2D: by area): F(d) is the share of the volume that is in particles
/// of diameter d and less. All functions throw InputError on arguments that do not describe a distribution.
class SizeDistribution {
 public:
  /// The distribution of particles that all have one diameter [m].
  [[nodiscard]] static SizeDistribution monodisperse(double diameter);
  /// A sum of lognormal distributions. The weights are scaled so that their sum is 1.
  [[nodiscard]] static SizeDistribution lognormal_mixture(std::vector<LognormalComponent> components);
  /// The distribution of a table: strictly rising diameters [m] and the values of F at these, rising from 0 to 1.
  /// Between them F is linear in log d.
  [[nodiscard]] static SizeDistribution tabulated(std::vector<double> diameters, std::vector<double> cumulative);
  [[nodiscard]] static SizeDistribution fuller(const FullerSizes& law);
  [[nodiscard]] static SizeDistribution rosin_rammler(const RosinRammlerSizes& law);
  /// The distribution through three quantiles, which rise.
  [[nodiscard]] static SizeDistribution quantiles(const QuantileSizes& law);

  /// The distribution of the particles of diameter `from` to `to` [m] alone.
  [[nodiscard]] SizeDistribution truncated(double from, double to) const;

  /// The share of the volume of the whole law that lies from the smallest to the largest diameter [-]: 1 unless it was
  /// truncated.
  [[nodiscard]] double share_of_law() const noexcept { return within_; }

  /// The share F(d) of the volume in particles of diameter d [m] and less [-].
  [[nodiscard]] double cumulative(double diameter) const;
  /// The smallest d [m] with F(d) >= p, 0 <= p <= 1. Infinite for p = 1 of a law without a largest diameter that is not
  /// truncated.
  [[nodiscard]] double quantile(double p) const;
  /// Bounds of the diameters [m]: 0 and infinity for a law without such bounds that is not truncated.
  [[nodiscard]] double smallest() const noexcept { return smallest_; }
  [[nodiscard]] double largest() const noexcept { return largest_; }

 private:
  struct Single {
    double diameter;
  };
  using Mixture = std::vector<LognormalComponent>;
  struct Table {
    std::vector<double> diameters, cumulative;
  };
  using Law = std::variant<Single, Mixture, Table, FullerSizes, RosinRammlerSizes, QuantileSizes>;

  SizeDistribution(Law law, double smallest, double largest);
  [[nodiscard]] double untruncated(double diameter) const;

  Law law_;
  double smallest_;
  double largest_;
  double below_ = 0.0;   // share of the law below `smallest_`
  double within_ = 1.0;  // share of the law from `smallest_` to `largest_`
};

}  // namespace breccia

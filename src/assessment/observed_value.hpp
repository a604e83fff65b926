#pragma once

#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "breccia/assessment/observation.hpp"

#include "viscoelasticity/talbot_contour.hpp"

namespace breccia {

/// The value that an observation would have, as a function of the Carson moduli of the composite at some Laplace
/// variables: at i omega for a frequency, along Talbot's contour for a time, where it errs by 1e-9 of the
/// unrelaxed modulus.
class ObservedValue {
 public:
  explicit ObservedValue(const Observation& observation);

  /// The Laplace variables [1/s].
  [[nodiscard]] const std::vector<std::complex<double>>& variables() const noexcept { return variables_; }
  /// The value from the moduli at these variables [Pa], in the unit of the observation.
  [[nodiscard]] double value(std::span<const std::complex<double>> moduli) const;
  /// The change of the value with changes of the moduli, to first order.
  [[nodiscard]] double change(std::span<const std::complex<double>> moduli,
                              std::span<const std::complex<double>> changes) const;
  /// The power to which a factor of the modulus is raised in the value: 1, -1 of a compliance, 0 of a phase.
  [[nodiscard]] int power_of_factor() const;

 private:
  ObservedCurve curve_;
  double at_;
  std::optional<TalbotContour> contour_;  ///< of a value in time
  std::vector<std::complex<double>> variables_;
};

/// A modulus of an isotropic solid as a function of its shear and its bulk modulus, with its derivatives by these.
struct OfShearAndBulk {
  std::complex<double> value, by_shear, by_bulk;
};

/// The modulus that was observed of a solid with these moduli [Pa].
OfShearAndBulk observed_modulus(ObservedModulus modulus, std::complex<double> shear, std::complex<double> bulk);

}  // namespace breccia

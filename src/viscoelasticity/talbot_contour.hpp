#pragma once

#include <complex>
#include <span>
#include <vector>

namespace breccia {

/// The inverse Laplace transform at one time by Talbot's method with a fixed contour (Abate and Valko, Int. J. Numer.
/// Methods Eng. 60, 979, 2004). All singularities of the transform must be on the negative real axis, as those of
/// relaxing solids are. The result is linear in the values of the transform. With n nodes its error is about
/// 10^(-0.6 n) of the largest value of the function, down to 1e-9 of its value at the time for 20 of them where it
/// falls over many decades of time.
class TalbotContour {
 public:
  /// The contour for a time [s], which is positive.
  TalbotContour(double time, int nodes);

  /// The Laplace variables s at the nodes [1/s].
  [[nodiscard]] const std::vector<std::complex<double>>& variables() const noexcept { return variables_; }
  /// The function f(t) at the time of the contour from s f~(s), s times its Laplace transform, at the variables.
  [[nodiscard]] double function(std::span<const std::complex<double>> times_s) const;

 private:
  double scale_;
  std::vector<std::complex<double>> variables_;
  std::vector<std::complex<double>> growths_;  ///< exp(s t)
  std::vector<std::complex<double>> slopes_;   ///< slopes of the contour
};

}  // namespace breccia

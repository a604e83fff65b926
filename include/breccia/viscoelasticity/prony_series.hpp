#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace breccia {

/// One Maxwell element: modulus * exp(-t / relaxation_time).
struct MaxwellTerm {
  double relaxation_time;  ///< [s], positive
  double modulus;          ///< [Pa]; negative only in PronySeries::difference()

  friend bool operator==(const MaxwellTerm&, const MaxwellTerm&) = default;
};

/// Relaxation modulus as a Prony series: M(t) = M_inf + sum_k M_k exp(-t / tau_k).
/// An elastic modulus is a series without terms.
class PronySeries {
 public:
  PronySeries() = default;
  /// An elastic modulus [Pa].
  explicit PronySeries(double equilibrium) : PronySeries(equilibrium, {}) {}
  /// Takes the equilibrium modulus [Pa] and the terms, which are sorted by falling relaxation time. Throws InputError
  /// when a modulus is negative or not finite, or a relaxation time is not positive and finite.
  PronySeries(double equilibrium, std::vector<MaxwellTerm> terms);

  [[nodiscard]] double equilibrium() const noexcept { return equilibrium_; }
  [[nodiscard]] const std::vector<MaxwellTerm>& terms() const noexcept { return terms_; }
  [[nodiscard]] bool is_elastic() const noexcept { return terms_.empty(); }

  /// Relaxation modulus [Pa] at time t [s], t >= 0.
  [[nodiscard]] double at(double t) const noexcept;
  /// Modulus at t = 0 [Pa].
  [[nodiscard]] double unrelaxed() const noexcept;
  /// Complex modulus M' + i M'' [Pa] at angular frequency omega [rad/s].
  [[nodiscard]] std::complex<double> complex_modulus(double omega) const noexcept;
  /// This series with every relaxation time multiplied by a positive factor (time-temperature superposition).
  [[nodiscard]] PronySeries shifted(double shift_factor) const;
  /// This series with every modulus multiplied by a factor that is not negative.
  [[nodiscard]] PronySeries scaled(double factor) const;
  /// The series without its `slow` slowest terms, whose moduli are added to the equilibrium modulus, and without its
  /// `fast` fastest terms, which are dropped.
  [[nodiscard]] PronySeries truncated(std::size_t slow, std::size_t fast) const;
  /// The sum of two series; terms with the same relaxation time are merged, and those that cancel are dropped.
  [[nodiscard]] static PronySeries sum(const PronySeries& one, const PronySeries& other);
  /// The difference of two series; terms with the same relaxation time are merged. Its terms may be negative, so that
  /// it need not be the modulus of a solid: in plane strain the K(t) = (K + G/3)(t) - G(t)/3 of a composite may rise.
  [[nodiscard]] static PronySeries difference(const PronySeries& whole, const PronySeries& part);

  friend bool operator==(const PronySeries&, const PronySeries&) = default;

 private:
  double equilibrium_ = 0.0;
  std::vector<MaxwellTerm> terms_;
};

}  // namespace breccia

#pragma once

#include <complex>
#include <vector>

namespace breccia {

/// One Kelvin-Voigt element: compliance * (1 - exp(-t / retardation_time)).
struct RetardationTerm {
  double retardation_time;  ///< [s], positive
  double compliance;        ///< [1/Pa], not negative

  friend bool operator==(const RetardationTerm&, const RetardationTerm&) = default;
};

/// Creep compliance as a retardation spectrum: J(t) = J_0 + sum_k J_k (1 - exp(-t / lambda_k)) + phi t.
class CreepCompliance {
 public:
  /// Takes the compliance at t = 0 [1/Pa], the terms, which are sorted by falling retardation time, and the fluidity
  /// phi [1/(Pa s)], which is the rate of steady flow under unit stress. Throws InputError when the compliance at t = 0
  /// or a retardation time is not positive, a term or the fluidity is negative, or a value is not finite.
  CreepCompliance(double instantaneous, std::vector<RetardationTerm> terms, double fluidity = 0.0);

  [[nodiscard]] double instantaneous() const noexcept { return instantaneous_; }
  [[nodiscard]] const std::vector<RetardationTerm>& terms() const noexcept { return terms_; }
  [[nodiscard]] double fluidity() const noexcept { return fluidity_; }

  /// Creep compliance [1/Pa] at time t [s], t >= 0.
  [[nodiscard]] double at(double t) const noexcept;
  /// Complex compliance J' - i J'' [1/Pa] at angular frequency omega [rad/s], omega > 0.
  [[nodiscard]] std::complex<double> complex_compliance(double omega) const noexcept;

  friend bool operator==(const CreepCompliance&, const CreepCompliance&) = default;

 private:
  double instantaneous_;
  std::vector<RetardationTerm> terms_;
  double fluidity_;
};

}  // namespace breccia

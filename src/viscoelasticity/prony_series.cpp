#include "breccia/viscoelasticity/prony_series.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {

PronySeries::PronySeries(double equilibrium, std::vector<MaxwellTerm> terms)
    : equilibrium_(equilibrium), terms_(std::move(terms)) {
  if (!(equilibrium_ >= 0.0) || !std::isfinite(equilibrium_)) {
    throw InputError(
        fmt::format("Prony series: the equilibrium modulus must be finite and not negative, got {} Pa", equilibrium_));
  }
  for (const auto& [relaxation_time, modulus] : terms_) {
    if (!(relaxation_time > 0.0) || !std::isfinite(relaxation_time)) {
      throw InputError(
          fmt::format("Prony series: a relaxation time must be finite and positive, got {} s", relaxation_time));
    }
    if (!(modulus >= 0.0) || !std::isfinite(modulus)) {
      throw InputError(fmt::format("Prony series: a modulus must be finite and not negative, got {} Pa", modulus));
    }
  }
  std::ranges::stable_sort(terms_, std::ranges::greater{}, &MaxwellTerm::relaxation_time);
}

double PronySeries::at(double t) const noexcept {
  double modulus = equilibrium_;
  for (const auto& term : terms_) modulus += term.modulus * std::exp(-t / term.relaxation_time);
  return modulus;
}

double PronySeries::unrelaxed() const noexcept {
  return at(0.0);
}

std::complex<double> PronySeries::complex_modulus(double omega) const noexcept {
  std::complex<double> modulus = equilibrium_;
  for (const auto& term : terms_) {
    const std::complex<double> i_omega_tau(0.0, omega * term.relaxation_time);
    modulus += term.modulus * i_omega_tau / (1.0 + i_omega_tau);
  }
  return modulus;
}

PronySeries PronySeries::shifted(double shift_factor) const {
  auto terms = terms_;
  for (auto& term : terms) term.relaxation_time *= shift_factor;
  return {equilibrium_, std::move(terms)};
}

}  // namespace breccia

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
  auto result = *this;
  for (auto& term : result.terms_) term.relaxation_time *= shift_factor;
  return result;
}

PronySeries PronySeries::scaled(double factor) const {
  auto result = *this;
  result.equilibrium_ *= factor;
  for (auto& term : result.terms_) term.modulus *= factor;
  return result;
}

PronySeries PronySeries::truncated(std::size_t slow, std::size_t fast) const {
  const auto first = terms_.begin() + static_cast<std::ptrdiff_t>(slow);
  const auto last = terms_.end() - static_cast<std::ptrdiff_t>(fast);
  PronySeries result;
  result.equilibrium_ = equilibrium_;
  for (auto term = terms_.begin(); term != first; ++term) result.equilibrium_ += term->modulus;
  result.terms_.assign(first, last);
  return result;
}

namespace {

/// Adds terms times a factor to a list sorted by falling relaxation time.
void add_terms(std::vector<MaxwellTerm>& terms, const std::vector<MaxwellTerm>& added, double factor) {
  for (const auto& [time, modulus] : added) {
    const auto same = std::ranges::find(terms, time, &MaxwellTerm::relaxation_time);
    if (same != terms.end()) {
      same->modulus += factor * modulus;
    } else {
      terms.push_back({time, factor * modulus});
    }
  }
  std::ranges::stable_sort(terms, std::ranges::greater{}, &MaxwellTerm::relaxation_time);
}

}  // namespace

PronySeries PronySeries::sum(const PronySeries& one, const PronySeries& other) {
  PronySeries result = one;
  result.equilibrium_ += other.equilibrium_;
  add_terms(result.terms_, other.terms_, 1.0);
  std::erase_if(result.terms_, [](const MaxwellTerm& term) { return term.modulus == 0.0; });
  return result;
}

PronySeries PronySeries::difference(const PronySeries& whole, const PronySeries& part) {
  PronySeries result = whole;
  result.equilibrium_ -= part.equilibrium_;
  add_terms(result.terms_, part.terms_, -1.0);
  return result;
}

}  // namespace breccia

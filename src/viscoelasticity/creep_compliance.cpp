#include "breccia/viscoelasticity/creep_compliance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {

CreepCompliance::CreepCompliance(double instantaneous, std::vector<RetardationTerm> terms, double fluidity)
    : instantaneous_(instantaneous), terms_(std::move(terms)), fluidity_(fluidity) {
  if (!(instantaneous_ > 0.0) || !std::isfinite(instantaneous_)) {
    throw InputError(fmt::format(
        "creep compliance: the instantaneous compliance must be finite and positive, got {} 1/Pa", instantaneous_));
  }
  if (!(fluidity_ >= 0.0) || !std::isfinite(fluidity_)) {
    throw InputError(
        fmt::format("creep compliance: the fluidity must be finite and not negative, got {} 1/(Pa s)", fluidity_));
  }
  for (const auto& [retardation_time, compliance] : terms_) {
    if (!(retardation_time > 0.0) || !std::isfinite(retardation_time)) {
      throw InputError(
          fmt::format("creep compliance: a retardation time must be finite and positive, got {} s", retardation_time));
    }
    if (!(compliance >= 0.0) || !std::isfinite(compliance)) {
      throw InputError(
          fmt::format("creep compliance: a compliance must be finite and not negative, got {} 1/Pa", compliance));
    }
  }
  std::ranges::stable_sort(terms_, std::ranges::greater{}, &RetardationTerm::retardation_time);
}

double CreepCompliance::at(double t) const noexcept {
  double compliance = instantaneous_ + fluidity_ * t;
  for (const auto& term : terms_) compliance -= term.compliance * std::expm1(-t / term.retardation_time);
  return compliance;
}

std::complex<double> CreepCompliance::complex_compliance(double omega) const noexcept {
  std::complex<double> compliance(instantaneous_, -fluidity_ / omega);
  for (const auto& term : terms_) {
    compliance += term.compliance / std::complex<double>(1.0, omega * term.retardation_time);
  }
  return compliance;
}

}  // namespace breccia

#pragma once

#include <optional>
#include <vector>

#include <pybind11/pybind11.h>

#include "breccia/viscoelasticity/fit.hpp"

#include "fitted_laws.hpp"

namespace breccia::python {

/// A fit with the data that it was made to.
template <class Fit>
struct MeasuredFit {
  Fit fit;
  bool is_dynamic = false;       ///< whether the fit is one to dynamic moduli
  std::vector<double> at;        ///< times [s], or angular frequencies [rad/s]
  std::vector<double> measured;  ///< values at these; of dynamic moduli first all storage, then all loss moduli [Pa]
  std::optional<FittedLaw> law = {};  ///< nothing: a spectrum was fitted
};

/// A fit to dynamic moduli at angular frequencies [rad/s].
MeasuredFit<RelaxationFit> dynamic_fit(RelaxationFit fit, std::vector<double> frequencies, std::vector<double> storage,
                                       const std::vector<double>& loss);

pybind11::tuple state_of(const MeasuredFit<RelaxationFit>& fit);
MeasuredFit<RelaxationFit> relaxation_fit_from(const pybind11::tuple& state);

/// Options of a fit by its arguments. Throws InputError.
FitOptions fit_options(double ramp, double times_per_decade);

/// Adds the fits of Prony series and creep compliances to the module.
void bind_fits(pybind11::module_& module);

}  // namespace breccia::python

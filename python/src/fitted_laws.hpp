#pragma once

#include <optional>
#include <vector>

#include <pybind11/pybind11.h>

#include "breccia/viscoelasticity/law_fit.hpp"

namespace breccia::python {

/// The law that a fit has found in place of a spectrum.
struct FittedLaw {
  LawForm form = LawForm::two_springs_two_parabolas_dashpot;
  std::vector<FittedParameter> parameters = {};
};

/// The law as a table of a deck, with numbers in SI units; None without one.
pybind11::object table_of(const std::optional<FittedLaw>& law);

/// The standard errors of the parameters in their units: 0 where one was not fitted, infinity where the data do not
/// determine it, None where the data are met as well without it; None without a law.
pybind11::object errors_of(const std::optional<FittedLaw>& law);

pybind11::object state_of(const std::optional<FittedLaw>& law);
std::optional<FittedLaw> fitted_law_from(const pybind11::object& state);

}  // namespace breccia::python

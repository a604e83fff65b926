#pragma once

#include <pybind11/pybind11.h>

#include "solution.hpp"

namespace breccia::python {

/// The comparisons of a stage with measurements, a dictionary each.
pybind11::list comparisons_of(const SolvedStage& stage);

/// The thermal expansion of a stage, a dictionary for each boundary and method.
pybind11::list expansions_of(const SolvedStage& stage);

/// The whole stiffness of a stage, a dictionary for each boundary.
pybind11::list stiffness_of(const SolvedStage& stage);

}  // namespace breccia::python

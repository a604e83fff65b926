#pragma once

#include <optional>
#include <string>

#include <pybind11/pybind11.h>

#include "breccia/homogenisation/study_result.hpp"

#include "results/engineering_curves.hpp"

namespace breccia::python {

/// The curves of a stage under a boundary condition, or under the only one that it has. Throws InputError, with the
/// missing tests, where the stage was not tested in shear and in bulk under it.
EngineeringCurves engineering_of(const StageFindings& stage, const std::optional<std::string>& boundary);

/// Adds Young's modulus and Poisson's ratio of stages to the module.
void bind_engineering(pybind11::module_& module);

}  // namespace breccia::python

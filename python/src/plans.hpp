#pragma once

#include <pybind11/pybind11.h>

namespace breccia::python {

/// Adds the classes Plan, StagePlan and TestPlan and the function plan to the module.
void bind_plans(pybind11::module_& module);

}  // namespace breccia::python

#pragma once

#include <pybind11/pybind11.h>

namespace breccia::python {

/// Plan, StagePlan, TestPlan and plan.
void bind_plans(pybind11::module_& module);

}  // namespace breccia::python

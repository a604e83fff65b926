#pragma once

#include <pybind11/pybind11.h>

namespace breccia::python {

/// Adds master curves and their law of shift factors to the module.
void bind_master_curves(pybind11::module_& module);

}  // namespace breccia::python

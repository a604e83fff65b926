#pragma once

#include <pybind11/pybind11.h>

namespace breccia::python {

/// Adds the function calibrate to the module.
void bind_calibrations(pybind11::module_& module);

}  // namespace breccia::python

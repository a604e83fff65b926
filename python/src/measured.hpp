#pragma once

#include <pybind11/pybind11.h>

namespace breccia::python {

/// Adds tables of measured data to the module.
void bind_measured(pybind11::module_& module);

}  // namespace breccia::python

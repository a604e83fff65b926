#pragma once

#include <pybind11/pybind11.h>

namespace breccia::python {

/// Fits of Prony series and of master curves to measured data.
void bind_fits(pybind11::module_& module);

}  // namespace breccia::python

#pragma once

#include <pybind11/pybind11.h>

namespace breccia::python {

/// Tables of measured data.
void bind_measured(pybind11::module_& module);

}  // namespace breccia::python

#pragma once

#include <pybind11/pybind11.h>

namespace breccia::python {

/// Adds the functions for quantities as text, such as "0.5 um", to the module.
void bind_quantities(pybind11::module_& module);

}  // namespace breccia::python

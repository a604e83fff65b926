#pragma once

#include <pybind11/pybind11.h>

namespace breccia::python {

/// Adds material cards of composites, and their moduli over the temperature, to the module.
void bind_exports(pybind11::module_& module);

}  // namespace breccia::python

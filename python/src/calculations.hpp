#pragma once

#include <pybind11/pybind11.h>

namespace breccia::python {

/// Adds the functions solve, pack, run and respond to the module.
void bind_calculations(pybind11::module_& module);

}  // namespace breccia::python

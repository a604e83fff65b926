#pragma once

#include <pybind11/pybind11.h>

namespace breccia::python {

/// solve, pack, run and respond.
void bind_calculations(pybind11::module_& module);

}  // namespace breccia::python

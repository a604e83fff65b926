#pragma once

#include <pybind11/pybind11.h>

namespace breccia::python {

/// Material cards of composites, and their moduli over the temperature.
void bind_exports(pybind11::module_& module);

}  // namespace breccia::python

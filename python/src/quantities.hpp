#pragma once

#include <pybind11/pybind11.h>

namespace breccia::python {

/// Quantities as text: "0.5 um".
void bind_quantities(pybind11::module_& module);

}  // namespace breccia::python

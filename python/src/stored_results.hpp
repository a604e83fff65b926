#pragma once

#include <pybind11/pybind11.h>

namespace breccia::python {

/// Adds the readers of the results of earlier runs to the module.
void bind_stored_results(pybind11::module_& module);

}  // namespace breccia::python

#pragma once

#include <pybind11/pybind11.h>

namespace breccia::python {

/// Adds the results of studies, of their stages, and of tests to the module.
void bind_results(pybind11::module_& module);

}  // namespace breccia::python

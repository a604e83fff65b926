#pragma once

#include <pybind11/pybind11.h>

namespace breccia::python {

/// Results of studies, of their stages, and of tests.
void bind_results(pybind11::module_& module);

}  // namespace breccia::python

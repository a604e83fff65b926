#pragma once

#include <pybind11/pybind11.h>

namespace breccia::python {

/// Results of earlier runs, from their directories.
void bind_stored_results(pybind11::module_& module);

}  // namespace breccia::python

#pragma once

#include <pybind11/pybind11.h>

namespace breccia::python {

/// Adds the readers of studies from decks to the module.
void bind_studies(pybind11::module_& module);

}  // namespace breccia::python

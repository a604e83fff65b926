#pragma once

#include <pybind11/pybind11.h>

namespace breccia::python {

/// Studies from decks.
void bind_studies(pybind11::module_& module);

}  // namespace breccia::python

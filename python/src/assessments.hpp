#pragma once

#include <pybind11/pybind11.h>

namespace breccia::python {

/// Adds the assessment of studies whose inputs are not all certain to the module.
void bind_assessments(pybind11::module_& module);

}  // namespace breccia::python

#pragma once

#include <pybind11/pybind11.h>

namespace breccia::python {

/// The fields of a test, a TestResult, at its field times: a dictionary of arrays each. Those of cells are views.
pybind11::list fields_of_test(const pybind11::object& test);

}  // namespace breccia::python

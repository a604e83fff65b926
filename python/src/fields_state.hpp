#pragma once

#include <pybind11/pybind11.h>

#include "breccia/virtual_test/test_fields.hpp"

namespace breccia::python {

// The fields of a test for pickle.
pybind11::tuple state_of_fields(const TestFields& fields);
TestFields fields_from(const pybind11::tuple& state);

}  // namespace breccia::python

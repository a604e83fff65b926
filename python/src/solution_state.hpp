#pragma once

#include <memory>

#include <pybind11/pybind11.h>

#include "solution.hpp"

namespace breccia::python {

// The content of a solution for pickle: everything that Python shows, and the reduced responses. What a test has
// recorded of its own computation beside its error and wall time is left out.
pybind11::dict state_of_solution(const Solution& solution);
std::shared_ptr<Solution> solution_from(const pybind11::dict& state);

}  // namespace breccia::python

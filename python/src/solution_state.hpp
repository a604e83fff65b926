#pragma once

#include <memory>

#include <pybind11/pybind11.h>

#include "solution.hpp"

namespace breccia::python {

// The content of results for pickle: everything that Python shows, and of a whole solution the reduced responses. The
// record of the computation of a test is left out, except for its error and wall time.
pybind11::dict state_of_test(const TestResult& test);
TestResult test_from(const pybind11::dict& state);
pybind11::dict state_of_stage(const SolvedStage& stage);
SolvedStage stage_from(const pybind11::dict& state);
pybind11::dict state_of_solution(const Solution& solution);
std::shared_ptr<Solution> solution_from(const pybind11::dict& state);

}  // namespace breccia::python
